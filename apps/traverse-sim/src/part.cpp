// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "part.h"

#include <traverse/common_app/interrupt.h>
#include <traverse/formats/bytes.h>
#include <traverse/formats/gzip.h>
#include <traverse/observations/serialised.h>
#include <traverse/simulating/observations.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace traverse::app
{
namespace
{
using simulation::Event;
using simulation::LidarTurn;

/** An event as it is written. */
struct Made
{
  std::string log;
  std::vector<uint32_t> labels;
  bool is_turn = false;
};

uint32_t labelOf(const simulation::ReturnTruth& truth)
{
  static_assert(simulation::kLabels <= 256 && simulation::kMaterials <= 256);
  return static_cast<uint32_t>(truth.label) | static_cast<uint32_t>(truth.material) << 8U |
         truth.object << 16U;
}

Made madeOf(const Event& event, const simulation::RecordingParams& params)
{
  Made made;
  made.log = observations::serialised(*simulating::toObservation(event, params));
  if (const auto* turn = std::get_if<LidarTurn>(&event))
  {
    made.is_turn = true;
    made.labels.reserve(turn->returns.size());
    for (const simulation::ReturnTruth& truth : turn->returns)
    {
      made.labels.push_back(labelOf(truth));
    }
  }
  return made;
}

/** Threads that each take the next event that nobody has. */
class Crew
{
 public:
  explicit Crew(size_t jobs) : jobs_(jobs) {}

  template <class F>
  void work(int threads, const F& job)
  {
    std::vector<std::thread> others;
    others.reserve(static_cast<size_t>(threads));
    for (int i = 1; i < threads; ++i)
    {
      others.emplace_back([&] { workAlone(job); });
    }
    workAlone(job);
    for (std::thread& other : others)
    {
      other.join();
    }
    if (failure_)
    {
      std::rethrow_exception(failure_);
    }
  }

 private:
  template <class F>
  void workAlone(const F& job)
  {
    try
    {
      for (size_t i = next_++; i < jobs_ && !Interrupt::flag(); i = next_++)
      {
        job(i);
      }
    }
    catch (...)
    {
      next_ = jobs_;
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
  }

  size_t jobs_;
  std::atomic<size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};
}  // namespace

Part makePart(
    const simulation::Recording& recording,
    const simulation::RecordingParams& params,
    const std::vector<simulation::Recording::Planned>& events,
    int threads)
{
  std::vector<Made> made(events.size());
  Crew(events.size())
      .work(threads, [&](size_t i) { made[i] = madeOf(recording.make(events[i]), params); });
  Part part;
  formats::GzipStream gzip;
  for (Made& event : made)
  {
    part.log += gzip.add(event.log);
    event.log = {};
    if (event.is_turn)
    {
      part.labels.push_back(std::move(event.labels));
    }
  }
  part.log += gzip.finish();
  return part;
}

std::string labelBytes(const std::vector<std::vector<uint32_t>>& labels)
{
  formats::ByteWriter writer;
  writer.u64(labels.size());
  for (const std::vector<uint32_t>& turn : labels)
  {
    writer.array(turn);
  }
  return writer.take();
}

std::vector<std::vector<uint32_t>> labelsIn(const std::string& bytes, const std::string& name)
{
  formats::ByteReader reader(bytes, name);
  std::vector<std::vector<uint32_t>> labels(reader.count(sizeof(uint64_t)));
  for (std::vector<uint32_t>& turn : labels)
  {
    turn = reader.array<uint32_t>();
  }
  reader.expectEnd();
  return labels;
}
}  // namespace traverse::app
