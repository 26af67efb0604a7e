// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "log_walk.h"

#include <traverse/observations/convert.h>

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CSensoryFrame.h>

namespace traverse::logs
{
namespace
{
constexpr int kDeepest = 3;  // a log in a file, a frame in it, an observation in that

/** Their bodies are a number and so many objects. */
bool isContainer(const ObjectHeader& header)
{
  const std::string type = shortType(header.type);
  return (type == "CSensoryFrame" && header.version == 2) ||
         (type == "CActionCollection" && header.version == 0) ||
         (type == "CRawlog" && header.version <= 1);
}

/** What a rawlog may begin with; any other object of MRPT (a map, a scene) is some other file. */
bool belongsInLog(const ObjectHeader& header)
{
  using namespace mrpt::obs;  // NOLINT(google-build-using-namespace): CLASS_ID pastes bare names
  const mrpt::rtti::TRuntimeClassId* type = mrpt::rtti::findRegisteredClass(header.type);
  return isContainer(header) ||
         (type != nullptr &&
          (type->derivedFrom(CLASS_ID(CObservation)) || type->derivedFrom(CLASS_ID(CAction)) ||
           type->derivedFrom(CLASS_ID(CActionCollection)) ||
           type->derivedFrom(CLASS_ID(CSensoryFrame))));
}
}  // namespace

std::string shortType(const std::string& type)
{
  const size_t colon = type.rfind(':');
  return colon == std::string::npos ? type : type.substr(colon + 1);
}

void LogWalk::run()
{
  progress_.offset = archive_.source().offset();
  while (!listener_.done())
  {
    const auto header = archive_.readHeader();
    if (!header)
    {
      return;
    }
    if (progress_.object == 0 && !belongsInLog(*header))
    {
      throw LogDamage("it begins with an object of class '" + header->type + "'");
    }
    const bool whole_log = shortType(header->type) == "CRawlog";
    walk(*header, 0);
    if (!whole_log)
    {
      listener_.entryEnd();
      ++progress_.object;
    }
  }
}

void LogWalk::walk(const ObjectHeader& header, int depth)
{
  if (depth > kDeepest)
  {
    throw LogDamage("objects within objects, deeper than any log has them");
  }
  if (isContainer(header))
  {
    walkChildren(header, depth);
    return;
  }
  if (shortType(header.type) == "CActionRobotMovement2D")
  {
    listener_.movement(readMovement2D(archive_, header));
    return;
  }
  readLeaf(header);
}

void LogWalk::walkChildren(const ObjectHeader& header, int depth)
{
  const bool whole_log = shortType(header.type) == "CRawlog";
  // A whole log is followed by its comment, which is one object more.
  const uint64_t children = uint64_t{archive_.ReadAs<uint32_t>()} + (whole_log ? 1 : 0);
  for (uint64_t i = 0; i < children; ++i)
  {
    if (whole_log && listener_.done())
    {
      return;
    }
    const auto child = archive_.readHeader();
    if (!child)
    {
      throw LogDamage("the file is cut short within an object");
    }
    walk(*child, depth + 1);
    if (whole_log)
    {
      listener_.entryEnd();
      ++progress_.object;
    }
  }
  archive_.readEndMark(header);
  if (shortType(header.type) == "CSensoryFrame")
  {
    listener_.frameEnd();
  }
}

void LogWalk::readLeaf(const ObjectHeader& header)
{
  const auto object = ObjectArchive::create(header);
  archive_.readBody(object.get(), header);
  if (object)
  {
    tell(object, header.type);
  }
}

void LogWalk::tell(const mrpt::serialization::CSerializable::Ptr& object, const std::string& type)
{
  if (const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(object))
  {
    listener_.observation(observation);
  }
  else if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
  {
    for (const auto& one : *frame)  // of an old version, which MRPT read as a whole
    {
      if (one)
      {
        listener_.observation(one);
      }
    }
    listener_.frameEnd();
  }
  else if (const auto turn = std::dynamic_pointer_cast<mrpt::obs::CActionRobotMovement3D>(object))
  {
    listener_.movement(
        {observations::toIsometry(turn->poseChange.mean), observations::toTime(turn->timestamp)});
  }
  else
  {
    listener_.other(shortType(type));
  }
}
}  // namespace traverse::logs
