// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/gif.h>

#include <algorithm>
#include <array>
#include <gif_lib.h>
#include <stdexcept>
#include <utility>
#include <vector>

namespace traverse::formats
{
namespace
{
constexpr int kSteps = 6;  // of a colour's channel
constexpr int kCube = kSteps * kSteps * kSteps;
constexpr int kColours = 256;
constexpr int kLongest = 65535;

int write(GifFileType* file, const GifByteType* bytes, int count)
{
  static_cast<std::string*>(file->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<size_t>(count));
  return count;
}

/** The cube, then greys between black and white. */
std::array<GifColorType, kColours> palette()
{
  std::array<GifColorType, kColours> colours{};
  for (int i = 0; i < kCube; ++i)
  {
    const auto channel = [](int step) { return static_cast<GifByteType>(step * 51); };
    colours[static_cast<size_t>(i)] = {
        channel(i / 36), channel(i / kSteps % kSteps), channel(i % kSteps)};
  }
  for (int i = kCube; i < kColours; ++i)
  {
    const auto grey = static_cast<GifByteType>((i - kCube + 1) * 255 / (kColours - kCube + 1));
    colours[static_cast<size_t>(i)] = {grey, grey, grey};
  }
  return colours;
}

GifByteType indexOf(const layers::Colour& colour)
{
  const bool is_grey = colour.r == colour.g && colour.g == colour.b;
  if (is_grey && colour.r > 3 && colour.r < 252)
  {
    const int step = colour.r * (kColours - kCube + 1) / 255;
    return static_cast<GifByteType>(kCube + std::max(step, 1) - 1);
  }
  const auto step = [](int value) { return (value + 25) / 51; };
  return static_cast<GifByteType>(step(colour.r) * 36 + step(colour.g) * kSteps + step(colour.b));
}
}  // namespace

class AnimatedGif::Impl
{
 public:
  Impl(int width_px, int height_px, int delay_cs) :
      width_(width_px), height_(height_px), delay_cs_(delay_cs)
  {
    int error = 0;
    file_ = EGifOpen(&bytes_, &write, &error);
    if (file_ == nullptr)
    {
      throw std::runtime_error("giflib cannot begin a picture");
    }
    const auto colours = palette();
    ColorMapObject* map = GifMakeMapObject(kColours, colours.data());
    EGifSetGifVersion(file_, true);
    const int put = EGifPutScreenDesc(file_, width_px, height_px, 8, 0, map);
    GifFreeMapObject(map);
    require(put);
    putRepeat();
  }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  ~Impl() { close(); }

  void add(const Raster& picture)
  {
    if (picture.width != static_cast<size_t>(width_) ||
        picture.height != static_cast<size_t>(height_))
    {
      throw std::invalid_argument("a picture of another size than the film's");
    }
    GraphicsControlBlock control{DISPOSE_DO_NOT, false, delay_cs_, NO_TRANSPARENT_COLOR};
    std::array<GifByteType, 4> extension{};
    EGifGCBToExtension(&control, extension.data());
    require(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, extension.size(), extension.data()));
    require(EGifPutImageDesc(file_, 0, 0, width_, height_, false, nullptr));
    std::vector<GifByteType> row(picture.width);
    for (size_t y = 0; y < picture.height; ++y)
    {
      for (size_t x = 0; x < picture.width; ++x)
      {
        row[x] = indexOf(picture.at(x, y));
      }
      require(EGifPutLine(file_, row.data(), width_));
    }
  }

  std::string take()
  {
    close();
    return std::move(bytes_);
  }

 private:
  static void require(int result)
  {
    if (result != GIF_OK)
    {
      throw std::runtime_error("giflib cannot write the picture");
    }
  }

  /** Netscape's extension: repeat for ever. */
  void putRepeat()
  {
    const std::array<GifByteType, 3> for_ever = {1, 0, 0};
    require(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
    require(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
    require(EGifPutExtensionBlock(file_, for_ever.size(), for_ever.data()));
    require(EGifPutExtensionTrailer(file_));
  }

  void close()
  {
    if (file_ != nullptr)
    {
      EGifCloseFile(file_, nullptr);
      file_ = nullptr;
    }
  }

  std::string bytes_;
  GifFileType* file_ = nullptr;
  int width_;
  int height_;
  int delay_cs_;
};

AnimatedGif::AnimatedGif(int width_px, int height_px, int delay_cs)
{
  const auto fits = [](int value, int least) { return value >= least && value <= kLongest; };
  if (!fits(width_px, 1) || !fits(height_px, 1) || !fits(delay_cs, 0))
  {
    throw std::invalid_argument("a film of no size, or one that a GIF cannot have");
  }
  impl_ = std::make_unique<Impl>(width_px, height_px, delay_cs);
}

AnimatedGif::~AnimatedGif() = default;
AnimatedGif::AnimatedGif(AnimatedGif&&) noexcept = default;
AnimatedGif& AnimatedGif::operator=(AnimatedGif&&) noexcept = default;

void AnimatedGif::add(const Raster& picture)
{
  impl_->add(picture);
}

std::string AnimatedGif::take()
{
  return impl_->take();
}
}  // namespace traverse::formats
