// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace traverse::geometry
{
/** Quotient and remainder of floorDiv and floorMod. */
struct FloorQuotient
{
  int64_t quotient = 0;
  int64_t remainder = 0;  //!< in [0, divisor)
};

/** floorDiv by one divisor many times: a multiplication and an exact correction take the place of
 * the processor's slow division. |dividend| < 2^50, 0 < divisor < 2^31. */
class FloorDivider
{
 public:
  explicit FloorDivider(int64_t divisor) :
      divisor_(divisor), inverse_(1.0 / static_cast<double>(divisor))
  {
  }

  FloorQuotient operator()(int64_t dividend) const
  {
    // Truncation is off by one at most below zero, rounding by one at most either way.
    auto quotient = static_cast<int64_t>(static_cast<double>(dividend) * inverse_);
    int64_t remainder = dividend - quotient * divisor_;
    const auto too_high = static_cast<int64_t>(remainder < 0);
    const auto too_low = static_cast<int64_t>(remainder >= divisor_);
    quotient += too_low - too_high;
    remainder += (too_high - too_low) * divisor_;
    return {quotient, remainder};
  }

 private:
  int64_t divisor_;
  double inverse_;
};
}  // namespace traverse::geometry
