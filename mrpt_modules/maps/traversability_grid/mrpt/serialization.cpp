// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map in MRPT's archives (rawlogs, .gridmap, copies of multi-maps).
#include <traverse/formats/archive.h>
#include <traverse/formats/option_bytes.h>
#include <traverse/maps/CTraversabilityGridMap.h>

#include <mrpt/serialization/CArchive.h>

IMPLEMENTS_SERIALIZABLE(CTraversabilityGridMap, CMetricMap, traverse::maps)

namespace traverse::maps
{
namespace
{
constexpr uint32_t kShellVersion = 2;  // 2: the octree
constexpr const char* kShellKind = "CTraversabilityGridMap";
}  // namespace

uint8_t CTraversabilityGridMap::serializeGetVersion() const
{
  return 0;
}

void CTraversabilityGridMap::serializeTo(mrpt::serialization::CArchive& out) const
{
  formats::ArchiveWriter shell(kShellKind, kShellVersion);
  shell.section("LIKE", formats::optionBytes(likelihoodOptions));
  shell.section("REND", formats::optionBytes(renderOptions));
  shell.section("SENS", formats::optionBytes(sensors));
  shell.section("OCTO", formats::optionBytes(octomapOptions));
  if (!octree_.empty())
  {
    shell.section("TREE", octree_.bt());
  }
  writeBlob(out, shell.finish());
  writeBlob(out, archive());
  out << genericMapParams;
}

void CTraversabilityGridMap::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version)
{
  if (version != 0)
  {
    MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  }
  const std::string shell_bytes = readBlob(in, kShellKind);
  const std::string map_bytes = readBlob(in, kShellKind);
  const formats::ArchiveReader shell(shell_bytes, kShellKind, kShellVersion);
  likelihoodOptions =
      formats::readOptionBytes<traversability_grid::LikelihoodParams>(shell.reader("LIKE"));
  renderOptions = formats::readOptionBytes<TraversabilityRenderParams>(shell.reader("REND"));
  sensors = formats::readOptionBytes<observations::ObservationParams>(shell.reader("SENS"));
  octomapOptions = shell.has("OCTO")
                       ? formats::readOptionBytes<formats::OctomapParams>(shell.reader("OCTO"))
                       : formats::OctomapParams{};
  setFromArchive(map_bytes);
  if (shell.has("TREE"))
  {
    octree_ = formats::PointOctree::fromBt(shell.section("TREE"), octomapOptions);
  }
  in >> genericMapParams;
}
}  // namespace traverse::maps
