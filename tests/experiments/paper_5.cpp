// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause

// The experiment of paper 5 (occupancy from several lidars that nothing synchronises) in simulated
// streets, where every cell is known at any time: one drive of 18 s for each seed, ten of them are
// three minutes. The last line of stdout is one JSON object; doc/evaluation.md says what its keys
// mean.
#include <array>
#include <cstdio>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <support/corridors.h>
#include <support/experiment.h>
#include <support/paper_5_maps.h>
#include <support/paper_5_truth.h>
#include <support/seed_runs.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;

constexpr double kDuration_s = 18;
constexpr double kJudgeEvery_s = 4;
constexpr double kWatchEvery_s = 0.1;
constexpr std::array<const char*, 3> kMaps = {"", "nodeskew_", "paper_"};

double secondsOf(poses::TimeNs time)
{
  return poses::secondsBetween(simulation::kRecordingStart, time);
}

/** One drive with all the maps that are compared. */
class Run
{
 public:
  explicit Run(uint64_t seed) :
      drive_(Paper5Drive::inStreet(seed, kDuration_s)),
      people_(drive_.departures(simulation::Label::person)),
      cars_(drive_.departures(simulation::Label::vehicle)),
      departures_(people_),
      returns_(drive_),
      truth_(drive_)
  {
    departures_.insert(departures_.end(), cars_.begin(), cars_.end());
    maps_.emplace_back(paper5Params(false), true, drive_);
    maps_.emplace_back(paper5Params(false), false, drive_);
    maps_.emplace_back(paper5Params(true), true, drive_);
  }

  nlohmann::json result()
  {
    while (const auto turn = drive_.next())
    {
      const double arrival_s = secondsOf(turn->arrival);
      for (; next_watch_s_ < arrival_s; next_watch_s_ += kWatchEvery_s)
      {
        for (JudgedMap& map : maps_)
        {
          map.watch(departures_, next_watch_s_);
        }
      }
      if (arrival_s > next_judged_s_)
      {
        judge(next_judged_s_);
        next_judged_s_ += kJudgeEvery_s;
      }
      insert(*turn);
    }
    nlohmann::json result;
    for (size_t i = 0; i < maps_.size(); ++i)
    {
      result[std::string(kMaps[i]) + "map"] = maps_[i].result(people_, cars_);
    }
    for (const auto& [key, score] : blind_)
    {
      result["blind"][key] = JudgedMap::numbersOf(score);
    }
    return result;
  }

 private:
  void insert(const simulation::LidarTurn& turn)
  {
    const points::Decoded skewed = decodeTurn(turn);
    returns_.add(turn, skewed.scan);
    points::Decoded deskewed = skewed;
    if (points::deskew(deskewed.scan, drive_.ins()) != points::Deskew::no_poses)
    {
      for (JudgedMap& map : maps_)
      {
        map.insert(skewed, deskewed);
      }
    }
  }

  void judge(double time_s)
  {
    const layers::LayerSet truth = truth_.at(time_s, returns_);
    const Eigen::Vector3d place = drive_.place(time_s);
    evaluation::OccupancyParams circle;
    circle.centre_x_m = place.x();
    circle.centre_y_m = place.y();
    circle.radius_m = 40;
    for (JudgedMap& map : maps_)
    {
      map.judge(truth, circle);
    }
    if (time_s < kDuration_s / 2)  // later one of the lidars is dead
    {
      judgeBlindArea(truth, circle);
    }
  }

  void judgeBlindArea(const layers::LayerSet& truth, evaluation::OccupancyParams circle)
  {
    const layers::LayerSet one = maps_.front().knownNow(truth.extent, true);
    const layers::LayerSet three = maps_.front().knownNow(truth.extent, false);
    for (const auto& [prefix, radius_m] : {std::pair("", 40.0), std::pair("near_", 10.0)})
    {
      circle.radius_m = radius_m;
      const std::string key = prefix + std::string("blind_area_");
      blind_[key + "1_lidar"] += evaluation::occupancyScore(one, truth, circle);
      blind_[key + "3_lidars"] += evaluation::occupancyScore(three, truth, circle);
    }
  }

  Paper5Drive drive_;
  std::vector<evaluation::Departure> people_;
  std::vector<evaluation::Departure> cars_;
  std::vector<evaluation::Departure> departures_;  // all of them
  RecentReturns returns_;
  TruthAround truth_;
  std::deque<JudgedMap> maps_;
  std::map<std::string, evaluation::OccupancyScore> blind_;
  double next_watch_s_ = kWatchEvery_s;
  double next_judged_s_ = kJudgeEvery_s;
};

/** Corridors in every direction that is a multiple of 5 degrees, as wide as the buffers' soft parts
 * meet in; how many have a strip through them, at most a cell off their middle. */
