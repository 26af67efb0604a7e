// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/point_labels.h>

namespace traverse::traversability_grid
{
namespace
{
/** Without a ground only the class can tell. */
PointLabel labelByClass(Class of, ClassifierKind classifier)
{
  const bool may_be_ground = classifier == ClassifierKind::paper;
  switch (of)
  {
    case Class::flat:
    case Class::small_roughness:
      return may_be_ground ? PointLabel::ground : PointLabel::undefined;
    case Class::large_roughness:
      return may_be_ground ? PointLabel::obstacle : PointLabel::undefined;
    case Class::obstacle:
      return PointLabel::obstacle;
    case Class::undefined:
      break;
  }
  return PointLabel::undefined;
}

PointLabel labelOf(const Judgement& cell, double z_mm, ClassifierKind classifier)
{
  if (z_mm <= cell.ground_limit_mm)
  {
    return PointLabel::ground;
  }
  const bool is_above_gap = z_mm > cell.top_mm;
  if (is_above_gap || cell.overhangs)
  {
    return PointLabel::overhanging;
  }
  const bool ground_is_known = cell.ground_m == cell.ground_m;
  return ground_is_known ? PointLabel::obstacle : labelByClass(cell.of, classifier);
}
}  // namespace

std::vector<PointLabel> labelsOfLastScan(
    const State& state,
    const points::Scan& scan,
    const Eigen::Isometry3d& T_map_base,
    const Params& params)
{
  constexpr double kRounding_mm = 0.5;  // heights were rounded to whole millimetres
  const std::span<const uint32_t> cells = state.scan.ofPoints();
  const std::span<const Judgement> judgements = state.judge.judgements();
  if (cells.size() != scan.size())  // it was refused
  {
    return std::vector<PointLabel>(scan.size(), PointLabel::undefined);
  }
  std::vector<PointLabel> labels(scan.size(), PointLabel::undefined);
  const Eigen::RowVector4d row_mm = T_map_base.matrix().row(2) * geometry::kMillimetresPerMetre;
  for (size_t i = 0; i < labels.size(); ++i)
  {
    const uint32_t number = cells[i];
    if (number < judgements.size())
    {
      const double z_mm =
          row_mm[0] * scan.x[i] + row_mm[1] * scan.y[i] + row_mm[2] * scan.z[i] + row_mm[3];
      labels[i] = labelOf(judgements[number], z_mm - kRounding_mm, params.classifier);
    }
  }
  return labels;
}
}  // namespace traverse::traversability_grid
