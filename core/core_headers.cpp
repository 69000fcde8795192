// SPDX-License-Identifier: MIT
// The precompiled headers of core need one source file.
