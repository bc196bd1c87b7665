// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/simulate_options.h"

#include <gmock/gmock.h>

namespace boresight::ctl {
namespace {

using testing::HasSubstr;

Result<SimulateOptions> parse(const std::vector<std::string>& arguments)
{
    return parseSimulateOptions(arguments);
}

std::string refusal(const std::vector<std::string>& arguments)
{
    const auto parsed = parse(arguments);
    return parsed ? "accepted" : parsed.error().text;
}

TEST(SimulateOptions, AreReadInAnyOrderWithBlankOrEquals)
{
    const auto options =
        parse({"--wind", "-30", "--az-id=7", "--duplicate-id", "--pty", "/tmp/mount", "--print-truth"});
    ASSERT_TRUE(options) << options.error().text;
    EXPECT_EQ(options->pty, "/tmp/mount");
    EXPECT_EQ(options->azimuthId, 7);
    EXPECT_TRUE(options->printTruth);
    ASSERT_EQ(options->injections.size(), 2u);
    EXPECT_EQ(options->injections[0].value, -30.0);
    EXPECT_EQ(options->injections[1].kind, sim::FaultKind::DuplicateId);
}

TEST(SimulateOptions, ASensorHasAFileOfItsOwn)
{
    EXPECT_EQ(parse({"--pty", "/tmp/m", "--sensor", "/tmp/s"})->sensor, "/tmp/s");
    EXPECT_FALSE(parse({"--pty", "/tmp/m", "--sensor", "/tmp/m"}));
    EXPECT_FALSE(parse({"--pty", "/tmp/m", "--sensor"}));
}

TEST(SimulateOptions, ChooseThePair)
{
    const sim::PairSettings ready = parse({"--pty", "p"})->pairSettings();
    EXPECT_EQ(ready.azimuth.config.id, 1);
    EXPECT_EQ(ready.elevation.config.id, 2);
    EXPECT_TRUE(ready.azimuth.referenced);
    const sim::PairSettings factory = parse({"--pty", "p", "--factory", "--el-id", "5"})->pairSettings();
    EXPECT_EQ(factory.azimuth.config.id, 1);
    EXPECT_EQ(factory.elevation.config.id, 5);
    EXPECT_FALSE(factory.elevation.referenced);
}

TEST(SimulateOptions, RefuseWithTheOptionsName)
{
    EXPECT_THAT(refusal({}), HasSubstr("either --pty PATH or --can IFACE"));
    EXPECT_THAT(refusal({"--pty", "p", "--can", "vcan0"}), HasSubstr("either --pty PATH or --can IFACE"));
    EXPECT_THAT(refusal({"--pty", "--factory"}), HasSubstr("--pty needs a value"));
    EXPECT_THAT(refusal({"--pty", "p", "--az-id", "127"}), HasSubstr("--az-id \"127\": expected an id, 1…126"));
    EXPECT_THAT(refusal({"--pty", "p", "--factory=yes"}), HasSubstr("--factory takes no value"));
    EXPECT_THAT(refusal({"--pty", "p", "--gremlins"}), HasSubstr("there is no option --gremlins"));
    EXPECT_THAT(refusal({"p"}), HasSubstr("what is \"p\"?"));
    EXPECT_THAT(refusal({"--pty", "p", "--wind"}), HasSubstr("--wind : the value is missing"));
    EXPECT_THAT(refusal({"--can", "vcan0", "--bus-off", "@5"}), HasSubstr("need --pty"));
}

}  // namespace
}  // namespace boresight::ctl
