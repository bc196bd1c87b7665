// SPDX-License-Identifier: GPL-3.0-or-later
// The bus of a Station does not open, is lost, or belongs to another program.
#include "tests/core/station/linked_station.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

namespace boresight {
namespace {

using Rig = LinkedStation;

// REQ-STATION-17
TEST(Station, ABusThatDoesNotOpenIsAnAlarmAndIsTriedAgain)
{
    Rig rig;
    rig.link->openError = QStringLiteral("no such adapter");
    rig.station->openAll();
    rig.run(5);
    auto alarms = rig.station->status().alarms;
    ASSERT_EQ(alarms.size(), 1U);
    EXPECT_TRUE(alarms.front().what.contains(QStringLiteral("no such adapter")));
    EXPECT_TRUE(rig.link->sent.empty());
    rig.link->openError.clear();
    rig.station->openMount();
    EXPECT_EQ(rig.link->openings, 2);
    rig.station->openMount();
    EXPECT_EQ(rig.link->openings, 2) << "an open bus is left alone";
    rig.run(5);
    EXPECT_FALSE(rig.station->status().alarms.front().active);
    EXPECT_EQ(rig.station->status().state, StationState::Standby);
}

TEST(Station, ALostAdapterIsShownAtOnceAndReopened)
{
    Rig rig;
    rig.station->openAll();
    rig.run(5);
    rig.link->report({.state = LinkState::Lost, .text = QStringLiteral("the adapter is gone")});
    ASSERT_FALSE(rig.station->status().alarms.empty());
    EXPECT_TRUE(rig.station->status().alarms.front().what.contains(QStringLiteral("the adapter is gone")));
    rig.station->openMount();
    EXPECT_EQ(rig.link->openings, 2);
}

// Story: each attempt first closed the link, without a text. Every second the alarm went blank and came back
// unacknowledged.
TEST(Station, ABusThatIsTriedAgainKeepsItsAlarm)
{
    Rig rig;
    rig.station->openAll();
    rig.run(5);
    rig.link->report({.state = LinkState::Lost, .text = QStringLiteral("the adapter is gone")});
    rig.link->report({.state = LinkState::Closed});
    EXPECT_EQ(rig.station->status().alarms.front().what, QStringLiteral("The CAN bus is down: the adapter is gone."));
    EXPECT_TRUE(rig.station->status().alarms.front().active);
}

// Story: a second program took the journal, and with it the wrap of each axis, from the program that moved the mount.
// REQ-STATION-43b: A mount that another program controls is left alone. Boresight opens no bus, serves no clients, and
// raises an alarm with the name of that program.
TEST(Station, AMountThatAnotherProgramControlsIsLeftAlone)
{
    profile::Profile profile = anyPort();
    profile.bus = "fdcanusb:/dev/mount";
    Rig first(profile);
    first.station->openAll();
    first.run(5);
    auto owned = std::make_unique<fakes::FakeCanLink>();
    fakes::FakeCanLink* const link = owned.get();
    Station second(profile, moteusRotator(std::move(owned), {first.stateDir.path()}), first.stateDir.path(),
                   first.clock);
    QSignalSpy started(&second, &Station::started);
    second.openAll();
    ASSERT_EQ(started.size(), 1);
    EXPECT_TRUE(started[0][0].toString().isEmpty());
    EXPECT_TRUE(started[0][1].toString().contains(QStringLiteral("already controls this mount")));
    for (int i = 0; i < 100; ++i) {
        first.clock.advance(Seconds(0.02));
        second.tick();
        second.openMount();
    }
    EXPECT_EQ(link->openings, 0);
    EXPECT_TRUE(link->sent.empty());
    EXPECT_TRUE(second.status().listening.isEmpty());
    ASSERT_FALSE(second.status().alarms.empty());
    EXPECT_EQ(second.status().alarms.front().severity, Severity::Alarm);
}

// Story: an adapter that had refused frames for a moment received no query ever again.
TEST(Station, KeepsSendingWhileTheBusIsDown)
{
    Rig rig;
    rig.station->openAll();
    rig.run(5);
    rig.link->report({.state = LinkState::Down, .text = QStringLiteral("bus-off")});
    rig.link->sent.clear();
    rig.station->tick();
    EXPECT_EQ(rig.link->sent.size(), 2U);
    rig.link->report({.state = LinkState::Lost, .text = QStringLiteral("gone")});
    rig.link->sent.clear();
    rig.station->tick();
    EXPECT_TRUE(rig.link->sent.empty());
}

}  // namespace
}  // namespace boresight
