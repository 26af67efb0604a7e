// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace traverse::simulating
{
/** Every section that a scene file may have, each key at its default with its meaning behind it;
 * an ini that can be simulated. */
std::string defaultsText();
}  // namespace traverse::simulating
