// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>
#include <traverse/simulation/labels.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

// Labels and materials as options of scenes. Most kinds of things have ones of their own, so that
// the options know one value more: "usual".
namespace traverse::simulation
{
/** A Label, or the one that the kind usually has; 0 is "usual", n + 1 the label n. */
enum class LabelChoice : uint16_t
{
  usual = 0
};

/** A Material, or the one that the kind usually has; 0 is "usual", n + 1 the material n. */
enum class MaterialChoice : uint8_t
{
  usual = 0
};

constexpr LabelChoice choose(Label label)
{
  return static_cast<LabelChoice>(static_cast<uint16_t>(label) + 1);
}

constexpr MaterialChoice choose(Material material)
{
  return static_cast<MaterialChoice>(static_cast<uint8_t>(material) + 1);
}

constexpr Label chosenOr(LabelChoice choice, Label usual)
{
  return choice == LabelChoice::usual ? usual
                                      : static_cast<Label>(static_cast<uint16_t>(choice) - 1);
}

constexpr Material chosenOr(MaterialChoice choice, Material usual)
{
  return choice == MaterialChoice::usual ? usual
                                         : static_cast<Material>(static_cast<uint8_t>(choice) - 1);
}

namespace detail
{
template <class Choice, class Value, size_t n>
std::array<std::pair<Choice, std::string_view>, n + 1> choiceNames()
{
  std::array<std::pair<Choice, std::string_view>, n + 1> names;
  names[0] = {Choice::usual, "usual"};
  for (size_t i = 0; i < n; ++i)
  {
    const auto value = static_cast<Value>(i);
    names[i + 1] = {choose(value), nameOf(value)};
  }
  return names;
}
}  // namespace detail
}  // namespace traverse::simulation

template <>
struct traverse::options::EnumNames<traverse::simulation::LabelChoice>
{
  static inline const auto kNames = traverse::simulation::detail::choiceNames<
      traverse::simulation::LabelChoice,
      traverse::simulation::Label,
      traverse::simulation::kLabels>();
};

template <>
struct traverse::options::EnumNames<traverse::simulation::MaterialChoice>
{
  static inline const auto kNames = traverse::simulation::detail::choiceNames<
      traverse::simulation::MaterialChoice,
      traverse::simulation::Material,
      traverse::simulation::kMaterials>();
};
