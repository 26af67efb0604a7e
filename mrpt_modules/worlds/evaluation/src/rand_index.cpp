// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/evaluation/rand_index.h>

#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace traverse::evaluation
{
namespace
{
double pairsOf(double n)
{
  return n * (n - 1) / 2;
}

template <class Groups>
double pairsWithin(const Groups& groups)
{
  double pairs = 0;
  for (const auto& [name, n] : groups)
  {
    pairs += pairsOf(static_cast<double>(n));
  }
  return pairs;
}
}  // namespace

double adjustedRandIndex(std::span<const uint32_t> a, std::span<const uint32_t> b)
{
  if (a.size() != b.size())
  {
    throw std::invalid_argument("labelings of different length");
  }
  if (a.size() < 2)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::map<uint32_t, uint64_t> of_a;
  std::map<uint32_t, uint64_t> of_b;
  std::map<std::pair<uint32_t, uint32_t>, uint64_t> of_both;
  for (size_t i = 0; i < a.size(); ++i)
  {
    ++of_a[a[i]];
    ++of_b[b[i]];
    ++of_both[{a[i], b[i]}];
  }
  const double in_a = pairsWithin(of_a);
  const double in_b = pairsWithin(of_b);
  const double by_chance = in_a * in_b / pairsOf(static_cast<double>(a.size()));
  const double at_most = (in_a + in_b) / 2;
  return at_most == by_chance ? 1 : (pairsWithin(of_both) - by_chance) / (at_most - by_chance);
}
}  // namespace traverse::evaluation
