// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/clock_guard.h"

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
        guard.tick();
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
    ClockGuard guard{clock, log, alarms};
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
    EXPECT_THAT(lines(), ElementsAre("the clock of this computer was set by +90.3 s"));
    EXPECT_THAT(alarmsShown(), ElementsAre("The clock of this computer was set by +90.3 s."));
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

}  // namespace
}  // namespace boresight
