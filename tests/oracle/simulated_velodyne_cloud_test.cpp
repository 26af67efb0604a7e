// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Simulated packets as @foxglove/velodyne-cloud decodes them, beside our decoder: the oracle that
// judges real packets. Slow: it needs node, npm and a registry.
#include "support/process.h"
#include "support/velodyne_cloud_check.h"

#include <gtest/gtest.h>

namespace traverse::testing
{
namespace
{
using sensors::VelodyneModel;

class SimulatedPackets : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    writeText(folder_ / "package.json", "{}");
    const Finished installed = run(
        {"npm", "install", "--prefix", folder_.path().string(), "@foxglove/velodyne-cloud@1.0.1"});
    if (installed.exit_code != 0)
    {
      GTEST_SKIP() << "SKIPPED: npm cannot install @foxglove/velodyne-cloud 1.0.1 here";
    }
    writeText(
        folder_ / "scene.ini",
        "[Scene]\nmin_x_m = -40\n[Object_00]\nkind = box\nx_m = 8\n[Drive]\nxs_m = 0\nys_m = 0\n"
        "duration_s = 0.35\n");
  }

  void expectAgreementOn(VelodyneModel model)
  {
    const std::string name(sensors::nameOf(model));
    const std::filesystem::path output = folder_ / name;
    const Finished made = run(
        {std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-sim", (folder_ / "scene.ini").string(),
         "--output", output.string(), "--set", "Lidar_00.model=" + name});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const std::filesystem::path log = output / "log.rawlog";
    const std::string script =
        std::string(TRAVERSE_SOURCE_DIR) + "/tests/oracle/velodyne_cloud/record.js";
    const std::string recorded = (folder_ / (name + ".csv")).string();
    const Finished node = run(
        {"sh", "-c",
         "cd '" + folder_.path().string() + "' && node '" + script + "' 500 '" + log.string() +
             "' '" + recorded + "'"});
    ASSERT_EQ(node.exit_code, 0) << node.err;
    expectAgreement({model, log, recorded});
  }

  ScratchFolder folder_;
};

TEST_F(SimulatedPackets, OfAnHdl32eAreDecodedAlike)
{
  expectAgreementOn(VelodyneModel::hdl32e);
}

TEST_F(SimulatedPackets, OfAVlp16AreDecodedAlike)
{
  expectAgreementOn(VelodyneModel::vlp16);
}

TEST_F(SimulatedPackets, OfAVlp32cAreDecodedAlike)
{
  expectAgreementOn(VelodyneModel::vlp32c);
}
}  // namespace
}  // namespace traverse::testing
