// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/serialization/CArchive.h>

#include <memory>

namespace traverse::testing
{
/** What a program that reads the log would have. */
template <class T>
std::shared_ptr<T> throughALog(const T& observation)
{
  mrpt::maps::registerAllClasses_mrpt_maps();
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << observation;
  stream.Seek(0);
  return std::dynamic_pointer_cast<T>(archive.ReadObject());
}

}  // namespace traverse::testing
