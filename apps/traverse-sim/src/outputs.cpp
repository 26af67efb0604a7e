// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include "truth_outputs.h"

#include <traverse/common_app/json_text.h>
#include <traverse/formats/safe_file.h>
#include <traverse/formats/streamed_file.h>
#include <traverse/formats/trajectory.h>

#include <array>
#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <set>

namespace traverse::app
{
namespace
{
namespace fs = std::filesystem;
using simulation::Scene;

constexpr double kTrajectoryHz = 100;  // every pose that the drive consists of

/** Points of the whole log by their label. */
struct Census
{
  uint64_t turns = 0;
  uint64_t points = 0;
  std::array<uint64_t, simulation::kLabels> by_label{};
};

/** The folder's commit brings it to the disk. */
template <class T>
void writeArray(const fs::path& path, const std::vector<T>& values)
{
  std::ofstream file(path, std::ios::binary);
  file.write(
      reinterpret_cast<const char*>(values.data()),
      static_cast<std::streamsize>(values.size() * sizeof(T)));
  file.close();
  if (!file)
  {
    throw formats::FileError("write", path, errno);
  }
}

/** What a turn's points are (part.h), as files for people: labels and materials apart. */
void writeLabels(const fs::path& folder, const std::vector<uint32_t>& truths, Census& census)
{
  std::vector<uint32_t> labels;
  std::vector<uint8_t> materials;
  labels.reserve(truths.size());
  materials.reserve(truths.size());
  for (const uint32_t truth : truths)
  {
    ++census.by_label.at(truth & 0xFFU);
    labels.push_back((truth & 0xFFU) | (truth & 0xFFFF0000U));
    materials.push_back(static_cast<uint8_t>(truth >> 8U));
  }
  const std::string number = fmt::format("{:06}", census.turns++);
  census.points += truths.size();
  writeArray(folder / (number + ".label"), labels);
  writeArray(folder / (number + ".material"), materials);
}

/** log.rawlog and labels/, from the parts. */
Census joinParts(const fs::path& folder, const PartStore& parts, size_t count)
{
  const fs::path labels = folder / "labels";
  std::error_code failed;
  fs::create_directory(labels, failed);
  if (failed)
  {
    throw formats::FileError("make the folder", labels, failed.value());
  }
  Census census;
  formats::StreamedFile log(folder / "log.rawlog");
  for (size_t i = 0; i < count; ++i)
  {
    const Part part = parts.get(i);
    log.write(part.log);
    for (const std::vector<uint32_t>& turn : part.labels)
    {
      writeLabels(labels, turn, census);
    }
  }
  log.finish();
  log.commit();
  return census;
}

/** Quoted where it must be. */
std::string csvField(const std::string& text)
{
  if (text.find_first_of(",\"\n\r") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

std::string materialsOf(const simulation::Object& object)
{
  std::set<simulation::Material> all;
  for (const simulation::Part& part : object.parts)
  {
    all.insert(part.material);
  }
  for (const simulation::Ball& ball : object.balls)
  {
    all.insert(ball.material);
  }
  std::string text;
  for (const simulation::Material material : all)
  {
    text += fmt::format("{}{}", text.empty() ? "" : " ", nameOf(material));
  }
  return text;
}

/** The ground's label and material depend on the place: they stand with each point. */
std::string objectsCsv(const Scene& scene)
{
  std::string text = fmt::format(
      "number,name,label,material\n{},none,none,\n{},ground,ground,\n", Scene::kNoObject,
      Scene::kGround);
  for (size_t i = 0; i < scene.objects.size(); ++i)
  {
    const simulation::Object& object = scene.objects[i];
    text += fmt::format(
        "{},{},{},{}\n", Scene::kFirstObject + i, csvField(object.name), nameOf(object.label),
        materialsOf(object));
  }
  return text;
}

std::string metricsJson(const SimRun& run, const Scene& scene, const Census& census)
{
  Json json = {{"app", "traverse-sim"},         {"seed", run.seed},
               {"recording_s", run.duration_s}, {"objects", scene.objects.size()},
               {"turns", census.turns},         {"points", census.points}};
  Json observations = Json::object();
  for (const auto& [label, count] : run.observations)
  {
    observations[label] = count;
  }
  json["observations"] = observations;
  Json by_label = Json::object();
  for (size_t i = 0; i < census.by_label.size(); ++i)
  {
    if (census.by_label[i] > 0)
    {
      by_label[std::string(nameOf(static_cast<simulation::Label>(i)))] = census.by_label[i];
    }
  }
  json["points_by_label"] = by_label;
  return textOf(json) + "\n";
}
}  // namespace

std::string writeOutputs(
    formats::OutputFolder& folder,
    const PartStore& parts,
    const SimSettings& settings,
    const simulation::Recording& recording,
    const SimRun& run)
{
  const Census census = joinParts(folder.path(), parts, run.parts);
  folder.write("scene.ini", settings.text);
  folder.write("objects.csv", objectsCsv(settings.scene));
  folder.write("trajectory.tum", formats::tumTrajectory(recording.trajectory(kTrajectoryHz)));
  writeTruth(folder, settings, recording);
  folder.write(
      std::string(formats::OutputFolder::kLastFile), metricsJson(run, settings.scene, census));
  folder.commit();
  return fmt::format(
      "{}: {:.1f} s, {} turns, {} points\n", folder.finalPath().string(), run.duration_s,
      census.turns, census.points);
}
}  // namespace traverse::app
