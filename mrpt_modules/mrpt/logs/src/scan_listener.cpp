// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reader_job.h"

#include <traverse/observations/to_scan.h>
#include <traverse/points/sweep.h>

#include <string_view>

namespace traverse::logs
{
namespace
{
using observations::Outcome;
using observations::ScanResult;
constexpr size_t kLongestLabel = 256;

/** By MRPT's rule: beside `some.rawlog`, some_Images, some_images, some_IMAGES, or else Images.
 * (CRawlog::detectImagesDirectory() of 2.5.8 asks for files of these names, and finds no folder.)
 */
std::filesystem::path imageFolder(const JobSettings& settings)
{
  const std::filesystem::path beside = std::filesystem::absolute(settings.log).parent_path();
  if (!settings.sensors.image_folder.empty())
  {
    return beside / settings.sensors.image_folder;
  }
  for (const char* ending : {"_Images", "_images", "_IMAGES"})
  {
    std::filesystem::path folder = beside / (settings.log.stem().string() + ending);
    std::error_code none;
    if (std::filesystem::is_directory(folder, none))
    {
      return folder;
    }
  }
  return beside / "Images";
}

template <class T>
size_t hashOf(const std::vector<T>& values)
{
  return std::hash<std::string_view>{}(
      {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

/** Tells one measurement from another of the same sensor and stamp. */
size_t hashOf(const points::Decoded& decoded)
{
  size_t hash = hashOf(decoded.image.beam);
  for (const auto* channel : {&decoded.scan.x, &decoded.scan.y, &decoded.scan.z})
  {
    hash = hash * 31 + hashOf(*channel);
  }
  return hash;
}

class ScanListener : public FrameListener
{
 public:
  ScanListener(FramePipe& pipe, const JobSettings& settings) :
      FrameListener(pipe), settings_(settings), image_folder_(imageFolder(settings))
  {
  }

  void observation(const mrpt::obs::CObservation::Ptr& observation) override
  {
    const std::string type = typeOf(*observation);
    ScanResult result = observations::toScan(*observation, settings_.sensors, image_folder_);
    if (result.outcome == Outcome::ignored)
    {
      count(Counted::ignored, type);
    }
    else if (result.outcome == Outcome::rejected)
    {
      count(Counted::rejected, type, result.reason);
    }
    else
    {
      take(type, result.decoded);
    }
  }

  void logEnd() override
  {
    for (auto& [label, collector] : sweeps_)
    {
      send("CObservation2DRangeScan", collector.finish());
    }
  }

 private:
  struct Last
  {
    poses::TimeNs stamp = 0;
    size_t hash = 0;
  };

  void take(const std::string& type, points::Decoded& decoded)
  {
    points::ScanBuffer& scan = decoded.scan;
    scan.sensor_label.resize(std::min(scan.sensor_label.size(), kLongestLabel));
    decoded.image.sensor_label = scan.sensor_label;
    countStamp(type, scan.sensor_label, scan.stamp);
    if (scan.stamp == 0 && !settings_.accept_bad_stamps)
    {
      count(Counted::rejected, type, "its time stamp is no clock's");
      return;
    }
    const Last now = {scan.stamp, hashOf(decoded)};
    Last& before = last_[scan.sensor_label];
    const bool again = now.stamp != 0 && now.stamp == before.stamp && now.hash == before.hash;
    before = now;
    if (again)
    {
      count(Counted::rejected, type, "it is the scan before once more");
      return;
    }
    if (observations::hasLabel(settings_.sensors.tilting_labels, scan.sensor_label))
    {
      const std::string label = scan.sensor_label;
      send(type, sweeps_[label].add(std::move(decoded)));
      return;
    }
    send(type, std::move(decoded));
  }

  void send(const std::string& type, const std::optional<points::Decoded>& decoded)
  {
    if (decoded)
    {
      frames().add(*decoded);
      count(Counted::delivered, type);
    }
  }

  JobSettings settings_;
  std::filesystem::path image_folder_;
  std::map<std::string, Last> last_;  // by label
  std::map<std::string, points::SweepCollector> sweeps_;
};
}  // namespace

std::unique_ptr<FrameListener> makeScanListener(FramePipe& pipe, const JobSettings& settings)
{
  return std::make_unique<ScanListener>(pipe, settings);
}
}  // namespace traverse::logs
