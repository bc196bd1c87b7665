// SPDX-License-Identifier: GPL-3.0-or-later
// Drives that do not reply: what is reported, and what needs a re-arm.
#include "tests/core/control/station_rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace boresight {
namespace {

using moteus::Mode;

// Story: on a busy computer a new user saw two red "No reply" before the first query had been sent.
TEST(StationControl, WhoHasHadNoQuestionIsNotSilent)
{
    StationRig rig;
    rig.clock.advance(Seconds(5.0));
    rig.run(Seconds(0.5));
    EXPECT_TRUE(std::ranges::none_of(rig.log.since(0, 100), [](const LogEntry& line) {
        return line.text.contains(QStringLiteral("does not reply"));
    }));
    rig.azimuth.silent = true;
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.control.status().alarms.front().what, QStringLiteral("The azimuth drive does not reply."));
}

// REQ-CONTROL-07
TEST(StationControl, ASilentBusInMidMotionNeedsRearm)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.azimuth.mode = rig.elevation.mode = Mode::PositionTimeout;  // as their watchdogs do
    rig.run(Seconds(0.32));
    EXPECT_EQ(rig.state(), StationState::Disconnected);
    EXPECT_EQ(rig.control.status().azimuth.state, AxisState::NoData) << "nobody knows what a silent drive does";
    ASSERT_EQ(rig.control.status().alarms.size(), 1U);
    EXPECT_EQ(rig.control.status().alarms.front().what, QStringLiteral("Neither drive replies."));
    rig.run(Seconds(3.0));
    rig.azimuth.silent = rig.elevation.silent = false;
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.state(), StationState::Fault);
    const std::size_t before = rig.commands();
    EXPECT_EQ(rig.point(100.0, 60.0).error().code, ErrorCode::Refused);
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.commands(), before) << "nothing is commanded before re-arming";
    ASSERT_TRUE(rig.ask(request::Rearm{}, kClient));
    rig.run(Seconds(0.3));
    EXPECT_EQ(rig.state(), StationState::Standby);
    // Story: re-armed drives were left in mode 0, and an unbalanced elevation axis fell to its stop.
    EXPECT_EQ(rig.elevation.mode, Mode::Position) << "what held the axis before holds it again";
    EXPECT_EQ(rig.azimuth.mode, Mode::Position);
    EXPECT_TRUE(rig.point(100.0, 60.0));
}

// REQ-ALARMS-60: Drives that fall silent together have one alarm with one reason, because the bus is the cause. When
// they are back, the alarm says how long they were silent and how far the mount moved meanwhile.
TEST(StationControl, ABusThatIsGoneIsOneAlarm)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.azimuth.mode = rig.elevation.mode = Mode::PositionTimeout;
    rig.run(Seconds(8.0));
    rig.azimuth.position += 0.4 / 360.0;
    rig.azimuth.silent = false;  // one tick before the other
    rig.run(Seconds(0.02));
    rig.elevation.silent = false;
    rig.run(Seconds(0.5));
    const StationStatus back = rig.control.status();
    ASSERT_EQ(back.alarms.size(), 1U);
    const Alarm& alarm = back.alarms.front();
    EXPECT_EQ(alarm.what, QStringLiteral("Both drives were silent for 8 s and are back."));
    EXPECT_EQ(alarm.action, QStringLiteral("Boresight ended the motion. Azimuth moved 0.4° and elevation 0.0° while no "
                                           "reply came. The position is still known."));
    EXPECT_TRUE(alarm.remedy.contains(QStringLiteral("press Re-arm")));
    EXPECT_EQ(back.stateReason, QStringLiteral("both drives stopped replying"));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    EXPECT_FALSE(rig.control.status().alarms.front().active);
}

// Story: after a silence of 8 s the drive check read for 2 s before the wraps were confirmed. The alarm of the return
// was raised after 1 s, and never said how far the mount had moved.
// REQ-ALARMS-303: The alarm of drives that are back says how far the mount moved as soon as its position is confirmed,
// even if that is after the alarm was raised.
TEST(StationControl, HowFarTheMountMovedIsAddedWhenItIsKnown)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.azimuth.mode = rig.elevation.mode = Mode::PositionTimeout;
    rig.run(Seconds(8.0));
    rig.azimuth.position += 0.4 / 360.0;
    rig.originIsRead = false;
    rig.azimuth.silent = rig.elevation.silent = false;
    rig.run(Seconds(2.0));
    const StationStatus unconfirmed = rig.control.status();
    EXPECT_EQ(unconfirmed.alarms.front().what, QStringLiteral("Both drives were silent for 8 s and are back."))
        << "nobody waits for the number";
    EXPECT_EQ(unconfirmed.alarms.front().action,
              QStringLiteral("Boresight ended the motion. Nothing moves before a re-arm."));
    rig.originIsRead = true;
    rig.run(Seconds(0.5));
    const StationStatus confirmed = rig.control.status();
    ASSERT_EQ(confirmed.alarms.size(), 1U) << "the same alarm, completed";
    EXPECT_EQ(confirmed.alarms.front().what, unconfirmed.alarms.front().what);
    EXPECT_EQ(confirmed.alarms.front().action,
              QStringLiteral("Boresight ended the motion. Azimuth moved 0.4° and elevation 0.0° while no reply came. "
                             "The position is still known."));
    EXPECT_EQ(confirmed.alarms.front().since, unconfirmed.alarms.front().since);
}

