// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Errors of the pose sources icp_3d and ins on real recordings; with MRPT's CICP::Align3D from scan
// to scan on the same points beside icp_3d. What the references are worth: doc/benchmarks.md.
#include <traverse/registration/scan_to_map.h>

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPose3DPDF.h>
#include <mrpt/slam/CICP.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <support/data.h>
#include <support/experiment.h>
#include <support/ins_recordings.h>
#include <support/labelled_clouds.h>
#include <support/path_errors.h>
#include <support/upright_things.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;

points::ScanBuffer readCloud(const std::filesystem::path& file)
{
  const std::vector<char> bytes = unpacked(file);
  const auto* values = reinterpret_cast<const float*>(bytes.data());
  points::ScanBuffer scan;
  for (size_t i = 0; i + 4 <= bytes.size() / sizeof(float); i += 4)
  {
    scan.x.push_back(values[i]);
    scan.y.push_back(values[i + 1]);
    scan.z.push_back(values[i + 2]);
  }
  return scan;
}

void tell(const std::string& name, const Errors& e, nlohmann::ordered_json& figures)
{
  figures[name + "_ate_m"] = e.ate_m;
  figures[name + "_ate_aligned_m"] = e.ate_aligned_m;
  figures[name + "_rel_translation_percent"] = e.step_percent;
  figures[name + "_rel_rotation_deg_per_m"] = e.step_deg_per_m;
}

struct Sequence
{
  std::string name;
  std::vector<points::ScanBuffer> scans;
  Path reference;
};

Sequence sequenceOf(
    const std::string& name,
    const std::filesystem::path& folder,
    const Path& reference,
    double dt_s)
{
  Sequence all{name, {}, {}};
  for (size_t i = 0; i < reference.size(); ++i)
  {
    std::array<char, 32> file{};
    std::snprintf(file.data(), file.size(), "%06zu.bin.gz", i);
    if (std::filesystem::exists(folder / file.data()))
    {
      all.scans.push_back(readCloud(folder / file.data()));
      all.scans.back().stamp = kStart + std::llround(static_cast<double>(i) * dt_s * 1e9);
      all.reference.push_back(reference[i]);
    }
  }
  return all;
}

double msSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

Path measureIcp(
    const Sequence& s, double voxel_m, const std::string& name, nlohmann::ordered_json& figures)
{
  registration::ScanToMap way({voxel_m, 100, {}});
  Path found;
  Path reference;
  double ms = 0;
  for (size_t i = 0; i < s.scans.size(); ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    const registration::Matched m = way.take(s.scans[i]);
    ms += msSince(start);
    if (m.first)
    {
      found.push_back(m.first->T_map_base);
      reference.push_back(s.reference[i - 1]);
    }
    if (m.verdict == registration::Verdict::tracked)
    {
      found.push_back(m.T_map_base);
      reference.push_back(s.reference[i]);
    }
  }
  figures[name + "_poses"] = found.size();
  figures[name + "_voxel_m"] = way.map()->voxel_m();
  figures[name + "_ms"] = ms / static_cast<double>(s.scans.size());
  tell(name, errorsOf(found, reference), figures);
  return found;
}

mrpt::maps::CSimplePointsMap mrptMap(const points::ScanBuffer& scan, double voxel_m)
{
  mrpt::maps::CSimplePointsMap map;
  std::set<std::array<int64_t, 3>> seen;
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const std::array<int64_t, 3> voxel = {
        std::llround(scan.x[i] / voxel_m), std::llround(scan.y[i] / voxel_m),
        std::llround(scan.z[i] / voxel_m)};
    if (seen.insert(voxel).second)
    {
      map.insertPoint(scan.x[i], scan.y[i], scan.z[i]);
    }
  }
  return map;
}

/** Scan to scan from the last step, as MRPT has no map for it that forgets. */
Path measureMrpt(const Sequence& s, nlohmann::ordered_json& figures)
{
  mrpt::slam::CICP icp;
  icp.options.maxIterations = 100;
  icp.options.thresholdDist = 3.0;
  icp.options.thresholdAng = 0;
  icp.options.smallestThresholdDist = 0.3;
  icp.options.ALFA = 0.8;
  icp.options.corresponding_points_decimation = 1;
  constexpr double kVoxel_m = 0.5;
  auto before = mrptMap(s.scans.front(), kVoxel_m);
  mrpt::poses::CPose3D step;
  Path found = {Eigen::Isometry3d::Identity()};
  double ms = 0;
  for (size_t i = 1; i < s.scans.size(); ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    auto now = mrptMap(s.scans[i], kVoxel_m);
    const auto pdf = icp.Align3D(&before, &now, step);
    step = pdf->getMeanVal();
    ms += msSince(start);
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.matrix() = step.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>().asEigen();
    found.push_back(found.back() * T);
    before = std::move(now);
  }
  figures["mrpt_cicp_" + s.name + "_ms"] = ms / static_cast<double>(s.scans.size() - 1);
  tell("mrpt_cicp_" + s.name, errorsOf(found, s.reference), figures);
  return found;
}

