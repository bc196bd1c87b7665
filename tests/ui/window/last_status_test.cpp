// SPDX-License-Identifier: GPL-3.0-or-later
// The last status while the station is silent.
#include "ui/window/last_status.h"

#include "tests/fakes/manual_clock.h"
#include "tests/ui/sample_status.h"

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

using namespace std::chrono_literals;

class LastStatusTest : public ::testing::Test
{
protected:
    LastStatusTest()
    {
        StationStatus standing = samples::withAge(samples::idle(), 40ms);
        standing.alarms.clear();
        last.take(standing);
    }

    [[nodiscard]] std::vector<std::string> alarms() const
    {
        std::vector<std::string> names;
        for (const Alarm& alarm : last.now().alarms) {
            names.push_back(alarm.name.toStdString());
        }
        return names;
    }
    using Names = std::vector<std::string>;

    fakes::ManualClock clock;
    LastStatus last{clock};
};

TEST_F(LastStatusTest, IsWhatWasReceivedWhileItIsFresh)
{
    EXPECT_FALSE(last.ages());
    EXPECT_EQ(last.now().azimuth.age, 40ms);
    EXPECT_TRUE(last.now().permissions.allows(Action::SetAzimuth));
    EXPECT_EQ(alarms(), Names());
}

TEST_F(LastStatusTest, GrowsOlderWithTheSilence)
{
    const UtcTime received = last.received().utc;
    clock.advance(700ms);
    EXPECT_TRUE(last.ages());
    EXPECT_EQ(last.now().azimuth.age, 740ms);
    EXPECT_EQ(last.now().elevation.age, 740ms);
    EXPECT_EQ(last.now().drives->azimuth.readings.age, 712ms);
    EXPECT_EQ(last.now().utc, received + 700ms);
    EXPECT_EQ(last.received().azimuth.age, 40ms);
}

// REQ-WIND-51
TEST_F(LastStatusTest, TheWindGrowsOld)
{
    StationStatus windy = samples::idle();
    windy.wind = {.source = QStringLiteral("udp:4541"), .speed = 7.0, .age = Seconds(1.0)};
    last.take(windy);
    clock.advance(5s);
    EXPECT_EQ(last.now().wind.age, Seconds(6.0));
    EXPECT_FALSE(last.now().wind.isSilent);
    clock.advance(30s);
    EXPECT_TRUE(last.now().wind.isSilent);
}

TEST_F(LastStatusTest, AnOldPlaceIsNotUsed)
{
    clock.advance(700ms);
    const Permissions may = last.now().permissions;
    EXPECT_EQ(may.reason(Action::SetAzimuth), QStringLiteral("no fresh position from the azimuth drive"));
    EXPECT_EQ(may.reason(Action::SetElevation), QStringLiteral("no fresh position from the elevation drive"));
    EXPECT_FALSE(may.allows(Action::TakeKnownPoint));
    EXPECT_TRUE(may.allows(Action::Move)) << "the station judges that when it is asked";
}

// Story: while the station was silent the line of the energy and the progress of a run looked live.
TEST_F(LastStatusTest, WorkThatNobodyReportsIsNotShown)
{
    StationStatus status = last.received();
    status.power = {.total = 54.1, .running = MotionEnergy{.joules = 12.0}, .last = MotionEnergy{.joules = 3.0}};
    status.tuning = std::make_shared<const TuningStatus>(TuningStatus{.running = TuningRun::Step, .done = 0.4});
    status.drives->gearWork = {.running = true, .text = QStringLiteral("Storing the gear ratio.")};
    last.take(status);
    EXPECT_TRUE(last.now().power.total);
    clock.advance(2100ms);
    EXPECT_FALSE(last.now().power.total);
    EXPECT_FALSE(last.now().power.running);
    EXPECT_TRUE(last.now().power.last) << "that is over, whatever comes";
    EXPECT_FALSE(last.now().tuning->running);
    EXPECT_FALSE(last.now().drives->gearWork.running);
}

TEST_F(LastStatusTest, ReportsTheSilenceUntilTheNextStatus)
{
    clock.advance(1900ms);
    EXPECT_EQ(alarms(), Names());
    clock.advance(200ms);
    EXPECT_EQ(alarms(), Names{"window.station-silent"});
    last.take(last.received());
    EXPECT_EQ(alarms(), Names());
}

TEST_F(LastStatusTest, ReportsAStopThatIsNotConfirmed)
{
    last.stopAsked();
    EXPECT_TRUE(last.ages());
    EXPECT_EQ(alarms(), Names());
    clock.advance(1000ms);
    last.take(last.received());
    EXPECT_EQ(alarms(), Names{"window.stop-unconfirmed"}) << "the station is there and does not show it";
    StationStatus stopped = last.received();
    stopped.stopLatched = true;
    last.take(stopped);
    EXPECT_EQ(alarms(), Names());
    EXPECT_FALSE(last.ages());
    last.stopAsked();
    EXPECT_FALSE(last.ages()) << "it is latched already";
}

TEST_F(LastStatusTest, ARefusedStopIsAnswered)
{
    last.stopAsked();
    last.stopRefused();
    clock.advance(1500ms);
    last.take(last.received());
    EXPECT_EQ(alarms(), Names());
}

}  // namespace
}  // namespace boresight::ui
