// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the buffer without and with strips, as in figure 6 of paper 5, in the build folder.
#include <traverse/formats/png.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <support/buffer_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using layers::StripRule;

constexpr int32_t kEdge = 240;

/** A bent tunnel, a ragged one, two posts, a box and an L. */
BufferScene street()
{
  BufferScene scene(kEdge);
  const Corridor slanted{{70, 190}, 25, 22, 80, 3};
  const Corridor upright{{190, 60}, 90, 24, 70, 3};
  scene.add([&](Place p) { return slanted.isWall(p) || upright.isWall(p); });
  std::mt19937 random(6);
  std::vector<double> teeth(2 * kEdge);
  std::generate(teeth.begin(), teeth.end(), [&] { return static_cast<double>(random() % 5) - 2; });
  scene.add(
      [&](Place p)
      {
        const double y = p.y - 70 - 14 * geometry::sinCosOf(p.x / 20).sin;
        const size_t tooth = 2 * static_cast<size_t>(p.x) + (y > 0 ? 1 : 0);
        return p.x > 20 && p.x < 140 && std::abs(y) > 13 + teeth[tooth] && std::abs(y) < 18;
      });
  scene.add([](Place p) { return std::abs(p.x - 170) < 12 && std::abs(p.y - 150) < 8; });
  scene.add(
      [](Place p)
      {
        const double x = p.x - 200;
        const double y = p.y - 190;
        return x > 0 && y > 0 && x < 30 && y < 30 && (x < 4 || y < 4);
      });
  scene.add(
      [](Place p) {
        return p.y > 120 && p.y < 122 && (p.x - 100) * (p.x - 122) > -40 && p.x > 96 && p.x < 126;
      });
  return scene;
}

formats::Raster picture(const BufferScene& scene, StripRule strip)
{
  // Free, soft, hard, strip; obstacles black.
  constexpr std::array<layers::Colour, 4> kColours = {
      {{255, 255, 255}, {255, 224, 130}, {229, 115, 115}, {56, 142, 60}}};
  constexpr size_t kScale = 3;
  const std::vector<uint8_t> zones = scene.buffer({.strip = strip});
  formats::Raster raster(kEdge * kScale, kEdge * kScale);
  for (size_t y = 0; y < raster.height; ++y)
  {
    for (size_t x = 0; x < raster.width; ++x)
    {
      const size_t cell = scene.index(
          static_cast<int32_t>(x / kScale), kEdge - 1 - static_cast<int32_t>(y / kScale));
      raster.at(x, y) = scene.states()[cell] == 2 ? layers::Colour{} : kColours[zones[cell]];
    }
  }
  return raster;
}

TEST(SafetyBufferPictures, AreWritten)
{
  const BufferScene scene = street();
  const auto folder = std::filesystem::path(TRAVERSE_BINARY_DIR) / "pictures";
  std::filesystem::create_directories(folder);
  for (const auto& [name, strip] :
       {std::pair{"none", StripRule::none},
        {"default", StripRule::standard},
        {"paper", StripRule::paper}})
  {
    const auto file = folder / ("safety_buffer_strip_" + std::string(name) + ".png");
    std::ofstream(file, std::ios::binary) << formats::png(picture(scene, strip));
    EXPECT_GT(std::filesystem::file_size(file), 1000U) << file;
  }
}
}  // namespace
