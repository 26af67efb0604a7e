// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/geotiff.h>
#include <traverse/formats/png.h>
#include <traverse/formats/safe_file.h>
#include <traverse/observations/convert.h>
#include <traverse/observations/to_scan.h>
#include <traverse/plugin/map_shell.h>

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/tfest/TMatchingPair.h>

#include <algorithm>
#include <limits>

namespace traverse::maps
{
bool MapShell::internal_insertObservation(
    const mrpt::obs::CObservation& observation,
    const std::optional<const mrpt::poses::CPose3D>& robot_pose)
{
  const observations::ScanResult result = observations::toScan(observation, sensors);
  if (result.outcome != observations::Outcome::scan)
  {
    return false;
  }
  const Eigen::Isometry3d T_map_base =
      robot_pose ? observations::toIsometry(*robot_pose) : Eigen::Isometry3d::Identity();
  return insertScan(result.decoded.view(), poses::PoseTrack::constant(T_map_base)).inserted;
}

double MapShell::internal_computeObservationLikelihood(
    const mrpt::obs::CObservation& observation, const mrpt::poses::CPose3D& taken_from) const
{
  if (isEmpty() || !internal_canComputeObservationLikelihood(observation))
  {
    return 0;
  }
  const observations::ScanResult result = observations::toScan(observation, sensors);
  return logLikelihoodOf(result.decoded.view(), observations::toIsometry(taken_from));
}

bool MapShell::internal_canComputeObservationLikelihood(
    const mrpt::obs::CObservation& observation) const
{
  using namespace mrpt::obs;  // NOLINT(google-build-using-namespace): CLASS_ID pastes bare names
  const mrpt::rtti::TRuntimeClassId* type = observation.GetRuntimeClass();
  return type->derivedFrom(CLASS_ID(CObservation2DRangeScan)) ||
         type->derivedFrom(CLASS_ID(CObservationVelodyneScan)) ||
         type->derivedFrom(CLASS_ID(CObservation3DRangeScan)) ||
         type->derivedFrom(CLASS_ID(CObservationPointCloud)) ||
         type->derivedFrom(CLASS_ID(CObservationRotatingScan));
}

void MapShell::determineMatching2D(
    const mrpt::maps::CMetricMap* /*other_map*/,
    const mrpt::poses::CPose2D& /*other_pose*/,
    mrpt::tfest::TMatchingPairList& correspondences,
    const mrpt::maps::TMatchingParams& /*params*/,
    mrpt::maps::TMatchingExtraResults& extra) const
{
  correspondences.clear();
  extra = {};
}

void MapShell::determineMatching3D(
    const mrpt::maps::CMetricMap* /*other_map*/,
    const mrpt::poses::CPose3D& /*other_pose*/,
    mrpt::tfest::TMatchingPairList& correspondences,
    const mrpt::maps::TMatchingParams& /*params*/,
    mrpt::maps::TMatchingExtraResults& extra) const
{
  correspondences.clear();
  extra = {};
}

float MapShell::compute3DMatchingRatio(
    const mrpt::maps::CMetricMap* /*other_map*/,
    const mrpt::poses::CPose3D& /*other_pose*/,
    const mrpt::maps::TMatchingRatioParams& /*params*/) const
{
  return 0;
}

float MapShell::squareDistanceToClosestCorrespondence(float /*x*/, float /*y*/) const
{
  return std::numeric_limits<float>::max();
}

void MapShell::saveMetricMapRepresentationToFile(const std::string& prefix) const
{
  formats::writeFile(prefix + ".traverse", archive());
  for (const layers::ExtraFile& file : extraFiles())
  {
    formats::writeFile(prefix + file.ending, file.bytes);
  }
  if (isEmpty())
  {
    return;
  }
  const layers::LayerSet set = layerSet();
  for (const layers::Layer& layer : set.layers)
  {
    formats::writeFile(prefix + "_" + layer.name + ".tif", formats::geoTiff(set, layer));
  }
  formats::writeFile(prefix + "_class.png", formats::png(formats::classPicture(set)));
  saveMore(prefix, set);
}

std::string readBlob(mrpt::serialization::CArchive& in, const std::string& kind)
{
  constexpr uint64_t kPiece = 1U << 20U;
  std::string bytes;
  for (auto left = in.ReadAs<uint64_t>(); left > 0;)
  {
    const auto piece = static_cast<size_t>(std::min(left, kPiece));
    const size_t have = bytes.size();
    bytes.resize(have + piece);
    if (in.ReadBuffer(bytes.data() + have, piece) != piece)
    {
      throw formats::FormatError(kind + ": the stream ends within the map");
    }
    left -= piece;
  }
  return bytes;
}

void writeBlob(mrpt::serialization::CArchive& out, const std::string& bytes)
{
  out.WriteAs<uint64_t>(bytes.size());
  out.WriteBuffer(bytes.data(), bytes.size());
}
}  // namespace traverse::maps
