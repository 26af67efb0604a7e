// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "watched_navigator.h"

#include "grid_cache.h"
#include "simulated_clock.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/nav/reactive/CReactiveNavigationSystem.h>
#include <mrpt/nav/reactive/CReactiveNavigationSystem3D.h>

#include <stdexcept>

namespace traverse::reactive
{
namespace
{
using mrpt::nav::CReactiveNavigationSystem;
using mrpt::nav::CReactiveNavigationSystem3D;

/** The formulas that choose between trajectories are compiled in the first step, from what it
 * knows. With no trajectory to the target that is too little, and they never compile again
 * (ERR201 - Undefined symbol: 'target_d_norm'). So it is shown a place straight ahead first. */
void compileFormulas(mrpt::nav::CAbstractPTGBasedReactive& navigator, SensesInterface& senses)
{
  const SimulatedClock clock(0);
  Senses nothing;
  senses.show(nothing);
  mrpt::nav::TWaypointSequence ahead;
  const double distance_m = navigator.params_abstract_ptg_navigator.ref_distance / 2;
  ahead.waypoints.emplace_back(distance_m, 0, distance_m / 10, false);
  navigator.navigateWaypoints(ahead);
  navigator.navigationStep();
  const std::string error = senses.events().error;
  navigator.cancel();
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
}
}  // namespace

std::unique_ptr<WatchedNavigator> makeNavigator(
    Navigator kind,
    const std::string& ini,
    const std::filesystem::path& cache,
    SensesInterface& senses)
{
  std::unique_ptr<WatchedNavigator> made;
  if (kind == Navigator::flat)
  {
    made = std::make_unique<Watched<CReactiveNavigationSystem>>(senses);
  }
  else
  {
    made = std::make_unique<Watched<CReactiveNavigationSystem3D>>(senses);
  }
  auto& navigator = made->mrptNavigator();
  mrpt::config::CConfigFileMemory config;
  config.setContent(ini);
  navigator.loadConfigFile(config);
  GridCache grids(cache, ini);
  navigator.params_abstract_ptg_navigator.ptg_cache_files_directory = grids.folder().string();
  navigator.initialize();
  grids.keep();
  compileFormulas(navigator, senses);
  made->forgetPoses();
  return made;
}

void writeLog(WatchedNavigator& navigator, const std::filesystem::path& folder)
{
  std::filesystem::create_directories(folder);
  navigator.mrptNavigator().setLogFileDirectory(folder.string());
  navigator.mrptNavigator().enableLogFile(true);
  if (!navigator.isLogging())
  {
    throw std::runtime_error("cannot write a .reactivenavlog into " + folder.string());
  }
}
}  // namespace traverse::reactive
