// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

namespace traverse::observations
{
/** The cause in one line of at most 160 characters: MRPT's exceptions have a frame around it and a
 * call stack behind it. */
std::string causeOf(const std::exception& e);
}  // namespace traverse::observations
