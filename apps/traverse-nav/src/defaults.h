// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace traverse::app
{
/** Every section of traverse-nav's ini, each key at its default with its meaning; maps' sections
 * are those of traverse-map --print-defaults. */
std::string navDefaultsText();
}  // namespace traverse::app
