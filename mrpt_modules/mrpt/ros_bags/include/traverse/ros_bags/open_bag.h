// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/importing/source.h>
#include <traverse/options/option.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

namespace traverse::ros_bags
{
/** Section [Bag]: how a ROS 1 bag becomes a log. */
struct BagParams
{
  std::string base_frame;
  std::string topics;
  double reorder_s = 1.0;
  int reader_memory_mb = 2048;
  double reader_timeout_s = 30.0;

  friend bool operator==(const BagParams&, const BagParams&) = default;
};

template <class P, class F>
void visitBagParams(P& p, F&& f)
{
  using options::Option;
  f(
      Option{
          "base_frame",
          "tf frame of the vehicle, in which sensors have their poses; empty: base_link, "
          "base_footprint, base, vehicle, ..., the first that the bag's tf knows"},
      p.base_frame);
  f(Option{"topics", "topics to import, blanks between; empty: all"}, p.topics);
  f(
      Option{
          "reorder_s",
          "observations are put into the order of their stamps as far as they were recorded within "
          "this time, s",
          {0, 60}},
      p.reorder_s);
  f(
      Option{
          "reader_memory_mb",
          "memory that reading the bag may take, MiB; a bag that needs more counts as damaged",
          {64, 1048576}},
      p.reader_memory_mb);
  f(
      Option{
          "reader_timeout_s",
          "processor time that one message of the bag may take, s; then it counts as damaged",
          {0.1, 3600}},
      p.reader_timeout_s);
}

template <class F>
void visit(BagParams& p, F&& f)
{
  visitBagParams(p, f);
}

template <class F>
void visit(const BagParams& p, F&& f)
{
  visitBagParams(p, f);
}

/** True for a file that begins as a ROS 1 bag does; false for any other, also an unreadable one. */
bool looksLikeBag(const std::filesystem::path& file);

/** A ROS 1 bag as observations; README.md of this room says which message becomes what.
 *
 * ROS's reader runs in child processes: whatever stands in the file, this process neither crashes
 * nor grows. A first pass over the bag, done here, collects tf. `stop`, set from elsewhere, makes
 * waiting calls return soon (what is left counts as damage). Throws importing::ImportError where
 * the bag cannot be read at all, options::OptionError for bad params. */
std::unique_ptr<importing::Source> openBag(
    const std::filesystem::path& file,
    const BagParams& params,
    const std::atomic<bool>* stop = nullptr);
}  // namespace traverse::ros_bags
