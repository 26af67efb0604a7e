// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reader_job.h"

#include <filesystem>

namespace traverse::logs
{
/** Where a log's images and clouds lie. By MRPT's rule: beside `some.rawlog`, some_Images,
 * some_images, some_IMAGES, or else Images. (CRawlog::detectImagesDirectory() of 2.5.8 asks for
 * files of these names, and finds no folder.) */
std::filesystem::path imageFolder(const JobSettings& settings);
}  // namespace traverse::logs
