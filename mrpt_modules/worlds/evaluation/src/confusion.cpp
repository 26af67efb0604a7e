// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "judged_cells.h"

#include <traverse/evaluation/confusion.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace traverse::evaluation
{
namespace
{
std::vector<std::string> namesOf(const std::vector<layers::LegendEntry>& legend)
{
  std::vector<std::string> names = {"undefined"};
  for (const layers::LegendEntry& entry : legend)
  {
    if (entry.code >= names.size())
    {
      names.resize(size_t{entry.code} + 1, "?");
    }
    if (entry.code > 0)
    {
      names[entry.code] = entry.name;
    }
  }
  return names;
}

ClassScore scoreOf(const Confusion& confusion, uint8_t code)
{
  ClassScore score;
  score.name = confusion.names()[code];
  for (size_t other = 0; other < confusion.names().size(); ++other)
  {
    const auto o = static_cast<uint8_t>(other);
    score.truth_cells += confusion.cells(code, o);
    score.found_cells += o == 0 ? 0 : confusion.cells(o, code);
  }
  score.right_cells = confusion.cells(code, code);
  score.recall = share(score.right_cells, score.truth_cells);
  score.precision = share(score.right_cells, score.found_cells);
  score.f1 = share(2 * score.right_cells, score.truth_cells + score.found_cells);
  score.iou = share(score.right_cells, score.truth_cells + score.found_cells - score.right_cells);
  return score;
}
}  // namespace

Confusion::Confusion(std::vector<std::string> names) :
    names_(std::move(names)), counts_(names_.size() * names_.size(), 0)
{
}

size_t Confusion::at(uint8_t truth, uint8_t found) const
{
  if (truth >= names_.size() || found >= names_.size())
  {
    throw std::out_of_range("a class that has no name");
  }
  return size_t{truth} * names_.size() + found;
}

void Confusion::add(uint8_t truth, uint8_t found)
{
  if (truth == 0)
  {
    throw std::out_of_range("undefined is no truth");
  }
  ++counts_[at(truth, found)];
}

uint64_t Confusion::cells(uint8_t truth, uint8_t found) const
{
  return counts_[at(truth, found)];
}

uint64_t Confusion::total() const
{
  return std::accumulate(counts_.begin(), counts_.end(), uint64_t{0});
}

Confusion& Confusion::operator+=(const Confusion& other)
{
  if (names_.empty())
  {
    names_ = other.names_;
    counts_.resize(other.counts_.size(), 0);
  }
  if (other.names_.empty())
  {
    left_out += other.left_out;
    return *this;
  }
  if (names_ != other.names_)
  {
    throw std::invalid_argument("counts of other classes cannot be added");
  }
  std::transform(
      counts_.begin(), counts_.end(), other.counts_.begin(), counts_.begin(), std::plus<>());
  left_out += other.left_out;
  return *this;
}

ClassScores scoresOf(const Confusion& confusion)
{
  ClassScores scores;
  uint64_t right = 0;
  double recalls = 0;
  uint64_t present = 0;
  for (size_t code = 1; code < confusion.names().size(); ++code)
  {
    scores.classes.push_back(scoreOf(confusion, static_cast<uint8_t>(code)));
    const ClassScore& score = scores.classes.back();
    right += score.right_cells;
    if (score.truth_cells > 0)
    {
      recalls += score.recall;
      ++present;
    }
  }
  scores.mean_accuracy = present == 0 ? std::numeric_limits<double>::quiet_NaN()
                                      : recalls / static_cast<double>(present);
  scores.accuracy = share(right, confusion.total());
  return scores;
}

Confusion confusionOf(
    const layers::LayerSet& map, const layers::LayerSet& truth, const ConfusionParams& params)
{
  const JudgedCells cells(map, truth, params);
  Confusion confusion(namesOf(truth.legend));
  forEachCell(
      truth.extent,
      [&](geometry::CellIndex c)
      {
        if (cells.judged(c))
        {
          confusion.add(cells.truth(c), cells.found(c));
        }
        else
        {
          ++confusion.left_out;
        }
      });
  return confusion;
}
}  // namespace traverse::evaluation
