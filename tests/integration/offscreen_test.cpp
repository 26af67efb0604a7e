// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures drawn with no display: colours at known places.
#include <traverse/formats/safe_file.h>
#include <traverse/rendering/offscreen.h>

#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/Visualizable.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <support/scratch_folder.h>
#include <thread>

// MRPT's class has no virtual destructor; ours is final and never deleted through it.
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"

namespace
{
using namespace traverse::rendering;
using traverse::formats::Raster;
using traverse::layers::Colour;

constexpr Colour kRed = {220, 30, 40};
constexpr Colour kGreen = {30, 180, 60};
constexpr Colour kBlue = {40, 70, 210};
constexpr Colour kGround = {236, 239, 243};  // SceneContent's background

/** Squares of one colour, given by their lower left corners. */
class Squares final : public mrpt::opengl::Visualizable
{
 public:
  void add(const Eigen::Vector3d& corner, double side, Colour colour)
  {
    squares_.push_back({corner, side, colour});
  }

  void getVisualizationInto(mrpt::opengl::CSetOfObjects& out) const override
  {
    for (const Square& s : squares_)
    {
      auto triangles = mrpt::opengl::CSetOfTriangles::Create();
      const auto side = static_cast<float>(s.side);
      for (const bool upper : {false, true})
      {
        mrpt::opengl::TTriangle t;
        t.vertices[0].xyzrgba.pt = {0, 0, 0};
        t.vertices[1].xyzrgba.pt = {side, upper ? side : 0, 0};
        t.vertices[2].xyzrgba.pt = {upper ? 0 : side, side, 0};
        t.setColor(mrpt::img::TColor(s.colour.r, s.colour.g, s.colour.b));
        t.computeNormals();
        triangles->insertTriangle(t);
      }
      triangles->setLocation(s.corner.x(), s.corner.y(), s.corner.z());
      out.insert(triangles);
    }
  }

 private:
  struct Square
  {
    Eigen::Vector3d corner;
    double side;
    Colour colour;
  };

