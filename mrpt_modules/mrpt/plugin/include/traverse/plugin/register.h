// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace traverse::plugin
{
/** Makes all our map classes known to MRPT's class and map factories (and MRPT's own map classes,
 * which a linker that drops unused libraries leaves out). Loading libtraverse_maps.so does it too;
 * a program that links the library calls this, so that it is really loaded. May be called again. */
void registerAllMaps();
}  // namespace traverse::plugin
