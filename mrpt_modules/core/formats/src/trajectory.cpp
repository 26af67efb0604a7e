// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/decimal.h>
#include <traverse/formats/safe_file.h>
#include <traverse/formats/trajectory.h>
#include <traverse/geometry/lattice.h>
#include <traverse/options/untrusted_text.h>

#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace traverse::formats
{
namespace
{
using poses::StampedPose;

constexpr size_t kTumColumns = 8;
constexpr size_t kKittiColumns = 12;
constexpr size_t kLargestFile = size_t{1} << 30U;
constexpr double kRotationTolerance = 0.01;  // files print three digits and more

struct Row
{
  size_t line = 0;
  std::vector<std::string_view> words;
};

/** The word for a message: short, printable. */
std::string shown(std::string_view word)
{
  constexpr size_t kLongest = 40;
  return options::printable(word, kLongest);
}

[[noreturn]] void fail(const NamedText& in, size_t line, const std::string& problem)
{
  throw FormatError(fmt::format("{}:{}: {}", in.name, line, problem));
}

std::vector<std::string_view> wordsOf(std::string_view line)
{
  constexpr const char* kSpace = " \t\r\v\f";
  std::vector<std::string_view> words;
  line = line.substr(0, line.find('#'));
  for (size_t begin = line.find_first_not_of(kSpace); begin != std::string_view::npos;)
  {
    const size_t end = line.find_first_of(kSpace, begin);
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kSpace, end);
  }
  return words;
}

/** Calls f(row) for each line that has words. */
void forEachRow(const NamedText& in, const std::function<void(const Row&)>& f)
{
  std::string_view rest = in.text;
  for (size_t line = 1; !rest.empty(); ++line)
  {
    const size_t end = rest.find('\n');
    const Row row{line, wordsOf(rest.substr(0, end))};
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    if (!row.words.empty())
    {
      f(row);
    }
  }
}

poses::TimeNs time(const NamedText& in, const Row& row, size_t word)
{
  const auto ns = parseSecondsAsNs(row.words[word]);
  if (!ns)
  {
    fail(in, row.line, fmt::format("'{}' is no time in seconds", shown(row.words[word])));
  }
  return *ns;
}

template <int N>
Eigen::Matrix<double, N, 1> numbers(const NamedText& in, const Row& row, size_t first)
{
  Eigen::Matrix<double, N, 1> values;
  for (int i = 0; i < N; ++i)
  {
    const std::string_view word = row.words[first + static_cast<size_t>(i)];
    const auto value = parseNumber(word);
    if (!value)
    {
      fail(in, row.line, fmt::format("'{}' is no finite number", shown(word)));
    }
    values[i] = *value;
  }
  return values;
}

StampedPose pose(
    const NamedText& in,
    const Row& row,
    poses::TimeNs time_ns,
    const Eigen::Vector3d& position,
    const Eigen::Quaterniond& rotation)
{
  if (position.cwiseAbs().maxCoeff() > geometry::kFarthest_m)
  {
    fail(in, row.line, "the position is beyond 1e8 m");
  }
  StampedPose stamped;
  stamped.time = time_ns;
  stamped.T_map_base.linear() = rotation.normalized().toRotationMatrix();
  stamped.T_map_base.translation() = position;
  return stamped;
}

StampedPose tumPose(const NamedText& in, const Row& row)
{
  const auto v = numbers<7>(in, row, 1);
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (std::abs(q.norm() - 1) > kRotationTolerance)
  {
    fail(in, row.line, fmt::format("the quaternion has length {:.4g}, not 1", q.norm()));
  }
  return pose(in, row, time(in, row, 0), v.head<3>(), q);
}

StampedPose kittiPose(const NamedText& in, const Row& row, poses::TimeNs time_ns)
{
  const auto v = numbers<12>(in, row, row.words.size() - kKittiColumns);
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> T(v.data());
  const Eigen::Matrix3d R = T.leftCols<3>();
  const double error = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error < kRotationTolerance) || R.determinant() < 0)
  {
    fail(in, row.line, "the first three columns of the 3x4 matrix are no rotation");
  }
  return pose(in, row, time_ns, T.col(3), Eigen::Quaterniond(R));
}

