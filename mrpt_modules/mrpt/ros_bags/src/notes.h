// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/importing/source.h>
#include <traverse/options/untrusted_text.h>

#include <map>
#include <set>
#include <string>

namespace traverse::ros_bags
{
/** The report of an import. Names and texts out of a bag are shown escaped, and neither their
 * length nor their number fills the memory. */
class Notes
{
 public:
  void imported(const std::string& what) { options::countBounded(report_.imported, what); }

  void skipped(const std::string& reason, uint64_t n = 1)
  {
    options::countBounded(report_.skipped, reason, n);
  }

  /** Each text is told once. */
  void warn(const std::string& text);

  void damage(const std::string& text);

  const importing::ImportReport& report() const { return report_; }

 private:
  importing::ImportReport report_;
  std::set<std::string> told_;
};
}  // namespace traverse::ros_bags
