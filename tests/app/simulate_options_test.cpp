// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/simulate_options.h"

#include "tests/fakes/text_of.h"

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
    return parsed ? "accepted" : textOf(parsed.error());
}

TEST(SimulateOptions, AreReadInAnyOrderWithBlankOrEquals)
{
    const auto options =
        parse({"--wind", "-30", "--az-id=7", "--duplicate-id", "--pty", "/tmp/mount", "--print-truth"});
    ASSERT_TRUE(options) << textOf(options.error());
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

TEST(SimulateOptions, ASensorMayPublishAtABroker)
{
    EXPECT_EQ(parse({"--pty", "p", "--sensor-mqtt", "broker.example"})->sensorBroker,
              (mqtt::Broker{.host = QStringLiteral("broker.example"), .port = 1883}));
    EXPECT_EQ(parse({"--pty", "p", "--sensor-mqtt=[::1]:1884"})->sensorBroker,
              (mqtt::Broker{.host = QStringLiteral("::1"), .port = 1884}));
    EXPECT_EQ(parse({"--pty", "p", "--sensor-mqtt=[::1]"})->sensorBroker->port, 1883);
    EXPECT_EQ(parse({"--pty", "p", "--sensor-mqtt", "b", "--sensor-topics", "roof/"})->sensorTopics, "roof/");
    EXPECT_THAT(refusal({"--pty", "p", "--sensor-mqtt"}), HasSubstr("expected HOST[:PORT]"));
    EXPECT_THAT(refusal({"--pty", "p", "--sensor-mqtt", "b:0"}), HasSubstr("expected HOST[:PORT]"));
    EXPECT_THAT(refusal({"--pty", "p", "--sensor-mqtt", "b", "--sensor-topics", "roof/#"}), HasSubstr("+ or #"));
}

TEST(SimulateOptions, WhatTheSensorHidesIsTheOperatorsChoice)
{
    const sim::SensorTruth hidden = parse({"--pty", "p", "--sensor", "s"})->sensorTruth;
    EXPECT_EQ(hidden.mount.azimuthOffset, sim::truthToBeFound().mount.azimuthOffset);
    const auto options = parse({"--pty",
                                "p",
                                "--sensor",
                                "s",
                                "--sensor-north",
                                "-12",
                                "--sensor-tilt=0.5,-1",
                                "--sensor-mounting",
                                "3,-2",
                                "--sensor-deviation",
                                "1,2,3,-4",
                                "--sensor-noise",
                                "0",
                                "--sensor-per-ampere=0.2",
                                "--sensor-steel=200,230,15",
                                "--sensor-declination",
                                "7",
                                "--sensor-calibration",
                                "0,1,2,3",
                                "--sensor-orientation-only",
                                "--sensor-silence",
                                "@60+20"});
    ASSERT_TRUE(options) << textOf(options.error());
    const sim::SensorTruth& truth = options->sensorTruth;
    EXPECT_EQ(truth.mount.azimuthOffset, -12_deg);
    EXPECT_EQ(truth.mount.tiltNorth, 0.5_deg);
    EXPECT_EQ(truth.mount.tiltEast, -1_deg);
    EXPECT_EQ(truth.mount.collimation, hidden.mount.collimation);
    EXPECT_EQ(truth.mountingOffset, 3_deg);
    EXPECT_EQ(truth.elevationOffset, -2_deg);
    EXPECT_EQ((std::array{truth.a1, truth.b1, truth.a2, truth.b2}), (std::array{1_deg, 2_deg, 3_deg, -4_deg}));
    EXPECT_EQ(truth.noise, Angle());
    EXPECT_EQ(truth.perAmpere, 0.2_deg);
    EXPECT_EQ((std::array{truth.steelFrom, truth.steelTo, truth.steel}), (std::array{200_deg, 230_deg, 15_deg}));
    EXPECT_EQ(truth.declination, 7_deg);
    EXPECT_EQ(truth.calibration,
              (orientation::Calibration{.system = 0, .gyro = 1, .accelerometer = 2, .magnetometer = 3}));
    EXPECT_TRUE(options->orientationOnly);
    ASSERT_EQ(options->injections.size(), 1U);
    EXPECT_EQ(options->injections[0].kind, sim::FaultKind::SensorSilence);
}

TEST(SimulateOptions, OfASensorNeedOne)
{
    EXPECT_THAT(refusal({"--pty", "p", "--sensor-noise", "1"}), HasSubstr("--sensor-noise needs --sensor"));
    EXPECT_THAT(refusal({"--pty", "p", "--sensor-dead"}), HasSubstr("--sensor-dead needs --sensor"));
    EXPECT_THAT(refusal({"--pty", "p", "--sensor", "s", "--sensor-tilt", "1"}),
                HasSubstr("--sensor-tilt \"1\": expected NORTH,EAST, each -20…20"));
    EXPECT_THAT(refusal({"--pty", "p", "--sensor", "s", "--sensor-noise", "nan"}), HasSubstr("expected DEGREES"));
    EXPECT_THAT(refusal({"--pty", "p", "--sensor", "s", "--sensor-calibration", "3,3,3,4"}), HasSubstr("0…3"));
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
    EXPECT_THAT(refusal({}), HasSubstr("either --pty PATH, --can IFACE or --station"));
    EXPECT_THAT(refusal({"--pty", "p", "--can", "vcan0"}), HasSubstr("either --pty PATH, --can IFACE or --station"));
    EXPECT_THAT(refusal({"--pty", "--factory"}), HasSubstr("--pty needs a value"));
    EXPECT_THAT(refusal({"--pty", "p", "--az-id", "127"}), HasSubstr("--az-id \"127\": expected an id, 1…126"));
    EXPECT_THAT(refusal({"--pty", "p", "--factory=yes"}), HasSubstr("--factory takes no value"));
    EXPECT_THAT(refusal({"--pty", "p", "--gremlins"}), HasSubstr("there is no option --gremlins"));
    EXPECT_THAT(refusal({"p"}), HasSubstr("\"p\" is not an option."));
    EXPECT_THAT(refusal({"--pty", "p", "--wind"}), HasSubstr("--wind : the value is missing"));
    EXPECT_THAT(refusal({"--can", "vcan0", "--bus-off", "@5"}), HasSubstr("need --pty"));
}

// REQ-CTL-996: "simulate --station" shows faults on the mount of a running station, and takes nothing else.
TEST(SimulateOptions, ARunningStationTakesFaultsOnly)
{
    const auto options = parse({"--station", "localhost:4533", "--wind", "az:60+3", "--stall"});
    ASSERT_TRUE(options) << textOf(options.error());
    EXPECT_EQ(options->station->port, 4533);
    EXPECT_EQ(options->faults, (std::vector<std::string>{"wind az:60+3", "stall"}));
    EXPECT_TRUE(parse({"--station", "localhost:4533", "--end-faults"})->endFaults);
    EXPECT_TRUE(parse({"--station", "localhost:4533", "--bus-off"})) << "the simulated bus has an adapter";
    EXPECT_THAT(refusal({"--station", "localhost:4533"}), HasSubstr("needs a fault"));
    EXPECT_THAT(refusal({"--station", "localhost"}), HasSubstr("expected HOST:PORT"));
    EXPECT_THAT(refusal({"--station", "localhost:1", "--stall", "--pty", "p"}), HasSubstr("only"));
    EXPECT_THAT(refusal({"--station", "localhost:1", "--stall", "--sensor-north", "3"}), HasSubstr("only"));
    EXPECT_THAT(refusal({"--pty", "p", "--end-faults"}), HasSubstr("needs --station"));
}

}  // namespace
}  // namespace boresight::ctl
