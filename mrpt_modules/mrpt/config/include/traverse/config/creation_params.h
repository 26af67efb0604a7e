// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

namespace traverse::config
{
/** Section creationOpts, which MRPT reads itself for every map; here to be checked and documented.
 */
struct CreationParams
{
  bool enable_save_as_3d_object = true;
  bool enable_observation_likelihood = true;
  bool enable_observation_insertion = true;
};

template <class P, class F>
void visitCreationParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"enablesaveas3dobject", "the map shows itself in the scenes of stock programs"},
    p.enable_save_as_3d_object);
  f(Option{"enableobservationlikelihood", "the map takes part in localisation"},
    p.enable_observation_likelihood);
  f(
      Option{
          "enableobservationinsertion",
          "the map takes observations (from stock programs; traverse-map always feeds it)"},
      p.enable_observation_insertion);
}

template <class F>
void visit(CreationParams& p, F&& f)
{
  visitCreationParams(p, f);
}

template <class F>
void visit(const CreationParams& p, F&& f)
{
  visitCreationParams(p, f);
}
}  // namespace traverse::config