void measureIns(
    const std::string& name,
    const poses::PoseTrack& truth,
    const Noise& noise,
    bool with_attitude,
    nlohmann::ordered_json& figures)
{
  const Eigen::Isometry3d T_local_map = truth.poses().front().T_map_base.inverse();
  double squares_m2 = 0;
  double squares_deg2 = 0;
  const poses::InsPoses way = observed(truth, noise, with_attitude);
  for (const poses::StampedPose& pose : way.poses)
  {
    const Eigen::Isometry3d off =
        (T_local_map * truth.at(pose.time)->T_map_base).inverse() * pose.T_map_base;
    squares_m2 += off.translation().squaredNorm();
    const double deg = Eigen::AngleAxisd(off.linear()).angle() * kDegPerRad;
    squares_deg2 += deg * deg;
  }
  const auto n = static_cast<double>(way.poses.size());
  figures["ins_" + name + "_ate_m"] = std::sqrt(squares_m2 / n);
  figures["ins_" + name + "_deg"] = std::sqrt(squares_deg2 / n);
  figures["ins_" + name + "_poses"] = way.poses.size();
  figures["ins_" + name + "_fixes_without_heading"] = way.fixes_without_heading;
}

void measureAllIns(nlohmann::ordered_json& figures)
{
  const poses::TrackLimits any{1, 1000, 36000};
  const poses::PoseTrack argoverse(argoversePath(), any);
  const poses::PoseTrack novatel(novatelPath(), any);
  for (const auto& [name, truth] :
       {std::pair<std::string, const poses::PoseTrack*>{"argoverse", &argoverse},
        {"novatel", &novatel}})
  {
    measureIns(name, *truth, {}, true, figures);
    measureIns(name + "_rtk", *truth, {0.02, 0.03, 0.1}, true, figures);
    measureIns(name + "_gnss", *truth, {1.5, 3, 0.1}, true, figures);
    measureIns(name + "_rtk_no_attitude", *truth, {0.02, 0.03, 0}, false, figures);
  }
}

/** The two sweeps of Argoverse 2, both lidars together; in the vehicle frame, already deskewed. */
Sequence argoverseSweeps()
{
  const poses::PoseTrack truth(argoversePath(), {1, 1000, 36000});
  Sequence s{"argoverse", {}, {}};
  for (const char* stamp : {"315966265259836000", "315966265360032000"})
  {
    const std::string base = sharedData(std::string("argoverse2-2xVLP32C/") + stamp).string();
    points::ScanBuffer scan = readCloud(base + "_up.bin.gz");
    const points::ScanBuffer down = readCloud(base + "_down.bin.gz");
    scan.x.insert(scan.x.end(), down.x.begin(), down.x.end());
    scan.y.insert(scan.y.end(), down.y.begin(), down.y.end());
    scan.z.insert(scan.z.end(), down.z.begin(), down.z.end());
    scan.stamp = std::stoll(stamp);
    s.reference.push_back(truth.at(scan.stamp)->T_map_base);
    s.scans.push_back(std::move(scan));
  }
  return s;
}

void run(nlohmann::ordered_json& figures)
{
  const std::filesystem::path kitti = sharedData("kitti-odo00-labelled");
  const std::filesystem::path nuscenes = sharedData("nuscenes-hdl32-labelled");
  const Path kitti_poses = readRows(kitti / "poses_velodyne_world.txt", 1);
  const Path nuscenes_poses = readRows(nuscenes / "poses_ESTIMATED_by_icp.txt", 1);
  const std::vector<Sequence> all = {
      sequenceOf("kitti", kitti / "velodyne", kitti_poses, 0.1),
      sequenceOf("kitti_full", kitti / "full_resolution", kitti_poses, 0.1),
      sequenceOf("nuscenes", nuscenes / "lidar", nuscenes_poses, 0.5), argoverseSweeps()};
  for (const Sequence& s : all)
  {
    const Path found = measureIcp(s, 0, "icp_3d_" + s.name, figures);
    const Path by_mrpt = measureMrpt(s, figures);
    if (s.name == "kitti" && found.size() == s.reference.size())
    {
      figures["kitti_things_apart_m_reference"] = thingsApart_m(kitti, s.reference);
      figures["kitti_things_apart_m_icp_3d"] = thingsApart_m(kitti, found);
      figures["kitti_things_apart_m_mrpt_cicp"] = thingsApart_m(kitti, by_mrpt);
    }
  }
  for (const double share : {0.8, 1.2})
  {
    for (const size_t i : {0U, 2U})
    {
      const std::string base = "icp_3d_" + all[i].name;
      const double voxel_m = figures[base + "_voxel_m"].get<double>();
      measureIcp(all[i], share * voxel_m, base + (share < 1 ? "_voxel_80" : "_voxel_120"), figures);
    }
  }
  measureAllIns(figures);
}
}  // namespace

int main()
{
  return traverse::testing::reported(
      "poses",
      []
      {
        nlohmann::ordered_json figures;
        run(figures);
        std::cout << figures.dump() << "\n";
        return 0;
      });
}
