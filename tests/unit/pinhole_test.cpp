// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/sensors/pinhole.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{
using traverse::sensors::Pinhole;

Pinhole camera()
{
  Pinhole c;
  c.columns = 640;
  c.rows = 480;
  c.fx_px = 500;
  c.fy_px = 510;
  c.cx_px = 320;
  c.cy_px = 240;
  return c;
}

TEST(Pinhole, SeesAPointWhereSimilarTrianglesSay)
{
  const auto pixel = project(camera(), {0.2, -0.1, 2});
  ASSERT_TRUE(pixel);
  EXPECT_DOUBLE_EQ(pixel->x(), 320 + 500 * 0.1);
  EXPECT_DOUBLE_EQ(pixel->y(), 240 - 510 * 0.05);
}

TEST(Pinhole, SeesNothingBehindItself)
{
  EXPECT_FALSE(project(camera(), {0, 0, 0}));
  EXPECT_FALSE(project(camera(), {0, 0, -1}));
  EXPECT_FALSE(project(camera(), {0, 0, std::numeric_limits<double>::quiet_NaN()}));
}

TEST(Pinhole, RayAndProjectionAreInversesWithDistortion)
{
  Pinhole c = camera();
  c.distortion = {-0.25, 0.08, 1e-3, -5e-4, 0.002, 0, 0, 0};
  for (const double u : {0.0, 100.5, 320.0, 639.0})
  {
    for (const double v : {0.0, 240.0, 479.0})
    {
      const auto r = ray(c, u, v);
      ASSERT_TRUE(r);
      const auto back = project(c, 3 * *r);
      // The iteration stops below 1e-9 of the focal length of 510 px; near a lens' edge an error
      // shrinks by a factor of 2 at most per step.
      EXPECT_NEAR(back->x(), u, 1e-5);
      EXPECT_NEAR(back->y(), v, 1e-5);
    }
  }
}

TEST(Pinhole, HasNoRayWhereTheLensModelDoesNotHold)
{
  Pinhole c = camera();
  c.distortion[0] = -5;
  EXPECT_FALSE(ray(c, 0, 0));
}

TEST(Pinhole, KnowsACameraFromNone)
{
  EXPECT_TRUE(camera().valid());
  EXPECT_FALSE(Pinhole().valid());
  Pinhole c = camera();
  c.cx_px = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(c.valid());
}
}  // namespace
