// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl on real CAN interfaces. It needs vcan0 and vcan1, up and with CAN-FD.
#include "tests/fakes/program.h"

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::HasSubstr;

fakes::Program scanOf(const char* bus)
{
    return {QStringLiteral(BORESIGHTCTL), {QStringLiteral("scan"), QString::fromUtf8(bus)}};
}

TEST(SimulateOnCan, IsFoundByScanAndEndsCleanly)
{
    fakes::Program device(QStringLiteral(BORESIGHTCTL), {QStringLiteral("simulate"), QStringLiteral("--can"),
                                                         QStringLiteral("vcan0"), QStringLiteral("--az-id=33")});
    ASSERT_TRUE(device.waitForLine(QStringLiteral("ready"))) << device.errors().toStdString();
    auto scan = scanOf("socketcan:vcan0");
    EXPECT_EQ(scan.waitForEnd(), 0) << scan.errors().toStdString();
    EXPECT_THAT(scan.output().toStdString(), HasSubstr("\n2   626f7265-7369-6768-7420-73696d203032  1.1.0"));
    EXPECT_THAT(scan.output().toStdString(), HasSubstr("\n33  626f7265-7369-6768-7420-73696d203031  1.1.0"));
    device.terminate();
    EXPECT_EQ(device.waitForEnd(), 0);
}

TEST(SimulateOnCan, NobodyAnswersOnAnEmptyInterface)
{
    auto scan = scanOf("socketcan:vcan1");
    EXPECT_EQ(scan.waitForEnd(), 1);
    EXPECT_THAT(scan.errors().toStdString(), HasSubstr("no controller replied on socketcan:vcan1"));
}

TEST(SimulateOnCan, AnAbsentInterfaceIsNamed)
{
    auto scan = scanOf("socketcan:vcan7");
    EXPECT_EQ(scan.waitForEnd(), 1);
    EXPECT_THAT(scan.errors().toStdString(), HasSubstr("vcan7"));
}

}  // namespace
}  // namespace boresight
