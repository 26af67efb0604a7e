// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/maps/CTraversabilityGridMap.h>
#include <traverse/maps/CWrappableMultiLidarGrid.h>
#include <traverse/plugin/register.h>

#include <mrpt/core/initializer.h>
#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/rtti/CObject.h>

namespace
{
void registerOwnClasses()
{
  mrpt::rtti::registerClass(CLASS_ID_NAMESPACE(CTraversabilityGridMap, traverse::maps));
  mrpt::rtti::registerClass(CLASS_ID_NAMESPACE(CWrappableMultiLidarGrid, traverse::maps));
}
}  // namespace

namespace traverse::plugin
{
void registerAllMaps()
{
  mrpt::maps::registerAllClasses_mrpt_maps();
  registerOwnClasses();
}
}  // namespace traverse::plugin

MRPT_INITIALIZER(registerTraverseMaps)
{
  registerOwnClasses();
}
