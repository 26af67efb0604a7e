// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/logs/log_reader.h>

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <support/scratch_folder.h>
#include <sys/resource.h>
#include <zlib.h>

// What damaged logs do to the reader, for the default and the slow tier.
namespace traverse::testing
{
struct DamagedReading
{
  size_t scans = 0;
  logs::LogReport report;
};

/** Reads with little memory and time, so that bombs go off soon. */
inline DamagedReading readDamaged(const std::string& bytes)
{
  const ScratchFolder dir;
  writeText(dir / "damaged.rawlog", bytes);
  // Depth images thinned out: in a build without optimisation they take seconds.
  observations::ObservationParams sensors;
  sensors.depth_image_step = 16;
  logs::LogReader reader(
      dir / "damaged.rawlog", {.reader_memory_mb = 256, .reader_timeout_s = 5}, sensors);
  DamagedReading reading;
  while (reader.next())
  {
    ++reading.scans;
  }
  reading.report = reader.report();
  return reading;
}

/** Largest resident size of this process so far, MiB. */
inline long peakMebibytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

/** Flips a bit anywhere from `first` on, or cuts the end off. */
inline std::string mutated(std::string bytes, size_t first, std::mt19937& random)
{
  const size_t at = first + random() % (bytes.size() - first);
  if (random() % 3 == 0)
  {
    bytes.resize(at);
    return bytes;
  }
  bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
  return bytes;
}

inline constexpr size_t kGzipHeader = 10;  // time and operating system in it may be anything

/** What a gzip file holds. */
inline std::string unpacked(const std::string& packed)
{
  z_stream zlib{};
  inflateInit2(&zlib, 16 + MAX_WBITS);
  std::string bytes(size_t{16} << 20U, '\0');
  zlib.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  zlib.avail_in = static_cast<uInt>(packed.size());
  zlib.next_out = reinterpret_cast<Bytef*>(bytes.data());
  zlib.avail_out = static_cast<uInt>(bytes.size());
  inflate(&zlib, Z_FINISH);
  bytes.resize(zlib.total_out);
  inflateEnd(&zlib);
  return bytes;
}

/** Mutations of a gzip log: every one is told, and none crashes or swells this process. */
inline void damageGzip(const std::string& packed, int seed, int mutations)
{
  std::mt19937 random(seed);
  for (int i = 0; i < mutations; ++i)
  {
    const std::string bytes = mutated(packed, kGzipHeader, random);
    const DamagedReading r = readDamaged(bytes);
    if (r.report.complete())
    {
      // A few bits between the data and their sum are padding.
      EXPECT_EQ(bytes.size(), packed.size()) << "seed " << seed << " mutation " << i;
      EXPECT_EQ(unpacked(bytes), unpacked(packed)) << "seed " << seed << " mutation " << i;
      continue;
    }
    EXPECT_NE(r.report.damage.find("damaged.rawlog: "), std::string::npos);
  }
}

/** Mutations of a plain log, which has no check sum: a flipped value may pass for a good one. Cuts
 * are told unless they lie between two objects. */
inline void damagePlain(const std::string& plain, int seed, int mutations)
{
  std::mt19937 random(seed);
  for (int i = 0; i < mutations; ++i)
  {
    const DamagedReading r = readDamaged(mutated(plain, 1, random));
    EXPECT_NE(r.report.end, logs::LogEnd::reading);
    EXPECT_EQ(r.report.complete(), r.report.damage.empty());
  }
}
}  // namespace traverse::testing
