// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/rendering/layer_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace traverse::rendering
{
namespace
{
/** Where MRPT's light comes from. A saved scene forgets that it is not to be lit; normals that look
 * into the light get 0.2 ambient + 0.8 diffuse of their colour there, which is all of it. */
const mrpt::math::TVector3Df kTowardsLight(0.40825F, 0.40825F, 0.81650F);

template <class T>
const std::vector<T>& layerOf(const layers::LayerSet& set, std::string_view name)
{
  const layers::Layer* layer = set.find(name);
  const auto* data = layer == nullptr ? nullptr : std::get_if<std::vector<T>>(&layer->data);
  if (data == nullptr || data->size() != set.size())
  {
    throw std::invalid_argument("no layer '" + std::string(name) + "' of the type that is drawn");
  }
  return *data;
}

std::array<mrpt::img::TColor, 256> coloursOf(const layers::LayerSet& set)
{
  std::array<mrpt::img::TColor, 256> colours;
  colours.fill(mrpt::img::TColor(255, 255, 255));
  for (const layers::LegendEntry& entry : set.legend)
  {
    colours[entry.code] = mrpt::img::TColor(entry.colour.r, entry.colour.g, entry.colour.b);
  }
  return colours;
}

/** Heights of cells as a continuous surface. */
class Surface
{
 public:
  Surface(const layers::LayerSet& set, const std::vector<float>& heights, float most_relief_m) :
      set_(set), heights_(heights), most_relief_m_(most_relief_m)
  {
  }

  float cell(int32_t x, int32_t y) const
  {
    const bool is_inside = x >= 0 && y >= 0 && x < set_.extent.width() && y < set_.extent.height();
    return is_inside ? heights_[static_cast<size_t>(y) * set_.extent.width() + x] : std::nanf("");
  }

  /** The corner of smallest x and y of cell (x, y), as a cell of height `of` sees it; relative to
   * the extent's corner, where floats are exact enough also far from map zero. */
  mrpt::math::TPoint3Df corner(int32_t x, int32_t y, float of) const
  {
    float sum = 0;
    float n = 0;
    for (const float h : {cell(x, y), cell(x - 1, y), cell(x, y - 1), cell(x - 1, y - 1)})
    {
      if (std::abs(h - of) <= most_relief_m_)  // false for NaN
      {
        sum += h;
        ++n;
      }
    }
    return {
        static_cast<float>(set_.lattice.edge_m(x)), static_cast<float>(set_.lattice.edge_m(y)),
        sum / n};
  }

 private:
  const layers::LayerSet& set_;
  const std::vector<float>& heights_;
  float most_relief_m_;
};
}  // namespace

mrpt::opengl::CSetOfTriangles::Ptr layerSurface(
    const layers::LayerSet& set, std::string_view height_layer, float most_relief_m)
{
  const auto& classes = layerOf<uint8_t>(set, set.class_layer);
  const auto& heights = layerOf<float>(set, height_layer);
  const auto colours = coloursOf(set);
  const Surface surface(set, heights, most_relief_m);

  std::vector<mrpt::opengl::TTriangle> triangles;
  for (int32_t y = 0; y < set.extent.height(); ++y)
  {
    for (int32_t x = 0; x < set.extent.width(); ++x)
    {
      const float h = surface.cell(x, y);
      if (!std::isfinite(h))
      {
        continue;
      }
      const auto a = surface.corner(x, y, h);
      const auto b = surface.corner(x + 1, y, h);
      const auto c = surface.corner(x + 1, y + 1, h);
      const auto d = surface.corner(x, y + 1, h);
      const auto i = static_cast<size_t>(y) * set.extent.width() + x;
      const mrpt::math::TVector3Df n = kTowardsLight;
      triangles.emplace_back(a, b, c, n, n, n).setColor(colours[classes[i]]);
      triangles.emplace_back(a, c, d, n, n, n).setColor(colours[classes[i]]);
    }
  }
  auto object = mrpt::opengl::CSetOfTriangles::Create();
  object->enableLight(false);
  object->setLocation(
      set.lattice.edge_m(set.extent.min.x), set.lattice.edge_m(set.extent.min.y), 0);
  object->insertTriangles(triangles.begin(), triangles.end());
  return object;
}
}  // namespace traverse::rendering
