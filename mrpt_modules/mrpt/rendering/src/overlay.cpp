// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "overlay.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace traverse::rendering
{
namespace
{
using layers::Colour;

constexpr Colour kPaper = {255, 255, 255};
constexpr Colour kInk = {28, 35, 48};
constexpr double kPaperOpacity = 0.88;
constexpr int kMargin = 16;
constexpr int kPadding = 12;
constexpr int kTextHeight = 11;  // of the font, pixels
constexpr int kLine = 24;
constexpr int kSwatch = 14;
constexpr double kCharacterWidth = 0.8;  // of the height: wide enough for any text of ours

struct Rect
{
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

struct Text
{
  std::string text;
  int left = 0;
  int baseline = 0;  //!< from the top
};

Colour mixed(Colour under, Colour over, double share)
{
  const auto mix = [&](uint8_t a, uint8_t b)
  { return static_cast<uint8_t>(std::lround(a * (1 - share) + b * share)); };
  return {mix(under.r, over.r), mix(under.g, over.g), mix(under.b, over.b)};
}

void fill(formats::Raster& picture, const Rect& rect, Colour colour, double opacity)
{
  const int right = std::min(rect.left + rect.width, static_cast<int>(picture.width));
  const int bottom = std::min(rect.top + rect.height, static_cast<int>(picture.height));
  for (int row = std::max(0, rect.top); row < bottom; ++row)
  {
    for (int column = std::max(0, rect.left); column < right; ++column)
    {
      Colour& c = picture.at(static_cast<size_t>(column), static_cast<size_t>(row));
      c = mixed(c, colour, opacity);
    }
  }
}

/** The font has ASCII only. */
std::string drawable(const std::string& text)
{
  constexpr size_t kLongest = 80;
  std::string out;
  for (const char c : text)
  {
    const bool continues = (static_cast<uint8_t>(c) & 0xC0U) == 0x80U;
    if (!continues)
    {
      out += c >= ' ' && c <= '~' ? c : '?';
    }
  }
  return out.size() > kLongest ? out.substr(0, kLongest) + "..." : out;
}

int widthOf(const std::string& text)
{
  return static_cast<int>(
      std::ceil(kCharacterWidth * kTextHeight * static_cast<double>(text.size())));
}

/** MRPT draws white texts on black; what is white there is ink here. */
void write(formats::Raster& picture, const std::vector<Text>& texts, Renderer& renderer)
{
  if (texts.empty())
  {
    return;
  }
  auto scene = mrpt::opengl::COpenGLScene::Create();
  auto viewport = scene->getViewport();
  viewport->setCustomBackgroundColor({0.0F, 0.0F, 0.0F});
  mrpt::opengl::TFontParams font;
  font.vfont_name = "sans";
  font.vfont_scale = static_cast<float>(kTextHeight * Renderer::kSamples);
  font.color = {1.0F, 1.0F, 1.0F, 1.0F};
  size_t id = 0;
  for (const Text& t : texts)
  {
    const int from_bottom = renderer.sampleHeight() - t.baseline * Renderer::kSamples;
    viewport->addTextMessage(t.left * Renderer::kSamples, from_bottom, t.text, id++, font);
  }
  const formats::Raster ink = renderer.render(*scene, mrpt::opengl::CCamera());
  for (size_t i = 0; i < picture.pixels.size(); ++i)
  {
    picture.pixels[i] = mixed(picture.pixels[i], kInk, ink.pixels[i].g / 255.0);
  }
}

void drawLegend(formats::Raster& picture, const Overlay& overlay, std::vector<Text>& texts)
{
  const int lines = static_cast<int>(overlay.legend.size() + (overlay.title.empty() ? 0 : 1));
  if (lines == 0)
  {
    return;
  }
  const std::string title = drawable(overlay.title);
  int width = widthOf(title);
  for (const layers::LegendEntry& e : overlay.legend)
  {
    width = std::max(width, widthOf(drawable(e.name)) + kSwatch + kPadding);
  }
  fill(
      picture,
      {kMargin, kMargin, width + 2 * kPadding, lines * kLine + 2 * kPadding - (kLine - kSwatch)},
      kPaper, kPaperOpacity);
  int top = kMargin + kPadding;
  const int left = kMargin + kPadding;
  if (!title.empty())
  {
    texts.push_back({title, left, top + kSwatch - 1});
    top += kLine;
  }
  for (const layers::LegendEntry& e : overlay.legend)
  {
    fill(picture, {left - 1, top - 1, kSwatch + 2, kSwatch + 2}, kInk, 0.5);
    fill(picture, {left, top, kSwatch, kSwatch}, e.colour, 1);
    texts.push_back({drawable(e.name), left + kSwatch + kPadding, top + kSwatch - 1});
    top += kLine;
  }
}

void drawScaleBar(formats::Raster& picture, double metres_per_px, std::vector<Text>& texts)
{
  constexpr double kMostShare = 0.25;
  const double length_m =
      roundLength(kMostShare * static_cast<double>(picture.width) * metres_per_px);
  const int bar = static_cast<int>(std::lround(length_m / metres_per_px));
  const std::string text =
      length_m >= 1000 ? fmt::format("{:g} km", length_m / 1000) : fmt::format("{:g} m", length_m);
  const int width = std::max(bar, widthOf(text));
  const int height = kLine + kTextHeight;
  const int left = static_cast<int>(picture.width) - kMargin - kPadding - width;
  const int bottom = static_cast<int>(picture.height) - kMargin - kPadding;
  fill(
      picture, {left - kPadding, bottom - height, width + 2 * kPadding, height + kPadding}, kPaper,
      kPaperOpacity);
  fill(picture, {left, bottom - 3, bar, 3}, kInk, 1);
  fill(picture, {left, bottom - 9, 2, 9}, kInk, 1);
  fill(picture, {left + bar - 2, bottom - 9, 2, 9}, kInk, 1);
  texts.push_back({text, left, bottom - 15});
}
}  // namespace

double roundLength(double most)
{
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
  {
    if (factor * power <= most)
    {
      return factor * power;
    }
  }
  return power;
}

void drawOverlay(
    formats::Raster& picture, const Overlay& overlay, double metres_per_px, Renderer& renderer)
{
  std::vector<Text> texts;
  drawLegend(picture, overlay, texts);
  if (overlay.scale_bar && metres_per_px > 0)
  {
    drawScaleBar(picture, metres_per_px, texts);
  }
  write(picture, texts, renderer);
}
}  // namespace traverse::rendering
