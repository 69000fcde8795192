// SPDX-License-Identifier: MIT
// The precompiled headers of the window need one source file.
