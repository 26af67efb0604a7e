// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "external_files.h"

#include "decoders.h"

#include <mrpt/io/lazy_load_path.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>

namespace traverse::observations
{
namespace
{
namespace fs = std::filesystem;
constexpr uintmax_t kLargest = uintmax_t{256} << 20U;

/** MRPT knows one folder for the whole process; set while we load. */
class LazyLoadFolder
{
 public:
  explicit LazyLoadFolder(const fs::path& folder) : before_(mrpt::io::getLazyLoadPathBase())
  {
    mrpt::io::setLazyLoadPathBase(folder.string());
  }

  ~LazyLoadFolder() { mrpt::io::setLazyLoadPathBase(before_); }

  LazyLoadFolder(const LazyLoadFolder&) = delete;
  LazyLoadFolder& operator=(const LazyLoadFolder&) = delete;

 private:
  std::string before_;
};

void checkName(const std::string& name)
{
  const fs::path path(name);
  const bool climbs =
      std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
  // MRPT also takes "C:..." for an absolute name.
  if (name.empty() || path.is_absolute() || climbs || name.find('\0') != std::string::npos ||
      name.find(':') != std::string::npos || name.find('\\') != std::string::npos)
  {
    throw Refused("it names a file outside its image folder");
  }
}

void checkFile(const fs::path& folder, const std::string& name)
{
  checkName(name);
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error)
  {
    throw Refused("the folder of its images is missing");
  }
  const fs::path file = fs::canonical(root / name, error);
  if (error)
  {
    throw Refused("a file that it names is missing in its image folder");
  }
  const auto [end, ignored] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
  if (end != root.end())
  {
    throw Refused("it names a file outside its image folder");
  }
  if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > kLargest)
  {
    throw Refused("a file that it names is no plain file of at most 256 MiB");
  }
}

/** Frees what load() read. MRPT's CObservationPointCloud::unload() would *write* the cloud to a
 * file of the log's choice, relative to the working folder; so its cloud is dropped by hand. */
void release(const mrpt::obs::CObservation& observation)
{
  if (const auto* cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud*>(&observation))
  {
    const_cast<mrpt::obs::CObservationPointCloud*>(cloud)
        ->pointcloud.reset();  // load() filled it, const too
    return;
  }
  observation.unload();
}
}  // namespace

ExternalFiles::ExternalFiles(
    const mrpt::obs::CObservation& observation,
    const std::vector<std::string>& names,
    const fs::path& folder)
{
  if (names.empty())
  {
    return;
  }
  const fs::path from = folder.empty() ? fs::path(mrpt::io::getLazyLoadPathBase()) : folder;
  for (const std::string& name : names)
  {
    checkFile(from, name);
  }
  const LazyLoadFolder scope(from);
  observation.load();
  loaded_ = &observation;
}

ExternalFiles::~ExternalFiles()
{
  if (loaded_ == nullptr)
  {
    return;
  }
  try
  {
    release(*loaded_);
  }
  catch (const std::exception&)
  {
    // It keeps its memory until it dies itself: a pity, no fault.
    loaded_ = nullptr;
  }
}
}  // namespace traverse::observations
