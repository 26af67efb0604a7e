// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::formats
{
/** A text and its name, for messages "name:line: ...". */
struct NamedText
{
  std::string_view text;
  std::string name;
};

/** Reads a trajectory file, told by the number of columns of its first row:
 *  8: TUM, `t x y z qx qy qz qw`; t in seconds, metres, unit quaternion
 * 12: KITTI, the upper 3 rows of T_map_base, row by row; row i has time i of times_path
 * 13: KITTI with the frame's number before; frame i has time i of times_path
 *
 * '#' begins a comment; empty lines, tabs and CRLF do no harm; the locale does not matter. Times
 * are taken to the nanosecond without rounding through floating point. Poses come in the file's
 * order, as they are: PoseTrack sorts, and counts what is repeated or backward.
 *
 * Throws FileError where a file cannot be read, and FormatError with file and line for a wrong
 * number of columns, what is no finite number, a quaternion or matrix that is no rotation (to 1 %),
 * a position beyond 1e8 m, and times that do not match the rows. */
std::vector<poses::StampedPose> readTrajectory(
    const std::filesystem::path& path, const std::filesystem::path& times_path = {});

/** As readTrajectory, from texts; `times` is used by KITTI rows only. */
std::vector<poses::StampedPose> parseTrajectory(const NamedText& rows, const NamedText& times = {});

/** The trajectory as a TUM file; reading it back gives the same times, positions, and rotations to
 * 1e-15. */
std::string tumTrajectory(const std::vector<poses::StampedPose>& poses);
}  // namespace traverse::formats
