// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/importing/import_params.h>
#include <traverse/importing/source.h>

#include <filesystem>
#include <memory>

// One pair for each format of the table in formats.cpp.
namespace traverse::importing
{
bool isKittiOdometry(const std::filesystem::path& input);
std::unique_ptr<Source> openKittiOdometry(const ImportParams& params);
bool isKittiRaw(const std::filesystem::path& input);
std::unique_ptr<Source> openKittiRaw(const ImportParams& params);
bool isArgoverse2(const std::filesystem::path& input);
std::unique_ptr<Source> openArgoverse2(const ImportParams& params);
bool isClouds(const std::filesystem::path& input);
std::unique_ptr<Source> openClouds(const ImportParams& params);
bool isPcap(const std::filesystem::path& input);
std::unique_ptr<Source> openPcap(const ImportParams& params);
bool isTumRgbd(const std::filesystem::path& input);
std::unique_ptr<Source> openTumRgbd(const ImportParams& params);
bool isSevenScenes(const std::filesystem::path& input);
std::unique_ptr<Source> openSevenScenes(const ImportParams& params);
}  // namespace traverse::importing
