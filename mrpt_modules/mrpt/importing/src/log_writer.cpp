// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/gzip.h>
#include <traverse/formats/safe_file.h>
#include <traverse/formats/streamed_file.h>
#include <traverse/importing/log_writer.h>
#include <traverse/observations/convert.h>
#include <traverse/observations/serialised.h>

#include <mrpt/maps/CPointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <optional>

namespace traverse::importing
{
namespace
{
formats::CloudKey keyOf(const mrpt::obs::CObservationPointCloud& cloud)
{
  const auto& x = cloud.pointcloud->getPointsBufferRef_x();
  const auto& y = cloud.pointcloud->getPointsBufferRef_y();
  const auto& z = cloud.pointcloud->getPointsBufferRef_z();
  return {
      cloud.sensorLabel, observations::toTime(cloud.timestamp).value_or(0),
      static_cast<uint32_t>(x.size()),
      formats::cloudChecksum({x.data(), x.size()}, {y.data(), y.size()}, {z.data(), z.size()})};
}

const std::filesystem::path& checkTarget(const std::filesystem::path& log, bool replace)
{
  for (const std::filesystem::path& file : {log, formats::channelsFileOf(log)})
  {
    if (!replace && std::filesystem::exists(std::filesystem::symlink_status(file)))
    {
      throw formats::FileError(file, "is there already; --force replaces it");
    }
  }
  return log;
}
}  // namespace

struct LogWriter::State
{
  State(const std::filesystem::path& path, bool replace) :
      log(checkTarget(path, replace)), file(path)
  {
  }

  std::filesystem::path log;
  formats::StreamedFile file;
  formats::GzipStream gzip;
  std::optional<formats::ChannelsWriter> channels;
};

LogWriter::LogWriter(const std::filesystem::path& log, bool replace) :
    state_(std::make_unique<State>(log, replace))
{
}

LogWriter::~LogWriter() = default;

void LogWriter::add(const Entry& entry)
{
  const auto* cloud =
      dynamic_cast<const mrpt::obs::CObservationPointCloud*>(entry.observation.get());
  if (cloud != nullptr && cloud->pointcloud && !entry.channels.empty())
  {
    if (!state_->channels)
    {
      state_->channels.emplace(state_->log);
    }
    state_->channels->add(keyOf(*cloud), entry.channels);
  }
  state_->file.write(state_->gzip.add(observations::serialised(*entry.observation)));
}

bool LogWriter::hasChannels() const
{
  return state_->channels && state_->channels->clouds() > 0;
}

void LogWriter::commit()
{
  state_->file.write(state_->gzip.finish());
  state_->file.finish();
  if (hasChannels())
  {
    // First: the new log must not stand without them. Killed between the two, an old log that is
    // being replaced stands without its own; these do it no harm, as they carry check sums.
    state_->channels->finish();
    state_->channels->commit();
  }
  state_->file.commit();
  if (!hasChannels())
  {
    std::error_code ignored;
    std::filesystem::remove(formats::channelsFileOf(state_->log), ignored);
  }
}
}  // namespace traverse::importing
