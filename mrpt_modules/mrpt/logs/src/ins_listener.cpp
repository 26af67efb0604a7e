// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reader_job.h"

#include <traverse/observations/convert.h>
#include <traverse/poses/ins.h>

#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace traverse::logs
{
namespace
{
using namespace mrpt::obs;  // NOLINT(google-build-using-namespace): the names of its messages
using poses::GpsFix;
using poses::ImuSample;
constexpr int kNovatelGood = 9;
constexpr double kFastestTurn = 100;  // rad/s

double rad(double deg)
{
  return deg * (geometry::kPi / 180);
}

/** MRPT's yaw, pitch, roll; NaN for angles that are none. */
Eigen::Matrix3d rotationOf(double yaw_rad, double pitch_rad, double roll_rad)
{
  return poses::rotationBy(yaw_rad, Eigen::Vector3d::UnitZ()) *
         poses::rotationBy(pitch_rad, Eigen::Vector3d::UnitY()) *
         poses::rotationBy(roll_rad, Eigen::Vector3d::UnitX());
}

bool isPlace(const geometry::Geodetic& place)
{
  constexpr double kHighest_m = 1e5;
  return std::abs(place.latitude_deg) <= 90 && std::abs(place.longitude_deg) <= 360 &&
         std::abs(place.height_m) <= kHighest_m;  // false for NaN
}

/** MRPT's own getter of a pointer does not compile for a constant observation. */
template <class T>
const T* messageOf(const CObservationGPS& gps)
{
  return gps.hasMsgClass<T>() ? &gps.getMsgByClass<T>() : nullptr;
}

/** What a receiver's messages say of where it is. */
struct Reading
{
  geometry::Geodetic place;
  bool has_height = true;
  int quality = 0;  // as in NMEA's GGA
};

/** The best of the messages that an observation has; nothing where there is no position. */
std::optional<Reading> readingOf(const CObservationGPS& gps)
{
  if (const auto* ins = messageOf<gnss::Message_NV_OEM6_INSPVAS>(gps))
  {
    const auto status = ins->fields.ins_status;
    const bool good = status == gnss::nv_oem6_ins_status_type::INS_SOLUTION_GOOD ||
                      status == gnss::nv_oem6_ins_status_type::INS_ALIGNMENT_COMPLETE;
    return Reading{
        {ins->fields.lat, ins->fields.lon, ins->fields.hgt}, true, good ? kNovatelGood : 0};
  }
  if (const auto* best = messageOf<gnss::Message_NV_OEM6_BESTPOS>(gps))
  {
    const auto& f = best->fields;
    const bool good = f.solution_stat == gnss::nv_oem6_solution_status::SOL_COMPUTED &&
                      f.position_type != gnss::nv_oem6_position_type::NONE;
    return Reading{{f.lat, f.lon, f.hgt + double{f.undulation}}, true, good ? kNovatelGood : 0};
  }
  if (const auto* gga = messageOf<gnss::Message_NMEA_GGA>(gps))
  {
    const auto& f = gga->fields;
    return Reading{
        {f.latitude_degrees, f.longitude_degrees, f.altitude_meters + f.geoidal_distance},
        true,
        f.fix_quality};
  }
  if (const auto* rmc = messageOf<gnss::Message_NMEA_RMC>(gps))
  {
    const auto& f = rmc->fields;
    return Reading{
        {f.latitude_degrees, f.longitude_degrees, 0}, false, f.validity_char == 'A' ? 1 : 0};
  }
  return std::nullopt;
}

/** NovAtel's azimuth is clockwise from north, its pitch positive with the nose up. */
std::optional<Eigen::Matrix3d> attitudeOf(const CObservationGPS& gps)
{
  const auto* ins = messageOf<gnss::Message_NV_OEM6_INSPVAS>(gps);
  if (ins == nullptr)
  {
    return std::nullopt;
  }
  const auto& f = ins->fields;
  return rotationOf(rad(90 - f.azimuth), rad(-f.pitch), rad(f.roll));
}

std::optional<Eigen::Matrix3d> attitudeOf(const CObservationIMU& imu)
{
  if (imu.has(IMU_ORI_QUAT_W) && imu.has(IMU_ORI_QUAT_X) && imu.has(IMU_ORI_QUAT_Y) &&
      imu.has(IMU_ORI_QUAT_Z))
  {
    const Eigen::Quaterniond q(
        imu.get(IMU_ORI_QUAT_W), imu.get(IMU_ORI_QUAT_X), imu.get(IMU_ORI_QUAT_Y),
        imu.get(IMU_ORI_QUAT_Z));
    const bool unit = std::abs(q.norm() - 1) < 0.01;
    return unit ? std::optional(q.normalized().toRotationMatrix()) : std::nullopt;
  }
  if (imu.has(IMU_YAW) && imu.has(IMU_PITCH) && imu.has(IMU_ROLL))
  {
    return rotationOf(imu.get(IMU_YAW), imu.get(IMU_PITCH), imu.get(IMU_ROLL));
  }
  return std::nullopt;
}

/** About the vehicle's z. */
std::optional<double> yawRateOf(const CObservationIMU& imu, const Eigen::Matrix3d& R_base_sensor)
{
  if (!imu.has(IMU_WZ))
  {
    return std::nullopt;
  }
  const auto about = [&](TIMUDataIndex axis) { return imu.has(axis) ? imu.get(axis) : 0; };
  const double rate =
      (R_base_sensor * Eigen::Vector3d(about(IMU_WX), about(IMU_WY), imu.get(IMU_WZ))).z();
  return std::abs(rate) < kFastestTurn ? std::optional(rate) : std::nullopt;
}

class InsListener : public FrameListener
{
 public:
  InsListener(FramePipe& pipe, const JobSettings& settings) :
      FrameListener(pipe), params_(settings.poses)
  {
  }

  void observation(const CObservation::Ptr& observation) override
  {
    const std::string type = typeOf(*observation);
    const auto gps = std::dynamic_pointer_cast<CObservationGPS>(observation);
    const auto imu = std::dynamic_pointer_cast<CObservationIMU>(observation);
    if (!gps && !imu)
    {
      count(Counted::ignored, type);
      return;
    }
    const poses::TimeNs stamp = observations::toTime(observation->timestamp).value_or(0);
    countStamp(type, observation->sensorLabel, stamp);
    std::string why = "its time stamp is no clock's";
    if (stamp != 0)
    {
      why = gps ? take(*gps, stamp) : take(*imu, stamp);
    }
    why.empty() ? count(Counted::delivered, type) : count(Counted::rejected, type, why);
  }

  void logEnd() override
  {
    const poses::InsPoses way = poses::insPoses(std::move(fixes_), std::move(samples_), params_);
    for (const poses::StampedPose& pose : way.poses)
    {
      frames().add(pose);
    }
    for (size_t i = 0; i < way.fixes_of_others; ++i)
    {
      count(Counted::rejected, "CObservationGPS", kOtherReceiver);
    }
    for (size_t i = 0; i < way.fixes_without_heading; ++i)
    {
      count(Counted::rejected, "CObservationGPS", "no heading is known at its time");
    }
    if (way.origin)
    {
      note(
          "origin", fmt::format(
                        "{:.9f} {:.9f} {:.4f}", way.origin->latitude_deg, way.origin->longitude_deg,
                        way.origin->height_m));
    }
    if (way.courses > 0)
    {
      note("heading_off_course_deg", fmt::format("{:.2f}", way.heading_off_course_deg));
    }
  }

 private:
  /** Why it is not taken; empty where it is. */
  std::string take(const CObservationGPS& gps, poses::TimeNs stamp)
  {
    if (!params_.ins_receiver.empty() && gps.sensorLabel != params_.ins_receiver)
    {
      return kOtherReceiver;
    }
    const auto reading = readingOf(gps);
    const Eigen::Isometry3d T_base_sensor = observations::toIsometry(gps.sensorPose);
    if (!reading || !isPlace(reading->place) || !T_base_sensor.matrix().allFinite())
    {
      return reading ? "its position is none" : "it has no message with a position";
    }
    const auto& wanted = params_.ins_fix_qualities;
    if (std::find(wanted.begin(), wanted.end(), reading->quality) == wanted.end())
    {
      return fmt::format("its fix is of quality {}", reading->quality);
    }
    fixes_.push_back(
        {stamp, reading->place, reading->has_height, T_base_sensor.translation(),
         receiverOf(gps.sensorLabel)});
    keep(stamp, attitudeOf(gps), T_base_sensor, std::nullopt);
    return "";
  }

  std::string take(const CObservationIMU& imu, poses::TimeNs stamp)
  {
    const Eigen::Isometry3d T_base_sensor = observations::toIsometry(imu.sensorPose);
    const auto rate = yawRateOf(imu, T_base_sensor.linear());
    return keep(stamp, attitudeOf(imu), T_base_sensor, rate)
               ? ""
               : "it tells neither attitude nor turn rate";
  }

  bool keep(
      poses::TimeNs stamp,
      const std::optional<Eigen::Matrix3d>& R_enu_sensor,
      const Eigen::Isometry3d& T_base_sensor,
      const std::optional<double>& yaw_rate_radps)
  {
    ImuSample sample{stamp, std::nullopt, yaw_rate_radps};
    if (R_enu_sensor && R_enu_sensor->allFinite() && T_base_sensor.matrix().allFinite())
    {
      sample.R_enu_base = *R_enu_sensor * T_base_sensor.linear().transpose();
    }
    if (!sample.R_enu_base && !sample.yaw_rate_radps)
    {
      return false;
    }
    samples_.push_back(sample);
    return true;
  }

  /** A number for a label; more receivers than any vehicle has share the last. */
  uint32_t receiverOf(const std::string& label)
  {
    constexpr uint32_t kMost = 64;
    const auto known = receivers_.find(label);
    if (known != receivers_.end())
    {
      return known->second;
    }
    const auto number = std::min(kMost, static_cast<uint32_t>(receivers_.size()));
    return number < kMost ? receivers_[label] = number : kMost;
  }

  static constexpr const char* kOtherReceiver = "of another receiver (ins_receiver names one)";
  poses::PoseParams params_;
  std::map<std::string, uint32_t> receivers_;  // by label
  std::vector<GpsFix> fixes_;
  std::vector<ImuSample> samples_;
};
}  // namespace

std::unique_ptr<FrameListener> makeInsListener(FramePipe& pipe, const JobSettings& settings)
{
  return std::make_unique<InsListener>(pipe, settings);
}
}  // namespace traverse::logs
