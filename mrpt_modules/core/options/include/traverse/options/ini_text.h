// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <string>
#include <string_view>
#include <vector>

namespace traverse::options
{
/** A section of an ini with every option at its value, each under a comment with its meaning and
 * what is allowed; the section's own meaning before it. */
std::string commentedSection(
    std::string_view meaning, std::string_view name, const std::vector<Row>& options);
}  // namespace traverse::options