// REQ-ALARMS-61: If one of two drives that fell silent together comes back alone, each drive has its own alarm.
TEST(StationControl, OneOfTwoSilentDrivesThatComesBackIsTold)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.azimuth.mode = rig.elevation.mode = Mode::PositionTimeout;
    rig.run(Seconds(2.0));
    rig.azimuth.silent = false;
    rig.run(Seconds(2.0));
    std::vector<std::string> active;
    for (const Alarm& alarm : rig.control.status().alarms) {
        if (alarm.active) {
            active.push_back(alarm.what.toStdString());
        }
    }
    EXPECT_THAT(active, testing::UnorderedElementsAre("The azimuth drive was silent for 2 s and is back.",
                                                      "The elevation drive does not reply."));
}

// Story: the drives had replied for ten seconds, and the fault still said "no reply from the azimuth drive".
// REQ-ALARMS-29
TEST(StationControl, ADriveThatAnswersAgainSaysSoWhileItWaitsForTheRearm)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    rig.azimuth.silent = true;
    rig.azimuth.mode = Mode::PositionTimeout;
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.control.status().alarms.front().what, QStringLiteral("The azimuth drive does not reply."));
    rig.azimuth.silent = false;
    rig.run(Seconds(0.5));
    const StationStatus back = rig.control.status();
    EXPECT_EQ(back.state, StationState::Fault);
    EXPECT_EQ(back.alarms.front().what, QStringLiteral("The azimuth drive was silent for 1 s and is back."));
    EXPECT_EQ(back.alarms.front().action, QStringLiteral("Boresight ended the motion. The axis did not move while no "
                                                         "reply came. Its position is still known."));
    EXPECT_TRUE(back.alarms.front().remedy.contains(QStringLiteral("press Re-arm")));
    EXPECT_EQ(back.stateReason, QStringLiteral("the azimuth drive stopped replying"));
    rig.control.alarms().acknowledgeAll();
    rig.run(Seconds(1.5));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.control.status().alarms.empty());
}

// The entries of the alarm list about the silent azimuth drive, and the last log line about it.
struct SilenceRig : StationRig
{
    SilenceRig() { EXPECT_TRUE(setsOff(100.0, 60.0, Seconds(2.0))); }

    void falls(bool silent, Seconds time)
    {
        azimuth.silent = silent;
        azimuth.mode = silent ? Mode::PositionTimeout : azimuth.mode;
        run(time);
    }

    [[nodiscard]] static bool isOfSilence(const QString& text)
    {
        return text.contains(QStringLiteral("azimuth drive does not reply")) ||
               text.contains(QStringLiteral("azimuth drive was silent"));
    }

    [[nodiscard]] std::string shown() const
    {
        QStringList all;
        for (const Alarm& alarm : control.status().alarms) {
            if (alarm.active && isOfSilence(alarm.what)) {
                all << alarm.what;
            }
        }
        return all.join(QLatin1Char(' ')).toStdString();
    }

    [[nodiscard]] std::string logged() const
    {
        QString last;
        for (const LogEntry& line : log.since(0, EventLog::kCapacity)) {
            last = line.kind == LogKind::Alarm && isOfSilence(line.text) ? line.text : last;
        }
        return last.section(QLatin1Char('.'), 0, 0).toStdString() + '.';
    }
};

constexpr const char* kNoReply = "The azimuth drive does not reply.";
constexpr const char* kBack = "The azimuth drive was silent for 1 s and is back.";

// Story: a drive was lost twice without a re-arm in between. The second loss was never reported. 41 s later the alarm
// still said that the drive replied again.
// REQ-ALARMS-29
TEST(StationControl, EverySilenceBeforeTheRearmIsTold)
{
    SilenceRig rig;
    for (int loss = 0; loss < 3; ++loss) {
        rig.falls(true, Seconds(1.0));
        EXPECT_EQ(rig.shown(), kNoReply) << loss;
        EXPECT_EQ(rig.logged(), kNoReply) << loss;
        rig.falls(false, Seconds(9.0));
        EXPECT_EQ(rig.shown(), kBack) << loss;
        EXPECT_EQ(rig.logged(), kBack) << loss;
    }
    rig.falls(true, Seconds(41.0));
    EXPECT_EQ(rig.state(), StationState::Disconnected);
    EXPECT_EQ(rig.shown(), kNoReply);
    EXPECT_EQ(rig.logged(), kNoReply);
    rig.falls(false, Seconds(2.0));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.shown(), "");
    rig.falls(true, Seconds(1.0));
    EXPECT_EQ(rig.shown(), kNoReply) << "and after it";
}

