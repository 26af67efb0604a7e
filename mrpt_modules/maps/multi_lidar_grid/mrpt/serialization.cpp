// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map in MRPT's archives (rawlogs, copies of multi-maps).
#include <traverse/formats/archive.h>
#include <traverse/formats/option_bytes.h>
#include <traverse/maps/CWrappableMultiLidarGrid.h>

IMPLEMENTS_SERIALIZABLE(CWrappableMultiLidarGrid, CMetricMap, traverse::maps)

namespace traverse::maps
{
namespace
{
constexpr uint32_t kShellVersion = 1;
constexpr const char* kShellKind = "CWrappableMultiLidarGrid";
}  // namespace

uint8_t CWrappableMultiLidarGrid::serializeGetVersion() const
{
  return 0;
}

void CWrappableMultiLidarGrid::serializeTo(mrpt::serialization::CArchive& out) const
{
  formats::ArchiveWriter shell(kShellKind, kShellVersion);
  shell.section("LIKE", formats::optionBytes(likelihoodOptions));
  shell.section("REND", formats::optionBytes(renderOptions));
  shell.section("SENS", formats::optionBytes(sensors));
  writeBlob(out, shell.finish());
  writeBlob(out, archive());
  out << genericMapParams;
}

void CWrappableMultiLidarGrid::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version)
{
  if (version != 0)
  {
    MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  }
  const std::string shell_bytes = readBlob(in, kShellKind);
  const std::string map_bytes = readBlob(in, kShellKind);
  const formats::ArchiveReader shell(shell_bytes, kShellKind, kShellVersion);
  likelihoodOptions =
      formats::readOptionBytes<multi_lidar_grid::LikelihoodParams>(shell.reader("LIKE"));
  renderOptions = formats::readOptionBytes<MultiLidarRenderParams>(shell.reader("REND"));
  sensors = formats::readOptionBytes<observations::ObservationParams>(shell.reader("SENS"));
  setFromArchive(map_bytes);
  in >> genericMapParams;
}
}  // namespace traverse::maps