  std::vector<Square> squares_;
};

/** Red at the lower left, green at the lower right (higher up), blue at the upper left; nothing at
 * the upper right. From (x, y) on, 4 m in all. */
Squares threeSquares(double x = 0, double y = 0)
{
  Squares squares;
  squares.add({x, y, 0}, 2, kRed);
  squares.add({x + 2, y, 1.5}, 2, kGreen);
  squares.add({x, y + 2, -0.5}, 2, kBlue);
  return squares;
}

SceneContent contentOf(const Squares& squares)
{
  SceneContent content;
  content.maps = {&squares};
  return content;
}

/** Colours pass through the graphics in float: one step of 255 may be lost. */
::testing::AssertionResult isColour(const Raster& r, size_t column, size_t row, Colour c)
{
  const Colour p = r.at(column, row);
  const auto near = [](int a, int b) { return std::abs(a - b) <= 1; };
  if (near(p.r, c.r) && near(p.g, c.g) && near(p.b, c.b))
  {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << "pixel (" << column << ", " << row << ") is " << int{p.r} << " " << int{p.g} << " "
         << int{p.b} << ", not " << int{c.r} << " " << int{c.g} << " " << int{c.b};
}

const Overlay no_overlay{"", {}, false};

class Offscreen : public ::testing::Test
{
 protected:
  static void SetUpTestSuite() { ::unsetenv("DISPLAY"); }
};

TEST_F(Offscreen, TopViewHasXToTheRightAndYUpInTheObjectsColours)
{
  const Squares squares = threeSquares();
  const Raster r = renderTopView(contentOf(squares), no_overlay, {400, 400}, Area{0, 0, 4, 4});
  ASSERT_EQ(r.width, 400U);
  ASSERT_EQ(r.height, 400U);
  EXPECT_TRUE(isColour(r, 100, 300, kRed));
  EXPECT_TRUE(isColour(r, 300, 300, kGreen));
  EXPECT_TRUE(isColour(r, 100, 100, kBlue));
  EXPECT_TRUE(isColour(r, 300, 100, kGround));
}

TEST_F(Offscreen, TopViewHasTheScaleItSays)
{
  const Squares squares = threeSquares();
  // 8 m x 4 m in 800 x 400: 100 pixels a metre; edges may be off by one pixel of smoothing.
  const Raster r = renderTopView(contentOf(squares), no_overlay, {800, 400}, Area{-2, -1, 6, 3});
  EXPECT_TRUE(isColour(r, 198, 200, kGround));
  EXPECT_TRUE(isColour(r, 201, 200, kRed));
  EXPECT_TRUE(isColour(r, 398, 200, kRed));
  EXPECT_TRUE(isColour(r, 401, 200, kGreen));
  EXPECT_TRUE(isColour(r, 598, 200, kGreen));
  EXPECT_TRUE(isColour(r, 601, 200, kGround));
  EXPECT_TRUE(isColour(r, 300, 298, kRed));
  EXPECT_TRUE(isColour(r, 300, 301, kGround));
  EXPECT_TRUE(isColour(r, 300, 98, kBlue));
}

TEST_F(Offscreen, TopViewKeepsTheScaleEqualInTallPictures)
{
  const Squares squares = threeSquares();
  // 4 m in 200 pixels of width: 50 a metre; the height shows 8 m, centred at y = 2.
  const Raster r = renderTopView(contentOf(squares), no_overlay, {200, 400}, Area{0, 0, 4, 4});
  EXPECT_TRUE(isColour(r, 50, 98, kGround));
  EXPECT_TRUE(isColour(r, 50, 102, kBlue));
  EXPECT_TRUE(isColour(r, 50, 298, kRed));
  EXPECT_TRUE(isColour(r, 50, 302, kGround));
}

TEST_F(Offscreen, AnySizeWillDo)
{
  const Squares squares = threeSquares();
  for (const int width : {1, 2, 3, 5, 333, 641, 642, 1281})
  {
    const Raster r = renderTopView(contentOf(squares), no_overlay, {width, 333}, Area{0, 0, 4, 4});
    ASSERT_EQ(r.width, static_cast<size_t>(width));
    ASSERT_EQ(r.height, 333U);
    const auto w = static_cast<size_t>(width);
    if (w >= 333)
    {
      EXPECT_TRUE(isColour(r, w / 2 - 3, 333 / 2 + 3, kRed)) << width;
      EXPECT_TRUE(isColour(r, w / 2 + 3, 333 / 2 + 3, kGreen)) << width;
      EXPECT_TRUE(isColour(r, w / 2 - 3, 333 / 2 - 3, kBlue)) << width;
    }
  }
}

TEST_F(Offscreen, SizesThatCannotBeAreRefused)
{
  const Squares squares = threeSquares();
  EXPECT_THROW(renderTopView(contentOf(squares), no_overlay, {0, 10}), RenderError);
  EXPECT_THROW(renderTopView(contentOf(squares), no_overlay, {10, 5000}), RenderError);
  EXPECT_THROW(
      renderTopView(contentOf(squares), no_overlay, {10, 10}, Area{0, 0, 0, 4}), RenderError);
}

TEST_F(Offscreen, SamePictureAgainAndFromAnotherThread)
{
  const Squares squares = threeSquares();
  const auto bytes = [&] {
    return png(renderTopView(contentOf(squares), {"title", {}, true}, {320, 240}));
  };
  const std::string first = bytes();
  EXPECT_EQ(bytes(), first);
  std::string other;
  std::thread([&] { other = bytes(); }).join();
  EXPECT_EQ(other, first);
}

TEST_F(Offscreen, FarFromTheOriginThePictureIsTheSame)
{
  const Squares far = threeSquares(1e7, -1e7);
  const Raster r =
      renderTopView(contentOf(far), no_overlay, {400, 400}, Area{1e7, -1e7, 1e7 + 4, -1e7 + 4});
  EXPECT_TRUE(isColour(r, 197, 203, kRed));
  EXPECT_TRUE(isColour(r, 203, 203, kGreen));
  EXPECT_TRUE(isColour(r, 197, 197, kBlue));
  EXPECT_TRUE(isColour(r, 203, 197, kGround));
}

TEST_F(Offscreen, TheWholeMapIsInThePictureByDefault)
{
  const Squares squares = threeSquares(-30, 70);
  const Raster r = renderTopView(contentOf(squares), no_overlay, {400, 400});
  EXPECT_TRUE(isColour(r, 12, 388, kRed));
  EXPECT_TRUE(isColour(r, 2, 398, kGround));
  EXPECT_TRUE(isColour(r, 388, 388, kGreen));
  EXPECT_TRUE(isColour(r, 12, 12, kBlue));
}

TEST_F(Offscreen, RobotAxesAreDrawnOverTheMap)
{
  Squares squares;
  squares.add({-5, -5, 3}, 10, kGround);  // above the robot
  SceneContent content = contentOf(squares);
  content.T_map_base =
      Eigen::Translation3d(1, 1, 0) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  content.axes_length_m = 3;
  const Raster r = renderTopView(content, no_overlay, {400, 400}, Area{-4, -4, 4, 4});
  const Colour x_axis = r.at(250, 150 - 60);  // 1.2 m along the robot's x, which is the map's y
  EXPECT_GT(x_axis.r, x_axis.g + 80);
  EXPECT_GT(x_axis.r, x_axis.b + 80);
  const Colour y_axis = r.at(250 - 60, 150);  // the robot's y is the map's -x
  EXPECT_GT(y_axis.g, y_axis.r + 80);
}

TEST_F(Offscreen, TrajectoryAndScanPointsAreDrawn)
{
  const Squares squares = threeSquares();
  SceneContent content = contentOf(squares);
  content.trajectory = {{0, 1, 0}, {4, 1, 0}};
  content.scans.push_back({{{3, 3, 0}}, {200, 0, 200}, 12});
  const Raster r = renderTopView(content, no_overlay, {400, 400}, Area{0, 0, 4, 4});
  EXPECT_LT(r.at(100, 299).r, 60) << "the line is dark";
  EXPECT_TRUE(isColour(r, 300, 100, {200, 0, 200}));
}

TEST_F(Offscreen, LegendAndScaleBarAreWrittenOverIt)
{
  const Squares squares = threeSquares();
  const Raster plain = renderTopView(contentOf(squares), no_overlay, {640, 480});
  const Raster r =
      renderTopView(contentOf(squares), {"a title", {{1, "flat", {1, 200, 2}}}, true}, {640, 480});
  EXPECT_TRUE(isColour(r, 35, 59, {1, 200, 2})) << "the swatch of the first entry";
  size_t changed = 0;
  for (size_t i = 0; i < r.pixels.size(); ++i)
  {
    changed += static_cast<size_t>(r.pixels[i].g != plain.pixels[i].g);
  }
  EXPECT_LT(changed, r.pixels.size() / 4) << "most of the map stays to be seen";
}

TEST_F(Offscreen, PerspectiveShowsTheMapInTheMiddle)
{
  const Squares squares = threeSquares();
  Viewpoint above;
  above.target = {2, 2, 0};
  above.distance_m = 12;
  above.azimuth_deg = -90;
  above.elevation_deg = 89;
  const Raster r = renderPerspective(contentOf(squares), no_overlay, {400, 400}, above);
  EXPECT_GT(r.at(150, 250).r, r.at(150, 250).b + 50) << "red is at the lower left";
  EXPECT_GT(r.at(150, 150).b, r.at(150, 150).r + 50) << "blue is at the upper left";
  EXPECT_TRUE(isColour(r, 2, 2, kGround));
}

TEST_F(Offscreen, NothingToShowIsAPictureToo)
{
  EXPECT_TRUE(isColour(renderTopView({}, no_overlay, {64, 64}), 32, 32, kGround));
  EXPECT_TRUE(isColour(renderPerspective({}, no_overlay, {64, 64}), 32, 32, kGround));
}

TEST_F(Offscreen, SceneFilesAreReadByMrptAndTheSameEachTime)
{
  const Squares squares = threeSquares();
  SceneContent content = contentOf(squares);
  content.T_map_base = Eigen::Isometry3d::Identity();
  const std::string bytes = sceneFile(content);
  EXPECT_EQ(sceneFile(content), bytes);
  const traverse::testing::ScratchFolder folder;
  const auto path = folder.path() / "map.3Dscene";
  traverse::formats::writeFile(path, bytes);
  mrpt::opengl::COpenGLScene scene;
  ASSERT_TRUE(scene.loadFromFile(path.string()));
  const auto second = scene.getByClass<mrpt::opengl::CSetOfTriangles>(1);
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(second->getPose().x, 2);
  mrpt::opengl::TTriangle triangle;
  second->getTriangle(0, triangle);
  EXPECT_EQ(triangle.r(0), kGreen.r);
  EXPECT_NE(scene.getByClass<mrpt::opengl::CSetOfTriangles>(2), nullptr) << "all three squares";
}
}  // namespace
