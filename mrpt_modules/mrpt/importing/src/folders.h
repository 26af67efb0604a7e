// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <Eigen/Geometry>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What folders of recordings are made of.
namespace traverse::importing
{
/** Plain files of a folder that end in one of these (also with .gz behind), sorted by name, digits
 * as numbers. Throws ImportError beyond ten million. */
std::vector<std::filesystem::path> filesOf(
    const std::filesystem::path& folder, const std::vector<std::string>& endings);

bool hasFiles(const std::filesystem::path& folder, const std::vector<std::string>& endings);

/** The name without endings: "000001.bin.gz" -> "000001". */
std::string stemOf(const std::filesystem::path& file);

/** The file, or the same with .gz; nothing where there is neither. */
std::optional<std::filesystem::path> plainOrGz(const std::filesystem::path& file);

/** Text of a file of at most 256 MB, unpacked where it is gzip. Throws FileError, FormatError. */
std::string textOf(const std::filesystem::path& file);

/** "2011-09-26 13:02:25.594360375" as if it were UTC. */
std::optional<poses::TimeNs> parseCivilTime(std::string_view text);

/** The time in a name: digits of a clock since 1970, in seconds with a point or in s, ms, us, ns by
 * their number (10, 13, 16, 19; times of 1980 have one less). */
std::optional<poses::TimeNs> stampInName(const std::string& stem);

/** One time per line; nothing in lines that have none. */
std::vector<std::optional<poses::TimeNs>> civilTimesOf(const std::filesystem::path& file);

/** Numbers behind "KEY:" in a calibration file; other lines are skipped. */
using NamedNumbers = std::map<std::string, std::vector<double>>;
NamedNumbers namedNumbersOf(const std::filesystem::path& file);

/** All numbers of a text; throws FormatError for what is none. */
std::vector<double> numbersOf(std::string_view text);

/** A rigid motion; throws ImportError, with `what`, where the matrix is no rotation to 1 %. */
Eigen::Isometry3d rigidMotion(
    const Eigen::Matrix3d& R, const Eigen::Vector3d& t, const std::string& what);

/** Of 12 numbers, the upper rows of a matrix. */
Eigen::Isometry3d rigidMotion(const std::vector<double>& rows, const std::string& what);

/** Of a quaternion w x y z and a position. */
Eigen::Isometry3d rigidMotion(
    const Eigen::Vector4d& wxyz, const Eigen::Vector3d& t, const std::string& what);

/** Takes points of an optical frame (x right, y down, z forward) to x forward, y left, z up. */
Eigen::Isometry3d fromOptical();
}  // namespace traverse::importing
