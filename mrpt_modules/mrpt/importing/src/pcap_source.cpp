// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planned_source.h"
#include "sources.h"
#include "velodyne_turns.h"

#include <traverse/formats/pcap.h>

#include <deque>
#include <fmt/format.h>
#include <map>

namespace traverse::importing
{
namespace
{
constexpr size_t kMostSensors = 16;

/** Turns of the Velodyne sensors of a capture; sensors are told apart by their UDP port. */
class PcapSource : public Source
{
 public:
  explicit PcapSource(const ImportParams& params) :
      params_(params), reader_(params.input), bytes_(std::filesystem::file_size(params.input))
  {
  }

  std::optional<Entry> next() override
  {
    while (ready_.empty() && !ended_)
    {
      const auto datagram = reader_.next();
      datagram ? take(*datagram) : end();
    }
    if (ready_.empty())
    {
      return std::nullopt;
    }
    Entry entry = std::move(ready_.front());
    ready_.pop_front();
    countImported(*entry.observation, report_);
    return entry;
  }

  double progress() const override
  {
    // Of a gzip file the unpacked bytes are known only: it seems to be ahead.
    return ended_ ? 1
                  : std::min(
                        0.99, static_cast<double>(reader_.report().offset) /
                                  static_cast<double>(std::max<uint64_t>(bytes_, 1)));
  }

  const ImportReport& report() const override { return report_; }

 private:
  void take(const formats::UdpDatagram& datagram)
  {
    first_ = first_.value_or(datagram.time);
    const double at_s = poses::secondsBetween(*first_, datagram.time);
    if (at_s < params_.from_s || at_s >= params_.to_s)
    {
      return;
    }
    if (datagram.payload.size() != sensors::kVelodynePacketBytes)
    {
      ++report_.skipped
            [datagram.payload.size() == sensors::kVelodynePositionBytes
                 ? "position packets of Velodyne"
                 : "datagrams of another size than Velodyne's"];
      return;
    }
    const uint16_t port = datagram.destination_port;
    if (sensors_.count(port) == 0 && sensors_.size() == kMostSensors)
    {
      ++report_.skipped["datagrams of more than 16 ports"];
      return;
    }
    auto& turns = sensors_.try_emplace(port, makeTurns(port)).first->second;
    if (!turns.add(datagram.payload, datagram.time))
    {
      ++report_.skipped["packets of another Velodyne than VLP-16, HDL-32E, VLP-32C"];
    }
    keep(turns.takeFinished());
  }

  VelodyneTurns makeTurns(uint16_t port) const
  {
    SensorAt sensor;
    sensor.label = params_.sensor_label.empty() ? "VELODYNE" : params_.sensor_label;
    sensor.label += sensors_.empty() ? "" : fmt::format("_{}", port);
    sensor.T_base_sensor = params_.T_base_sensor.value_or(Eigen::Isometry3d::Identity());
    return VelodyneTurns(sensor);
  }

  void keep(std::optional<Entry> entry)
  {
    if (entry)
    {
      ready_.push_back(std::move(*entry));
    }
  }

  void end()
  {
    ended_ = true;
    for (auto& [port, turns] : sensors_)
    {
      keep(turns.finish());
    }
    const formats::PcapReport& met = reader_.report();
    if (met.end != formats::PcapEnd::clean)
    {
      addDamage(met.message, report_);
    }
    if (met.fragments > 0)
    {
      report_.skipped["fragments of datagrams"] += met.fragments;
    }
    if (met.other > 0)
    {
      report_.skipped["packets that are no UDP"] += met.other;
    }
  }

  ImportParams params_;
  formats::PcapReader reader_;
  ImportReport report_;
  std::map<uint16_t, VelodyneTurns> sensors_;
  std::deque<Entry> ready_;
  std::optional<poses::TimeNs> first_;
  uint64_t bytes_;
  bool ended_ = false;
};

bool endsWith(const std::string& text, std::string_view ending)
{
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}
}  // namespace

bool isPcap(const std::filesystem::path& input)
{
  const std::string name = input.filename().string();
  return endsWith(name, ".pcap") || endsWith(name, ".pcap.gz");
}

std::unique_ptr<Source> openPcap(const ImportParams& params)
{
  try
  {
    return std::make_unique<PcapSource>(params);
  }
  catch (const std::runtime_error& e)
  {
    throw ImportError(e.what());
  }
}
}  // namespace traverse::importing
