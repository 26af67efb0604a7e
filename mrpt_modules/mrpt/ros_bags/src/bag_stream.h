// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bag_job.h"

#include <traverse/ros_bags/open_bag.h>

#include <memory>
#include <optional>
#include <vector>

namespace traverse::ros_bags
{
/** One pass over a bag, in the parent. A child that dies at a message is replaced by one that goes
 * on behind it, some times. */
class BagStream
{
 public:
  /** Throws importing::ImportError where the bag cannot be opened. */
  BagStream(
      std::filesystem::path file,
      const BagParams& params,
      BagSelection want,
      const std::atomic<bool>* stop);

  /** The next BagMessage, BagSkipped or BagUnreadable; nothing when it is over. The bytes of a
   * message are good until the next call. */
  std::optional<BagNews> next();

  /** What could not be read, beside BagUnreadable; empty where the pass came to its end. */
  const std::vector<std::string>& damage() const { return damage_; }

  double progress() const;

 private:
  void start();
  std::optional<BagNews> nextNews();
  std::optional<BagNews> take(const sandbox::Frame& frame);
  void failed(const std::string& why);

  std::filesystem::path file_;
  sandbox::ReaderLimits limits_;
  BagSelection want_;
  const std::atomic<bool>* stop_;
  sandbox::InputFile bag_;
  std::unique_ptr<sandbox::FrameStream> frames_;
  std::vector<std::string> damage_;
  uint64_t messages_ = 0;
  int deaths_ = 0;
  bool opened_ = false;
  bool over_ = false;
};
}  // namespace traverse::ros_bags
