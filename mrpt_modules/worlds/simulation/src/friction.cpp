// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulation/vehicle_model.h>

namespace traverse::simulation
{
double frictionOf(Material material)
{
  switch (material)
  {
    case Material::asphalt:
    case Material::concrete:
      return 0.8;
    case Material::brick:
      return 0.7;
    case Material::soil:
      return 0.68;
    case Material::wood:
      return 0.5;
    case Material::grass:
    case Material::metal:
    case Material::glass:
    case Material::cloth:
      return 0.4;
    case Material::foliage:
      return 0.35;
    case Material::snow:
      return 0.2;
    case Material::ice:
      return 0.1;
  }
  return 0;
}
}  // namespace traverse::simulation
