// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gdal_memory.h"

#include <traverse/formats/bytes.h>

#include <atomic>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <mutex>

namespace traverse::formats
{
QuietGdal::QuietGdal()
{
  CPLPushErrorHandler(CPLQuietErrorHandler);
  CPLErrorReset();
}

QuietGdal::~QuietGdal()
{
  CPLPopErrorHandler();
}

bool QuietGdal::failed() const
{
  return CPLGetLastErrorType() >= CE_Failure;
}

MemoryFile::MemoryFile(const char* ending)
{
  static std::atomic<unsigned> calls = 0;
  path_ = fmt::format("/vsimem/traverse-{}{}", calls++, ending);
}

MemoryFile::~MemoryFile()
{
  VSIUnlink(path_.c_str());
}

std::string MemoryFile::take() const
{
  vsi_l_offset size = 0;
  const GByte* bytes = VSIGetMemFileBuffer(path_.c_str(), &size, FALSE);
  return bytes == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(bytes), size);
}

GDALDriver& gdalDriver(const char* name)
{
  static std::once_flag registered;
  std::call_once(registered, GDALAllRegister);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name);
  if (driver == nullptr)
  {
    throw FormatError(fmt::format("GDAL has no {} driver", name));
  }
  return *driver;
}

bool setMapFrame(OGRSpatialReference& reference)
{
  return reference.SetFromUserInput(R"(LOCAL_CS["map",UNIT["metre",1]])") == OGRERR_NONE;
}
}  // namespace traverse::formats
