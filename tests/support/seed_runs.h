// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

// Experiments that are many runs, one for each seed.
namespace traverse::testing
{
/** What a command line asks for: [--quick] [--seeds A-B] [--resume FILE]. */
struct SeedOptions
{
  uint64_t first = 1;
  uint64_t last = 100;
  std::string resume;  //!< a file of finished runs, which grows; empty: none
};

/** Throws std::invalid_argument. */
inline SeedOptions seedOptions(const std::vector<std::string>& args, SeedOptions usual)
{
  SeedOptions options = std::move(usual);
  for (size_t i = 0; i < args.size(); ++i)
  {
    if (args[i] == "--quick")
    {
      options.last = options.first + 9;
    }
    else if (args[i] == "--seeds" && i + 1 < args.size())
    {
      const std::string& range = args[++i];
      size_t end = 0;
      options.first = std::stoull(range, &end);
      options.last = end < range.size() && range[end] == '-' ? std::stoull(range.substr(end + 1))
                                                             : options.first;
    }
    else if (args[i] == "--resume" && i + 1 < args.size())
    {
      options.resume = args[++i];
    }
    else
    {
      throw std::invalid_argument("[--quick] [--seeds A-B] [--resume FILE]");
    }
  }
  if (options.last < options.first)
  {
    throw std::invalid_argument("--seeds A-B needs A <= B");
  }
  return options;
}

/** Finished runs by seed, as JSON, one on a line. */
class FinishedRuns
{
 public:
  explicit FinishedRuns(const std::string& file)
  {
    if (file.empty())
    {
      return;
    }
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
    {
      const auto run = nlohmann::json::parse(line, nullptr, false);
      if (run.is_object() && run.contains("seed"))  // else cut short by a kill
      {
        runs_[run["seed"].get<uint64_t>()] = run;
      }
    }
    out_.open(file, std::ios::app);
  }

  bool has(uint64_t seed) const { return runs_.count(seed) != 0; }

  void add(nlohmann::json run)
  {
    if (out_.is_open())
    {
      out_ << run.dump() << std::endl;
    }
    const auto seed = run["seed"].get<uint64_t>();
    runs_[seed] = std::move(run);
  }

  const nlohmann::json& at(uint64_t seed) const { return runs_.at(seed); }

 private:
  std::map<uint64_t, nlohmann::json> runs_;
  std::ofstream out_;
};

/** Calls run(seed), which gives JSON, for every seed that is not finished, on all cores; the result
 * is in the order of the seeds. Rethrows the first exception. */
template <class Run>
std::vector<nlohmann::json> runSeeds(const SeedOptions& options, const Run& run)
{
  FinishedRuns finished(options.resume);
  std::atomic<uint64_t> next = options.first;
  std::mutex one_at_a_time;
  std::exception_ptr failure;
  const auto is_due = [&](uint64_t seed)
  {
    const std::scoped_lock lock(one_at_a_time);
    return !failure && !finished.has(seed);
  };
  const auto work = [&]
  {
    for (uint64_t seed = next++; seed <= options.last; seed = next++)
    {
      if (!is_due(seed))
      {
        continue;
      }
      try
      {
        nlohmann::json result = run(seed);
        result["seed"] = seed;
        const std::scoped_lock lock(one_at_a_time);
        std::cerr << "seed " << seed << " " << result.value("line", "done") << "\n";
        finished.add(std::move(result));
      }
      catch (...)
      {
        const std::scoped_lock lock(one_at_a_time);
        failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
  {
    threads.emplace_back(work);
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  std::vector<nlohmann::json> results;
  for (uint64_t seed = options.first; seed <= options.last; ++seed)
  {
    results.push_back(finished.at(seed));
  }
  return results;
}
}  // namespace traverse::testing
