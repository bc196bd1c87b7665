// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/simulated_sensor.h"

#include "core/orientation/correction.h"
#include "core/orientation/judge.h"
#include "core/orientation/sentence.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace boresight::sim {
namespace {

using AxesAt = std::function<AxisPosition(double second)>;

AxesAt standing(Angle azimuth, Angle elevation)
{
    return [=](double) { return AxisPosition{.azimuth = azimuth, .elevation = elevation}; };
}

struct SensorRig
{
    explicit SensorRig(const SensorTruth& truth = {.noise = Angle{}}) : sensor(truth) {}

    // The messages of this time, each with the second of its arrival.
    std::vector<SensorMessage> run(double seconds, const AxesAt& axes)
    {
        std::vector<SensorMessage> messages;
        arrivals.clear();
        for (const double end = second + seconds; second < end - 1e-9;) {
            clock.advance(SimulatedSensor::kReadingPeriod);
            second += 0.2;
            if (const auto message = sensor.read(clock.now(), clock.utc(), axes(second))) {
                messages.push_back(*message);
                arrivals.push_back(second);
            }
        }
        return messages;
    }

    fakes::ManualClock clock;
    SimulatedSensor sensor;
    double second = 0.0;
    std::vector<double> arrivals;
};

// REQ-SIM-15 (SimulatedSensor.*): The sensor on the antenna prints like its firmware, averages, counts turns, is
// deflected by iron, and fails on request.
TEST(SimulatedSensor, SpeaksAboutOnceASecondWhatIsRead)
{
    SensorRig rig;
    const auto messages = rig.run(10.0, standing(100_deg, 35_deg));
    ASSERT_NEAR(static_cast<double>(messages.size()), 10.0, 1.0);
    const auto value = orientation::parseSentence(toSentence(messages[0]).substr(0, toSentence(messages[0]).size() - 2),
                                                  rig.clock.now());
    ASSERT_TRUE(value) << toText(value.error());
    EXPECT_NEAR(value->heading.angle().degrees(), 100.0, 0.006);
    EXPECT_NEAR(value->elevation.degrees(), 35.0, 0.006);
    EXPECT_EQ(value->calibration->magnetometer, 3);
    EXPECT_EQ(value->temperature, 27.0);

    orientation::PayloadReader reader;
    for (const auto topic :
         {orientation::Topic::Calibration, orientation::Topic::Status, orientation::Topic::Orientation}) {
        const auto taken = reader.take(topic, toPayload(messages[0], topic), rig.clock.now());
        ASSERT_TRUE(taken) << toText(taken.error());
        if (*taken) {
            EXPECT_EQ((*taken)->extendedAzimuth, value->extendedAzimuth);
            EXPECT_EQ((*taken)->sensorTime, value->sensorTime);
            EXPECT_EQ((*taken)->calibration, value->calibration);
        }
    }
}

// The form that the firmware was observed to print.
TEST(SimulatedSensor, PrintsAsTheFirmwareDoes)
{
    const SensorMessage message{.time = UtcTime(std::chrono::milliseconds(1771493858412)),
                                .azimuth = -12.67,
                                .elevation = 19.13,
                                .revolutions = -1,
                                .temperature = 29,
                                .calibration = {3, 3, 3, 3}};
    EXPECT_EQ(toSentence(message), "$PATRK,1771493858412,ms,-12.67,dd,19.13,dd,-1,revs,29,c,3,3,3,3*3D\r\n");
    EXPECT_EQ(toPayload(message, orientation::Topic::Orientation).toStdString(),
              "{  \"dateTime\": \"Thursday, 19-Feb-2026 09:37:38 UTC\",  \"ts\": \"1771493858412\",  \"azimuth\": "
              "-12.67,  \"elevation\": 19.13,  \"revolutions\": -1,  \"units\": {    \"ts\": \"milliseconds\",    "
              "\"orientation\": \"decimal degrees\"  }}");
}

TEST(SimulatedSensor, CountsItsTurnsUntilItIsRestarted)
{
    SensorRig rig;
    const auto turning = rig.run(80.0, [](double second) {
        return AxisPosition{.azimuth = Angle::fromDegrees(350.0 + 10.0 * second), .elevation = 20_deg};
    });
    EXPECT_EQ(turning.front().revolutions, -1) << "the first heading is beyond 180";
    EXPECT_EQ(turning.back().revolutions, 2);
    EXPECT_GT(turning.back().azimuth, 720.0);
    rig.sensor.restart();
    EXPECT_EQ(rig.run(2.0, standing(100_deg, 20_deg)).back().revolutions, 0);
}

TEST(SimulatedSensor, ItsAzimuthIsAnAverageAndOld)
{
    SensorRig rig;
    const auto messages = rig.run(20.0, [](double second) {
        return AxisPosition{.azimuth = Angle::fromDegrees(10.0 + 6.0 * second),
                            .elevation = Angle::fromDegrees(10.0 + second)};
    });
    for (std::size_t i = 0; i < messages.size(); ++i) {
        const double arrival = rig.arrivals[i];
        EXPECT_NEAR(messages[i].azimuth, 10.0 + 6.0 * (arrival - 0.6), 0.02);
        EXPECT_NEAR(messages[i].elevation, 10.0 + (arrival - 0.2), 0.02);
    }
}

TEST(SimulatedSensor, WhatItHidesIsFoundByTheRightCorrection)
{
    SensorTruth truth{.noise = Angle{}};
    truth.mountingOffset = 37.4_deg;
    truth.elevationOffset = -2_deg;
    truth.faceDown = true;
    truth.declination = 12_deg;
    SensorRig rig(truth);
    const orientation::Correction right(
        {.sense = orientation::Sense::CounterClockwise, .azimuthOffset = 37.4_deg, .elevationOffset = -2_deg},
        {.by = geomagnetism::DeclinationBy::Boresight, .here = 12_deg});
    for (double azimuth = 3.0; azimuth < 360.0; azimuth += 60.0) {
        const auto message = rig.run(2.0, standing(Angle::fromDegrees(azimuth), 20_deg)).back();
        const auto heading = orientation::SensorHeading::folded(Angle::fromDegrees(message.azimuth));
        EXPECT_NEAR((right.trueHeading(heading) - Angle::fromDegrees(azimuth)).wrapped180().degrees(), 0.0, 0.01);
        EXPECT_NEAR(right.elevation(Angle::fromDegrees(message.elevation)).degrees(), 20.0, 0.01);
    }
}

TEST(SimulatedSensor, OneBehindTheBoomCountsDown)
{
    SensorTruth truth{.noise = Angle{}};
    truth.elevationDown = true;
    SensorRig rig(truth);
    EXPECT_NEAR(rig.run(2.0, standing(10_deg, 20_deg)).back().elevation, 160.0, 0.01);
    EXPECT_NEAR(rig.run(2.0, standing(10_deg, 50_deg)).back().elevation, 130.0, 0.01);
}

TEST(SimulatedSensor, IronAndALeaningMastShow)
{
    SensorTruth truth{.noise = Angle{}};
    truth.a1 = 8_deg;
    truth.b2 = 3_deg;
    truth.mount.tiltNorth = 0.6_deg;
    SensorRig rig(truth);
    const auto east = rig.run(2.0, standing(90_deg, Angle{})).back();
    EXPECT_NEAR(east.azimuth, 90.0 + 8.0 - 3.0, 0.02);
    const auto north = rig.run(3.0, standing(Angle{}, 20_deg)).back();
    EXPECT_NEAR(north.elevation, 20.0 - 0.6, 0.02);
}

TEST(SimulatedSensor, SteelTurnsItInASectorOnly)
{
    SensorRig rig({.steelFrom = 350_deg, .steelTo = 20_deg, .steel = 15_deg, .noise = Angle{}});
    const auto error = [&](double degrees) {
        const Angle azimuth = Angle::fromDegrees(degrees);
        return (Angle::fromDegrees(rig.run(3.0, standing(azimuth, 10_deg)).back().azimuth) - azimuth).wrapped180();
    };
    EXPECT_NEAR(error(349.0).degrees(), 0.0, 0.01);
    EXPECT_NEAR(error(351.0).degrees(), 15.0, 0.01);
    EXPECT_NEAR(error(19.0).degrees(), 15.0, 0.01);
    EXPECT_NEAR(error(21.0).degrees(), 0.0, 0.01);
}

TEST(SimulatedSensor, FailsOnRequest)
{
    SensorRig rig({.noise = 0.5_deg});
    const AxesAt axes = standing(100_deg, 20_deg);
    EXPECT_FALSE(rig.run(3.0, axes).empty());
    rig.sensor.setFault(SensorFault::Silent);
    EXPECT_TRUE(rig.run(5.0, axes).empty());
    rig.sensor.setFault(SensorFault::Dead);
    const std::string sentence = toSentence(rig.run(3.0, axes).back());
    const auto dead = orientation::parseSentence(sentence.substr(0, sentence.size() - 2), rig.clock.now());
    ASSERT_TRUE(dead);
    EXPECT_TRUE(orientation::isDeadMark(*dead));
    rig.sensor.setFault(SensorFault::None);
    rig.run(2.0, axes);
    rig.sensor.setFault(SensorFault::Frozen);
    const auto frozen = rig.run(5.0, standing(150_deg, 20_deg));
    EXPECT_EQ(frozen.front().azimuth, frozen.back().azimuth);
    EXPECT_LT(frozen.front().time, frozen.back().time);
}

}  // namespace
}  // namespace boresight::sim