nlohmann::json corridors(uint64_t seed, layers::StripRule rule)
{
  constexpr int kDirections = 36;
  layers::BufferParams params;
  params.strip = rule;
  const double least_m = 2 * params.hard_m + 3 * params.cell_size_m;
  const double most_m = 2 * (params.hard_m + params.soft_m) - params.cell_size_m;
  simulation::Random random(simulation::mixed({seed, 55}));
  int connected = 0;
  int ok = 0;
  for (int i = 0; i < kDirections; ++i)
  {
    Corridor corridor;
    corridor.yaw_deg = 5 * i;
    corridor.width_m = random.uniform(least_m, most_m);
    corridor.off_m = random.uniform(-0.2, 0.2);
    const CorridorCheck check(corridor, params);
    // half a cell's diagonal is what the walls' own cells are off
    constexpr double kOff_cells = 1 + 0.71;
    connected += check.isConnected() ? 1 : 0;
    ok += check.isConnected() && check.farthestOffCentre_cells() <= kOff_cells ? 1 : 0;
  }
  return {{"all", kDirections}, {"connected", connected}, {"ok", ok}};
}

nlohmann::json run(uint64_t seed)
{
  nlohmann::json result = Run(seed).result();
  result["map"]["corridors"] = corridors(seed, layers::StripRule::standard);
  result["paper_map"]["corridors"] = corridors(seed, layers::StripRule::paper);
  return result;
}

void tell(
    const std::string& prefix,
    const evaluation::OccupancyScore& score,
    nlohmann::ordered_json& figures)
{
  figures[prefix + "obstacle_recall"] = score.obstacleRecall();
  figures[prefix + "false_obstacle_rate"] = score.falseObstacleRate();
  figures[prefix + "false_ditch_rate"] = score.falseDitchRate();
  figures[prefix + "free_iou"] = score.freeIou();
  figures[prefix + "ditch_recall"] = score.ditchRecall();
  figures[prefix + "ditch_as_free_rate"] = score.ditchAsFreeRate();
}

/** A figure of several runs together, from a list of twelve numbers of each. */
template <class Of>
evaluation::OccupancyScore sumOf(const std::vector<nlohmann::json>& runs, Of&& of)
{
  evaluation::OccupancyScore sum;
  for (const nlohmann::json& one : runs)
  {
    sum += JudgedMap::scoreOf(of(one));
  }
  return sum;
}

void tellGhosts(
    const std::string& prefix,
    const std::vector<nlohmann::json>& runs,
    nlohmann::ordered_json& figures)
{
  const auto ghosts_of = [&](const std::vector<std::string>& keys)
  {
    evaluation::GhostScore score;
    for (const nlohmann::json& one : runs)
    {
      for (const std::string& key : keys)
      {
        const auto seconds = one[prefix + "map"][key].get<std::vector<double>>();
        score.seconds.insert(score.seconds.end(), seconds.begin(), seconds.end());
      }
    }
    std::sort(score.seconds.begin(), score.seconds.end());
    return score;
  };
  const evaluation::GhostScore all = ghosts_of({"ghosts_people", "ghosts_cars"});
  figures[prefix + "ghost_s_p50"] = all.percentile_s(0.5);
  figures[prefix + "ghost_s_p95"] = all.percentile_s(0.95);
  figures[prefix + "ghost_people_s_p95"] = ghosts_of({"ghosts_people"}).percentile_s(0.95);
  figures[prefix + "ghost_cars_s_p95"] = ghosts_of({"ghosts_cars"}).percentile_s(0.95);
  figures[prefix + "ghost_departures"] = all.seconds.size();
}

void tellStrips(
    const std::string& prefix,
    const std::vector<nlohmann::json>& runs,
    nlohmann::ordered_json& figures)
{
  std::map<std::string, double> sums;
  for (const nlohmann::json& one : runs)
  {
    for (const auto& [key, count] : one[prefix + "map"]["corridors"].items())
    {
      sums[key] += count.get<double>();
    }
  }
  figures[prefix + "strip_ok"] = sums["ok"] / sums["all"];
  figures[prefix + "strip_connected"] = sums["connected"] / sums["all"];
}

void tellBlindArea(const std::vector<nlohmann::json>& runs, nlohmann::ordered_json& figures)
{
  for (const char* key :
       {"blind_area_1_lidar", "blind_area_3_lidars", "near_blind_area_1_lidar",
        "near_blind_area_3_lidars"})
  {
    figures[key] =
        sumOf(runs, [&](const nlohmann::json& one) { return one["blind"][key]; }).blindShare();
  }
}

int runAll(const std::vector<std::string>& args)
{
  const SeedOptions options = seedOptions(args, {101, 200, ""});
  const std::vector<nlohmann::json> runs = runSeeds(options, run);
  nlohmann::ordered_json figures;
  for (const std::string prefix : kMaps)
  {
    const auto part = [&](const char* rule)
    { return sumOf(runs, [&](const nlohmann::json& one) { return one[prefix + "map"][rule]; }); };
    tell(prefix, part("plain"), figures);
    tell(prefix + "strict_", part("strict"), figures);
    tellGhosts(prefix, runs, figures);
  }
  tellStrips("", runs, figures);
  tellStrips("paper_", runs, figures);
  tellBlindArea(runs, figures);
  figures["seeds"] = std::to_string(options.first) + "-" + std::to_string(options.last);
  print(figures);
  return 0;
}
}  // namespace

int main(int argc, char** argv)
{
  return traverse::testing::reported("paper-5", [&] { return runAll({argv + 1, argv + argc}); });
}
