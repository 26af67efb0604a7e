// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "folders.h"

#include <traverse/formats/safe_file.h>
#include <traverse/importing/source.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace traverse::importing
{
namespace
{
namespace fs = std::filesystem;

bool endsWith(std::string_view text, std::string_view ending)
{
  return text.size() >= ending.size() && text.substr(text.size() - ending.size()) == ending;
}

bool hasEnding(std::string_view name, const std::vector<std::string>& endings)
{
  return std::any_of(
      endings.begin(), endings.end(),
      [&](const std::string& e) { return endsWith(name, e) || endsWith(name, e + ".gz"); });
}

bool isDigit(char c)
{
  return c >= '0' && c <= '9';
}

size_t digitsAt(std::string_view text, size_t at)
{
  size_t end = at;
  while (end < text.size() && isDigit(text[end]))
  {
    ++end;
  }
  return end - at;
}

/** Runs of digits compare as numbers, so that "9" comes before "10". */
bool before(const std::string& a, const std::string& b)
{
  size_t i = 0;
  size_t k = 0;
  while (i < a.size() && k < b.size())
  {
    const size_t n = digitsAt(a, i);
    const size_t m = digitsAt(b, k);
    if (n == 0 || m == 0)
    {
      if (a[i] != b[k])
      {
        return a[i] < b[k];
      }
      ++i;
      ++k;
      continue;
    }
    const size_t wide = std::max(n, m);
    const std::string number = std::string(wide - n, '0') + a.substr(i, n);
    const std::string other = std::string(wide - m, '0') + b.substr(k, m);
    if (number != other)
    {
      return number < other;
    }
    i += n;
    k += m;
  }
  return a.size() - i < b.size() - k;
}
}  // namespace

std::vector<fs::path> filesOf(const fs::path& folder, const std::vector<std::string>& endings)
{
  constexpr size_t kMostFiles = 10'000'000;
  std::vector<fs::path> files;
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
  {
    if (!hasEnding(entry.path().filename().string(), endings) || !entry.is_regular_file(failed))
    {
      continue;
    }
    if (files.size() == kMostFiles)
    {
      throw ImportError(folder.string() + ": has too many files");
    }
    files.push_back(entry.path());
  }
  std::sort(
      files.begin(), files.end(),
      [](const fs::path& a, const fs::path& b)
      { return before(a.filename().string(), b.filename().string()); });
  return files;
}

bool hasFiles(const fs::path& folder, const std::vector<std::string>& endings)
{
  std::error_code failed;
  const fs::directory_iterator all(folder, failed);
  return std::any_of(
      fs::begin(all), fs::end(all),
      [&](const fs::directory_entry& entry)
      { return hasEnding(entry.path().filename().string(), endings); });
}

std::string stemOf(const fs::path& file)
{
  const fs::path name = file.filename();
  return name.extension() == ".gz" ? name.stem().stem().string() : name.stem().string();
}

std::optional<fs::path> plainOrGz(const fs::path& file)
{
  std::error_code failed;
  if (fs::exists(file, failed))
  {
    return file;
  }
  const fs::path packed = file.string() + ".gz";
  return fs::exists(packed, failed) ? std::optional(packed) : std::nullopt;
}

Eigen::Isometry3d rigidMotion(
    const Eigen::Matrix3d& R, const Eigen::Vector3d& t, const std::string& what)
{
  const bool rotation = R.allFinite() &&
                        (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 0.01 &&
                        R.determinant() > 0;
  if (!rotation || !t.allFinite() || t.norm() > 1e8)
  {
    throw ImportError(what + ": is no rigid motion");
  }
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  T.translation() = t;
  return T;
}

Eigen::Isometry3d rigidMotion(const std::vector<double>& rows, const std::string& what)
{
  if (rows.size() != 12)
  {
    throw ImportError(what + ": has not 12 numbers");
  }
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> M(rows.data());
  return rigidMotion(Eigen::Matrix3d(M.leftCols<3>()), Eigen::Vector3d(M.col(3)), what);
}

Eigen::Isometry3d rigidMotion(
    const Eigen::Vector4d& wxyz, const Eigen::Vector3d& t, const std::string& what)
{
  const Eigen::Quaterniond q(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  return rigidMotion(q.toRotationMatrix(), t, what);
}

Eigen::Isometry3d fromOptical()
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return T;
}
}  // namespace traverse::importing
