// SPDX-License-Identifier: MIT
// Built with the precompiled headers that the test programs of the window share.
