// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/options/ini_text.h>

#include <fmt/format.h>

namespace traverse::options
{
std::string commentedSection(
    std::string_view meaning, std::string_view name, const std::vector<Row>& options)
{
  std::string text = fmt::format("\n// {}\n[{}]\n", meaning, name);
  for (const Row& row : options)
  {
    text += fmt::format("// {} ({})\n{} = {}\n", row.meaning, row.allowed, row.key, row.value);
  }
  return text;
}
}  // namespace traverse::options
