// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/gif.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <gif_lib.h>
#include <stdexcept>
#include <string>

namespace
{
using namespace traverse;

formats::Raster plain(layers::Colour colour)
{
  return formats::Raster(7, 5, colour);
}

struct Bytes
{
  std::string text;
  size_t read = 0;
};

int readBytes(GifFileType* file, GifByteType* to, int count)
{
  auto& from = *static_cast<Bytes*>(file->UserData);
  const size_t got =
      from.text.copy(reinterpret_cast<char*>(to), static_cast<size_t>(count), from.read);
  from.read += got;
  return static_cast<int>(got);
}

TEST(AnimatedGif, IsReadBackByGiflibWithItsColours)
{
  formats::AnimatedGif film(7, 5, 20);
  film.add(plain({255, 0, 51}));
  film.add(plain({120, 120, 120}));
  Bytes bytes{film.take()};
  int error = 0;
  GifFileType* file = DGifOpen(&bytes, &readBytes, &error);
  ASSERT_NE(file, nullptr);
  ASSERT_EQ(DGifSlurp(file), GIF_OK);
  ASSERT_EQ(file->ImageCount, 2);
  const auto colour = [&](int image)
  { return file->SColorMap->Colors[file->SavedImages[image].RasterBits[12]]; };
  EXPECT_EQ(colour(0).Red, 255);
  EXPECT_EQ(colour(0).Green, 0);
  EXPECT_EQ(colour(0).Blue, 51);
  EXPECT_NEAR(colour(1).Red, 120, 4);  // 40 greys lie 6 apart
  EXPECT_EQ(colour(1).Red, colour(1).Blue);
  GraphicsControlBlock control{};
  ASSERT_EQ(DGifSavedExtensionToGCB(file, 1, &control), GIF_OK);
  EXPECT_EQ(control.DelayTime, 20);
  DGifCloseFile(file, &error);
}

TEST(AnimatedGif, TheSamePicturesGiveTheSameBytes)
{
  const auto make = []
  {
    formats::AnimatedGif film(7, 5, 1);
    film.add(plain({1, 2, 3}));
    return film.take();
  };
  EXPECT_EQ(make(), make());
}

TEST(AnimatedGif, RefusesOtherSizes)
{
  EXPECT_THROW(formats::AnimatedGif(0, 5, 1), std::invalid_argument);
  EXPECT_THROW(formats::AnimatedGif(5, 70000, 1), std::invalid_argument);
  formats::AnimatedGif film(8, 5, 1);
  EXPECT_THROW(film.add(plain({1, 2, 3})), std::invalid_argument);
}
}  // namespace
