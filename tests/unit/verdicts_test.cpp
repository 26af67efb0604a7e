// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/evaluation/verdicts.h>

#include <gtest/gtest.h>

#include <support/judged_maps.h>

namespace
{
using namespace traverse;
using namespace traverse::evaluation;
using namespace traverse::testing;

TEST(Verdicts, TellTheKindOfError)
{
  const layers::LayerSet set = verdicts(
      mapOf({"14113.4"}, {"9999992"}),  //
      truthOf({"1143214"}));
  EXPECT_EQ(
      std::get<std::vector<uint8_t>>(set.find("verdict")->data),
      (std::vector<uint8_t>{1, 3, 2, 4, 5, 6, 0}));
  EXPECT_EQ(set.class_layer, "verdict");
  EXPECT_EQ(set.legend.size(), 7U);
}
}  // namespace
