// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/observations/serialised.h>

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

namespace traverse::observations
{
std::string serialised(const mrpt::obs::CObservation& observation)
{
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << observation;
  return {
      static_cast<const char*>(stream.getRawBufferData()),
      static_cast<size_t>(stream.getTotalBytesCount())};
}
}  // namespace traverse::observations
