// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Our decoder against @foxglove/velodyne-cloud 1.0.1 on the packets of real sensors; how its output
// was recorded is in velodyne_cloud/README.md.
#include "support/velodyne_cloud_check.h"

namespace traverse::testing
{
namespace
{
using sensors::VelodyneModel;
using Case = VelodyneCloudCase;

class VelodyneCloud : public ::testing::TestWithParam<Case>
{
};

TEST_P(VelodyneCloud, AgreesOnEveryRecordedPoint)
{
  TRAVERSE_NEEDS(GetParam().packets);
  expectAgreement(GetParam());
}

std::filesystem::path recorded(const std::string& name)
{
  return std::filesystem::path(TRAVERSE_SOURCE_DIR) / "tests/oracle/velodyne_cloud" / name;
}

INSTANTIATE_TEST_SUITE_P(
    Captures,
    VelodyneCloud,
    ::testing::Values(
        Case{
            VelodyneModel::vlp16, mrptData("test_velodyne_VLP16.rawlog"),
            recorded("debian_vlp16.csv.gz")},
        Case{
            VelodyneModel::vlp16, sharedData("velodyne-pcap/sample_velodyne_vlp16_gps.pcap"),
            recorded("sample_vlp16.csv")},
        Case{
            VelodyneModel::hdl32e, sharedData("velodyne-pcap/sample_velodyne_hdl32.pcap"),
            recorded("sample_hdl32e.csv")},
        Case{
            VelodyneModel::vlp32c, sharedData("velodyne-pcap/nebula_vlp32c_front.pcap.gz"),
            recorded("nebula_vlp32c.csv")}),
    [](const auto& test) { return "Capture" + std::to_string(test.index); });

TEST(DebiansVlp16Scan, YieldsEveryRawReturn)
{
  const std::string file = mrptData("test_velodyne_VLP16.rawlog");
  TRAVERSE_NEEDS(file);
  const Capture capture = captureInRawlog(file);
  const auto views = capture.views();
  points::VelodyneInput input;
  input.packets = views;
  const points::Decoded decoded = points::decodeVelodyne(input);
  EXPECT_EQ(capture.packets.size(), 75U);
  EXPECT_EQ(decoded.scan.size(), 22591U) << "MRPT 2.5.8 yields 11,305 of them";
  EXPECT_EQ(decoded.rejects.of(points::Reject::no_return), 75U * 384U - 22591U);
  EXPECT_EQ(decoded.rejects.of(points::Reject::bad_packet), 0U);
}
}  // namespace
}  // namespace traverse::testing
