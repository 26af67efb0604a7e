// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gdal_priv.h>
#include <memory>
#include <ogr_spatialref.h>
#include <string>

namespace traverse::formats
{
/** Keeps GDAL from printing, for this scope and thread; starts without an error. */
struct QuietGdal
{
  QuietGdal();
  ~QuietGdal();
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;

  /** Whether GDAL has noted a failure in this scope. */
  bool failed() const;
};

/** A file in GDAL's memory: there a full disk cannot be missed. */
class MemoryFile
{
 public:
  /** `ending` with its dot. */
  explicit MemoryFile(const char* ending);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const char* path() const { return path_.c_str(); }

  /** A copy of its bytes. */
  std::string take() const;

 private:
  std::string path_;
};

struct CloseDataset
{
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/** A driver by name; throws FormatError where GDAL was built without it. */
GDALDriver& gdalDriver(const char* name);

/** Metres of the map frame, which is not tied to the earth; false where GDAL refuses. */
bool setMapFrame(OGRSpatialReference& reference);
}  // namespace traverse::formats