std::vector<poses::TimeNs> parseTimes(const NamedText& in)
{
  std::vector<poses::TimeNs> times;
  forEachRow(
      in,
      [&](const Row& row)
      {
        if (row.words.size() != 1)
        {
          fail(in, row.line, fmt::format("{} words, a time is one", row.words.size()));
        }
        times.push_back(time(in, row, 0));
      });
  return times;
}

/** Takes rows one by one; the first one tells the format. */
class Parser
{
 public:
  Parser(const NamedText& rows, const NamedText& times) : rows_(rows), times_(times) {}

  void add(const Row& row)
  {
    if (columns_ == 0)
    {
      begin(row);
    }
    if (row.words.size() != columns_)
    {
      fail(
          rows_, row.line,
          fmt::format("{} columns, the rows before have {}", row.words.size(), columns_));
    }
    poses_.push_back(
        columns_ == kTumColumns ? tumPose(rows_, row) : kittiPose(rows_, row, kittiTime(row)));
  }

  std::vector<StampedPose> finish()
  {
    if (poses_.empty())
    {
      throw FormatError(rows_.name + ": no pose in it");
    }
    if (columns_ == kKittiColumns && poses_.size() != time_of_.size())
    {
      throw FormatError(fmt::format(
          "{} has {} rows, but {} has {} times", rows_.name, poses_.size(), times_.name,
          time_of_.size()));
    }
    return std::move(poses_);
  }

 private:
  void begin(const Row& row)
  {
    columns_ = row.words.size();
    if (columns_ == kTumColumns)
    {
      return;
    }
    if (columns_ != kKittiColumns && columns_ != kKittiColumns + 1)
    {
      fail(rows_, row.line, fmt::format("{} columns: TUM has 8, KITTI 12 or 13", columns_));
    }
    if (times_.name.empty())
    {
      fail(rows_, row.line, "KITTI rows need a file of times");
    }
    time_of_ = parseTimes(times_);
  }

  /** Of the row's own number, or of the frame that it names. */
  poses::TimeNs kittiTime(const Row& row) const
  {
    const size_t i = columns_ == kKittiColumns ? poses_.size() : frameNumber(row);
    if (i >= time_of_.size())
    {
      fail(
          rows_, row.line,
          fmt::format(
              "no time for row or frame {}: {} has {} times", i, times_.name, time_of_.size()));
    }
    return time_of_[i];
  }

  size_t frameNumber(const Row& row) const
  {
    const auto frame = parseNumber(row.words[0]);
    if (!frame || *frame < 0 || *frame != std::floor(*frame) || *frame > 1e9)
    {
      fail(rows_, row.line, fmt::format("'{}' is no frame number", shown(row.words[0])));
    }
    return static_cast<size_t>(*frame);
  }

  const NamedText& rows_;
  const NamedText& times_;
  size_t columns_ = 0;
  std::vector<poses::TimeNs> time_of_;
  std::vector<StampedPose> poses_;
};
}  // namespace

std::vector<StampedPose> parseTrajectory(const NamedText& rows, const NamedText& times)
{
  Parser parser(rows, times);
  forEachRow(rows, [&](const Row& row) { parser.add(row); });
  return parser.finish();
}

std::vector<StampedPose> readTrajectory(
    const std::filesystem::path& path, const std::filesystem::path& times_path)
{
  const std::string rows = readFile(path, kLargestFile);
  const std::string times = times_path.empty() ? "" : readFile(times_path, kLargestFile);
  return parseTrajectory({rows, path.string()}, {times, times_path.string()});
}

std::string tumTrajectory(const std::vector<StampedPose>& poses)
{
  constexpr uint64_t kNsPerSecond = 1'000'000'000;
  std::string text = "# t x y z qx qy qz qw\n";
  for (const StampedPose& p : poses)
  {
    const Eigen::Quaterniond q(p.T_map_base.linear());
    const Eigen::Vector3d t = p.T_map_base.translation();
    const uint64_t ns = p.time < 0 ? 0 - static_cast<uint64_t>(p.time) : uint64_t(p.time);
    text += fmt::format(
        "{}{}.{:09} {} {} {} {} {} {} {}\n", p.time < 0 ? "-" : "", ns / kNsPerSecond,
        ns % kNsPerSecond, t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }
  return text;
}
}  // namespace traverse::formats
