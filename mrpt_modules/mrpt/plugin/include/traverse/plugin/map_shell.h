// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/scan_consumer.h>
#include <traverse/observations/observation_params.h>

#include <mrpt/maps/CMetricMap.h>
#include <mrpt/serialization/CArchive.h>

#include <ostream>
#include <string>

namespace traverse::maps
{
/** What the shells of all our maps have in common: they take every range sensor's observations by
 * insertScan(), and are not matched against other maps. */
class MapShell : public mrpt::maps::CMetricMap, public layers::ScanConsumer
{
 public:
  observations::ObservationParams sensors;  //!< how insertObservation() decodes

  /** No matching on these maps: no correspondence, ratio 0. */
  void determineMatching2D(
      const mrpt::maps::CMetricMap* other_map,
      const mrpt::poses::CPose2D& other_pose,
      mrpt::tfest::TMatchingPairList& correspondences,
      const mrpt::maps::TMatchingParams& params,
      mrpt::maps::TMatchingExtraResults& extra) const override;
  void determineMatching3D(
      const mrpt::maps::CMetricMap* other_map,
      const mrpt::poses::CPose3D& other_pose,
      mrpt::tfest::TMatchingPairList& correspondences,
      const mrpt::maps::TMatchingParams& params,
      mrpt::maps::TMatchingExtraResults& extra) const override;
  float compute3DMatchingRatio(
      const mrpt::maps::CMetricMap* other_map,
      const mrpt::poses::CPose3D& other_pose,
      const mrpt::maps::TMatchingRatioParams& params) const override;
  float squareDistanceToClosestCorrespondence(float x, float y) const override;

  /** Writes <prefix>.traverse (the archive), the map's extraFiles() as <prefix><ending>, and,
   * unless the map is empty, <prefix>_<layer>.tif of each layer, <prefix>_class.png and what
   * saveMore() writes. Throws formats::FileError. */
  void saveMetricMapRepresentationToFile(const std::string& prefix) const override;

 protected:
  /** Files of a map that is not empty, beyond those of every map. */
  virtual void saveMore(const std::string& /*prefix*/, const layers::LayerSet& /*set*/) const {}

  /** logLikelihood() of a map that is not empty. */
  virtual double logLikelihoodOf(
      const points::Scan& scan, const Eigen::Isometry3d& T_map_base) const = 0;

 private:
  bool internal_insertObservation(
      const mrpt::obs::CObservation& observation,
      const std::optional<const mrpt::poses::CPose3D>& robot_pose) override;
  double internal_computeObservationLikelihood(
      const mrpt::obs::CObservation& observation,
      const mrpt::poses::CPose3D& taken_from) const override;
  bool internal_canComputeObservationLikelihood(
      const mrpt::obs::CObservation& observation) const override;
};

/** A length and so many bytes in MRPT's archives. */
void writeBlob(mrpt::serialization::CArchive& out, const std::string& bytes);

/** The reverse; a length that lies allocates no more than the stream has, and a piece. Throws
 * formats::FormatError, naming `kind`, where the stream ends before. */
std::string readBlob(mrpt::serialization::CArchive& in, const std::string& kind);

/** Options as MRPT's maps dump theirs. */
template <class P>
void dumpOptions(std::ostream& out, const char* title, const P& params)
{
  out << title << "\n";
  for (const options::Row& row : options::rows(params))
  {
    out << "  " << row.key << " = " << row.value << "\n";
  }
}
}  // namespace traverse::maps
