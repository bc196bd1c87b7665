// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer_clock/clock_guard.h"

#include "core/alarms/catalogue.h"
#include "tests/fakes/manual_clock.h"

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class ClockGuardTest : public ::testing::Test
{
protected:
    ClockGuardTest() { tick(); }
    void tick()
    {
        clock.advance(Seconds(0.02));
        wasSet = guard.tick();
    }
    void secondLater()
    {
        clock.advance(Seconds(1.0));
        tick();
    }
    [[nodiscard]] std::vector<std::string> lines() const
    {
        std::vector<std::string> texts;
        for (const LogEntry& line : log.since(0, EventLog::kCapacity)) {
            if (line.alarm.name.isEmpty()) {
                texts.push_back(line.text.toStdString());
            }
        }
        return texts;
    }
    void track() { effect = {.moves = true, .shift = QStringLiteral("ISS would be 99.0° away")}; }
    [[nodiscard]] std::vector<std::string> alarmsShown() const
    {
        std::vector<std::string> texts;
        for (const Alarm& alarm : alarms.list()) {
            texts.push_back(alarm.what.toStdString());
        }
        return texts;
    }

    fakes::ManualClock clock;
    EventLog log{clock};
    AlarmBoard alarms{log, clock};
    TimeEffect effect;  // of a clock that was set
    bool wasSet = false;
    KeptClock kept{clock};
    ClockGuard guard{kept, log, alarms, [this](Seconds) { return effect; }};
};

// REQ-STATION-230: Setting the clock is a line in the log and an alarm, with the seconds. A small correction and the
// normal progress of time are not reported.
TEST_F(ClockGuardTest, AClockThatIsSetIsReported)
{
    clock.stepUtc(Seconds(0.3));
    tick();
    EXPECT_THAT(lines(), IsEmpty());
    clock.stepUtc(Seconds(90.0));
    tick();
    tick();
    EXPECT_THAT(lines(), ElementsAre("the clock of this computer was set by +90.0 s"));
    EXPECT_THAT(alarmsShown(), ElementsAre("The clock of this computer was set by +90.0 s."));
    clock.stepUtc(Seconds(-3600.0));
    tick();
    EXPECT_THAT(lines(), ElementsAre(testing::_, "the clock of this computer was set by -3600.0 s"));
}

// REQ-STATION-231: After a suspend of this computer Boresight reports its length, and does not report it as a clock
// that was set.
TEST_F(ClockGuardTest, AComputerThatSleptIsReported)
{
    clock.sleep(Seconds(20.0));
    tick();
    tick();
    EXPECT_THAT(lines(), ElementsAre("this computer was suspended for 20.0 s"));
    EXPECT_THAT(alarmsShown(), ElementsAre("This computer was suspended for 20.0 s."));
}

// REQ-STATION-232: The state of the clock is queried once a second.
TEST_F(ClockGuardTest, TheErrorOfTheClockIsPublished)
{
    EXPECT_TRUE(guard.status().synchronised);
    EXPECT_EQ(guard.status().error, Seconds(0.001));
    clock.setSynchronised(false);
    tick();
    EXPECT_TRUE(guard.status().synchronised);
    clock.advance(Seconds(1.0));
    tick();
    EXPECT_FALSE(guard.status().synchronised);
    EXPECT_EQ(guard.status().error, std::nullopt);
}

const Source kAtTheDesk{.kind = SourceKind::Operator, .name = QStringLiteral("operator")};

// REQ-STATION-236: A clock that was set does not move a mount that tracks by the time. Boresight goes on with the time
// before, and an alarm has the seconds and the angle by which the target would be away. The operator may use the new
// time.
TEST_F(ClockGuardTest, TheOperatorMayUseANewTime)
{
    clock.setSynchronised(false);
    track();
    const UtcTime before = kept.utc();
    clock.stepUtc(Seconds(90.0));
    tick();
    EXPECT_TRUE(wasSet);
    EXPECT_THAT(alarmsShown(), ElementsAre("The clock of this computer was set by +90.0 s: ISS would be 99.0° away."));
    EXPECT_EQ(guard.status().ahead, Seconds(90.0));
    for (int i = 0; i < 200; ++i) {
        tick();
        EXPECT_FALSE(wasSet);
    }
    EXPECT_LT(kept.utc() - before, Seconds(5.0));
    EXPECT_TRUE(guard.useNewTime(kAtTheDesk));
    EXPECT_EQ(kept.utc(), clock.utc());
    EXPECT_EQ(guard.status().ahead, std::nullopt);
    EXPECT_FALSE(alarms.active(alarmEntry("clock.kept")));
    EXPECT_THAT(lines(), ElementsAre("uses the new time of this computer (+90.0 s)"));
    EXPECT_FALSE(guard.useNewTime(kAtTheDesk)) << "there is no other time";
}

