// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/observations/convert.h>

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/CSerializable.h>

#include <string>
#include <zlib.h>

// Logs that tests write with MRPT itself.
namespace traverse::testing
{
inline constexpr poses::TimeNs kLogStart = 1'600'000'000'000'000'000;

/** An object as it stands in a plain rawlog. */
inline std::string serialised(const mrpt::serialization::CSerializable& object)
{
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  return {
      static_cast<const char*>(stream.getRawBufferData()),
      static_cast<size_t>(stream.getTotalBytesCount())};
}

/** One gzip member. */
inline std::string gzipped(const std::string& bytes)
{
  z_stream zlib{};
  deflateInit2(&zlib, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&zlib, bytes.size()) + 64, '\0');
  zlib.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  zlib.avail_in = static_cast<uInt>(bytes.size());
  zlib.next_out = reinterpret_cast<Bytef*>(packed.data());
  zlib.avail_out = static_cast<uInt>(packed.size());
  deflate(&zlib, Z_FINISH);
  packed.resize(zlib.total_out);
  deflateEnd(&zlib);
  return packed;
}

/** 181 beams over half a turn, every one at `range_m`. */
inline mrpt::obs::CObservation2DRangeScan laserScan(double t_s, float range_m = 5)
{
  mrpt::obs::CObservation2DRangeScan scan;
  scan.sensorLabel = "LASER";
  scan.timestamp = observations::toTimePoint(kLogStart + static_cast<poses::TimeNs>(t_s * 1e9));
  scan.resizeScanAndAssign(181, range_m, true);
  return scan;
}

/** A plain log of n different scans, 0.1 s apart. */
inline std::string laserLog(int n)
{
  std::string log;
  for (int i = 0; i < n; ++i)
  {
    log += serialised(laserScan(0.1 * i, 5.0F + 0.01F * static_cast<float>(i)));
  }
  return log;
}
}  // namespace traverse::testing
