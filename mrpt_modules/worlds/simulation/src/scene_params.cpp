// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulation/scene_params.h>

namespace traverse::simulation
{
std::string numberedSection(const std::string& prefix, size_t index)
{
  return prefix + (index < 10 ? "0" : "") + std::to_string(index);
}
}  // namespace traverse::simulation