// REQ-STATION-237: A new time that no time source confirms is used when nothing depends on the time. An armed schedule
// and a target that has not risen depend on it. Then the alarm has the seconds only.
TEST_F(ClockGuardTest, AnUnconfirmedTimeIsUsedWhenNothingDependsOnIt)
{
    clock.setSynchronised(false);
    track();
    clock.stepUtc(Seconds(90.0));
    tick();
    effect = {.delays = true};  // the pass is over, and the schedule waits for the next one
    secondLater();
    EXPECT_EQ(guard.status().ahead, Seconds(90.0));
    EXPECT_THAT(alarmsShown(), ElementsAre("The clock of this computer was set by +90.0 s."));
    effect = {};
    secondLater();
    EXPECT_EQ(kept.utc(), clock.utc());
    EXPECT_FALSE(alarms.active(alarmEntry("clock.kept")));
    EXPECT_THAT(lines(), ElementsAre("the clock of this computer was set by +90.0 s"));
}

// Story: a computer without a battery clock starts with the time of its last shutdown. NTP sets it when the network is
// there. Nobody is at a screen.
// REQ-STATION-241: A new time that a time source confirms, with a small error, is used at once if the old time was
// never confirmed, also while a target is tracked.
TEST_F(ClockGuardTest, AConfirmedTimeReplacesOneThatNeverWas)
{
    clock.setSynchronised(false);
    KeptClock late{clock};
    ClockGuard started{late, log, alarms, [this](Seconds) { return effect; }};
    const auto step = [&] {
        clock.advance(Seconds(1.0));
        (void)started.tick();
    };
    step();
    track();
    clock.stepUtc(Seconds(5.0 * 3600.0));
    step();
    EXPECT_EQ(started.status().ahead, Seconds(5.0 * 3600.0)) << "nobody has confirmed it yet";
    clock.setSynchronised(true);
    clock.setError(Seconds(16.0));
    step();
    EXPECT_TRUE(started.status().ahead) << "the error is large";
    clock.setError(Seconds(0.02));
    step();
    EXPECT_EQ(late.utc(), clock.utc());
    EXPECT_FALSE(alarms.active(alarmEntry("clock.kept")));
    clock.stepUtc(Seconds(90.0));
    step();
    EXPECT_EQ(started.status().ahead, Seconds(90.0)) << "two confirmed times contradict each other";
}

// Story: after hours of the right time, a wrong server sets the clock in the middle of a pass.
// REQ-STATION-242: If both the old time and the new time were confirmed, the tracking continues with the old time.
// The new time is used when no target is tracked by the time.
TEST_F(ClockGuardTest, AConfirmedTimeDoesNotBreakAPass)
{
    track();
    clock.stepUtc(Seconds(90.0));
    tick();
    secondLater();
    EXPECT_EQ(guard.status().ahead, Seconds(90.0));
    EXPECT_FALSE(guard.status().synchronised) << "nobody confirms the old time";
    effect = {.delays = true};
    secondLater();
    EXPECT_EQ(guard.status().ahead, std::nullopt);
    EXPECT_EQ(kept.utc(), clock.utc());
}

// REQ-STATION-241
TEST_F(ClockGuardTest, AfterAnUnconfirmedTimeAConfirmedOneIsUsedAtOnce)
{
    clock.setSynchronised(false);
    track();
    clock.stepUtc(Seconds(-3600.0));
    tick();
    ASSERT_TRUE(guard.useNewTime(kAtTheDesk));
    secondLater();
    clock.stepUtc(Seconds(3600.0));
    clock.setSynchronised(true);
    tick();
    EXPECT_EQ(kept.utc(), clock.utc());
}

// REQ-STATION-237
TEST_F(ClockGuardTest, AClockThatIsPutRightAgainEndsTheAlarm)
{
    track();
    clock.stepUtc(Seconds(90.0));
    tick();
    clock.stepUtc(Seconds(-90.0));
    tick();
    EXPECT_FALSE(alarms.active(alarmEntry("clock.kept")));
    EXPECT_EQ(guard.status().ahead, std::nullopt);
    EXPECT_EQ(kept.utc(), clock.utc());
}

}  // namespace
}  // namespace boresight
