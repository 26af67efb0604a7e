// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/importing/import_params.h>
#include <traverse/importing/source.h>

#include <functional>
#include <vector>

namespace traverse::importing
{
/** One observation to come. */
struct Step
{
  std::optional<poses::TimeNs> stamp;  //!< none: only the loaded observation tells
  std::function<Entry()> load;         //!< throws where its part of the input is damaged
};

/** A recording whose observations are known beforehand, and loaded one by one. */
class PlannedSource : public Source
{
 public:
  /** Steps are sorted by stamp where all have one. Throws ImportError where there is none. */
  PlannedSource(std::vector<Step> steps, ImportReport report, const ImportParams& params);

  std::optional<Entry> next() override;
  double progress() const override;

  const ImportReport& report() const override { return report_; }

 private:
  bool wanted(poses::TimeNs stamp);

  std::vector<Step> steps_;
  ImportReport report_;
  double from_s_;
  double to_s_;
  std::optional<poses::TimeNs> first_;
  size_t next_ = 0;
};

/** Counts an entry, and adds a line to what was damaged: both bounded. */
void countImported(const mrpt::obs::CObservation& observation, ImportReport& report);
void addDamage(const std::string& what, ImportReport& report);
}  // namespace traverse::importing
