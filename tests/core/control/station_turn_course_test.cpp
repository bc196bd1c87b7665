// SPDX-License-Identifier: GPL-3.0-or-later
// The turning seen by a sensor on the antenna, as evidence for the wrap of the azimuth.
#include "tests/core/control/station_rig.h"

#include <gmock/gmock.h>

#include <cmath>

namespace boresight {
namespace {

using testing::HasSubstr;

// The sensor has seen the azimuth go to 400°. Then the drive lost power for a moment, and it knows its direction only
// within a multiple of 3.6°. The journal says 400°.
struct SensedRig : StationRig
{
    SensedRig()
    {
        sense(0_deg);
        run(Seconds(0.5));
        EXPECT_TRUE(ask(request::PointAxes{{400_deg, 45_deg}}));
        settle();
        sense(400_deg);
        run(Seconds(0.2));
    }

    // The sensor reads true azimuths, with a deviation of some degrees.
    void sense(Angle axis)
    {
        course.azimuth = axis + 37_deg + 6_deg;
        control.setSensor(course.azimuth.wrapped360(), std::nullopt);
        mount.setCourse(course);
    }
    void cutPower()
    {
        azimuth.silent = elevation.silent = true;
        run(Seconds(0.5));
        azimuth.home = moteus::HomeState::Rotor;
        azimuth.position = std::remainder(azimuth.position, 0.01);
        azimuth.mode = elevation.mode = moteus::Mode::Stopped;
        azimuth.silent = elevation.silent = false;
        drive_check::DriveFacts restarted = factsOf(Axis::Azimuth);
        restarted.bootedAt = clock.now();
        learn(Axis::Azimuth, restarted);
        run(Seconds(2.0));
    }
    [[nodiscard]] TurnQuestion question() const
    {
        const auto asked = control.status().drives->azimuth.turnQuestion;
        EXPECT_TRUE(asked);
        return asked.value_or(TurnQuestion{});
    }
    // The evidence without its last sentence, which is about the heading of the sensor.
    [[nodiscard]] std::string turning() const
    {
        const auto evidence = question().evidence;
        return evidence.size() < 2 ? std::string() : evidence[evidence.size() - 2].toStdString();
    }

    SensorCourse course{.unbroken = 3, .azimuth = {}};
};

// REQ-WITNESS-46 (StationTurnCourse.*): A sensor that ran without a gap since the wrap of the azimuth was known shows,
// in the question about the wrap, how far it has turned. It cancels a proposal that it contradicts.
// REQ-MEMORY-09 (StationTurnCourse.*)
TEST(StationTurnCourse, AgreesWithTheJournalWhereNobodyTurnedTheMast)
{
    SensedRig rig;
    rig.cutPower();
    ASSERT_TRUE(rig.question().proposed) << "by the journal";
    EXPECT_NEAR(rig.question().proposed->degrees(), 400.0, 0.1);
    EXPECT_THAT(rig.turning(), HasSubstr("It shows 400.0° (± 30.0°). This agrees with the proposal."));
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown) << "it decides nothing";
}

TEST(StationTurnCourse, SpeaksAgainstTheJournalWhereItWasTurned)
{
    SensedRig rig;
    rig.cutPower();
    rig.sense(40_deg);
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.question().proposed);
    EXPECT_THAT(rig.turning(), HasSubstr("This contradicts 400.0°"));
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown);
    EXPECT_FALSE(rig.ask(request::PointAxes{{100_deg, 45_deg}})) << "nothing moves because of it";
    ASSERT_TRUE(rig.ask(request::ChooseTurn{Axis::Azimuth, 40_deg})) << "the operator decides";
    rig.run(Seconds(1.0));
    EXPECT_TRUE(rig.control.status().azimuth.turnKnown);
}

TEST(StationTurnCourse, ASensorThatWasRestartedMeanwhileSaysItsHeadingOnly)
{
    SensedRig rig;
    rig.cutPower();
    rig.course.unbroken = 4;
    rig.sense(40_deg);
    EXPECT_TRUE(rig.question().proposed);
    EXPECT_THAT(rig.turning(), testing::Not(HasSubstr("It shows")));
    EXPECT_THAT(rig.question().evidence.back().toStdString(), HasSubstr("The sensor reports 83.0°"));
    rig.control.setSensor(std::nullopt, std::nullopt);
    rig.mount.setCourse(std::nullopt);
    EXPECT_THAT(rig.question().evidence.back().toStdString(), HasSubstr("no sensor"));
}

TEST(StationTurnCourse, IsInTheLogWithTheQuestion)
{
    SensedRig rig;
    rig.cutPower();
    std::string text;
    for (const LogEntry& entry : rig.log.since(0, 100)) {
        text += entry.text.toStdString();
    }
    EXPECT_THAT(text, HasSubstr("The sensor followed the axis since the cable wrap was known"));
}

}  // namespace
}  // namespace boresight