// REQ-ALARMS-303
TEST(StationControl, HowFarOneAxisMovedIsAddedWhenItIsKnown)
{
    SilenceRig rig;
    rig.falls(true, Seconds(8.0));
    rig.azimuth.position += 0.4 / 360.0;
    rig.originIsRead = false;
    rig.falls(false, Seconds(2.0));
    EXPECT_EQ(rig.shown(), "The azimuth drive was silent for 8 s and is back.");
    rig.falls(true, Seconds(1.0));
    EXPECT_EQ(rig.shown(), kNoReply) << "a second silence is reported";
    rig.falls(false, Seconds(2.0));
    EXPECT_EQ(rig.shown(), kBack);
    rig.originIsRead = true;
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.shown(), kBack);
    EXPECT_EQ(rig.control.status().alarms.front().action,
              QStringLiteral("Boresight ended the motion. Nothing moves before a re-arm."))
        << "the position before the second silence was not confirmed";
}

// The position that the operator entered does not prove how far the axis really moved.
// REQ-ALARMS-303
TEST(StationControl, APositionThatWasEnteredIsNotCalledContinuous)
{
    SilenceRig rig;
    rig.falls(true, Seconds(8.0));
    rig.originIsRead = false;
    rig.azimuth.position = 0.0;
    rig.azimuth.home = moteus::HomeState::Relative;  // restarted
    rig.falls(false, Seconds(2.0));
    rig.originIsRead = true;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.control.status().drives->azimuth.turnQuestion);
    ASSERT_TRUE(rig.ask(request::ChooseTurn{.axis = Axis::Azimuth, .angle = Angle::fromDegrees(28.8)}));
    rig.run(Seconds(3.0));
    ASSERT_TRUE(rig.control.status().azimuth.turnKnown);
    EXPECT_EQ(rig.shown(), "The azimuth drive was silent for 8 s and is back.");
    EXPECT_TRUE(std::ranges::none_of(rig.control.status().alarms, [](const Alarm& alarm) {
        return alarm.active && alarm.action.contains(QStringLiteral("continuous"));
    }));
}

// A loose plug causes more changes than the log accepts in a second.
// REQ-ALARMS-29
TEST(StationControl, ASilenceThatLastsIsToldAfterAFlicker)
{
    SilenceRig rig;
    for (int i = 0; i < 20; ++i) {
        rig.falls(true, Seconds(0.24));
        rig.falls(false, Seconds(0.06));
    }
    const auto lines = rig.log.since(0, EventLog::kCapacity);
    EXPECT_LE(std::ranges::count_if(lines, [](const LogEntry& line) { return SilenceRig::isOfSilence(line.text); }),
              30);
    rig.falls(true, Seconds(3.0));
    EXPECT_EQ(rig.shown(), kNoReply);
    EXPECT_EQ(rig.logged(), kNoReply);
}

// REQ-ALARMS-29
TEST(StationControl, ADriveInFaultThatFallsSilentIsToldBesideItsFault)
{
    SilenceRig rig;
    rig.azimuth.mode = Mode::Fault;
    rig.azimuth.fault = 38;
    rig.run(Seconds(1.0));
    rig.azimuth.silent = true;
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.shown(), kNoReply);
    const Alarm first = rig.control.status().alarms.front();
    EXPECT_TRUE(first.active);
    EXPECT_TRUE(first.what.startsWith(QStringLiteral("The azimuth drive reports fault 38")))
        << "the cause before the symptom";
    rig.azimuth.silent = false;
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.shown(), kBack);
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    EXPECT_TRUE(std::ranges::none_of(rig.control.status().alarms, &Alarm::active));
}

// Story: this computer stalled for 0.3 s and the alarm blamed the cable, although the replies lay unread in its own
// buffers.
// REQ-CONTROL-06: A stall of this computer is not silence of the drives.
TEST(StationControl, AStallOfThisComputerIsNotSilenceOfTheDrives)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(1.0)));
    rig.clock.advance(Seconds(0.4));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Slew);
    EXPECT_TRUE(rig.control.status().alarms.empty());
    EXPECT_EQ(rig.lastLog(), "this computer stalled for 0.42 s, and drives may have stopped by their watchdog");
    rig.azimuth.silent = true;
    rig.run(Seconds(0.3));
    EXPECT_EQ(rig.state(), StationState::Disconnected) << "real silence is noticed as before";
}

}  // namespace
}  // namespace boresight
