// SPDX-License-Identifier: GPL-3.0-or-later
// Several clients and an operator: who moves the mount, and which answers the others receive.
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

class StationClients : public ::testing::Test
{
protected:
    StationClients()
    {
        rig.control.clientCame(kClient, "10.0.0.7");
        rig.control.clientCame(kOtherClient, "10.0.0.9");
        rig.run(Seconds(0.2));
    }
    ClientStatus status(const Source& client, std::optional<SteadyTime> lastMotion = std::nullopt)
    {
        ClientStatus status{.id = client.clientId};
        rig.control.describe(status, lastMotion);
        return status;
    }
    static std::string text(const Result<>& result) { return result ? std::string() : textOf(result.error()); }
    double target() { return rig.control.status().azimuth.target->degrees(); }

    StationRig rig;
};

// REQ-CONTROL-27 (StationClients.*)
TEST_F(StationClients, OnlyTheFirstMovesTheMount)
{
    ASSERT_TRUE(rig.point(40.0, 30.0));
    rig.run(Seconds(1.0));
    const std::string why = "rotctld 1 has control. It sent its last command 1 s ago.";
    EXPECT_EQ(text(rig.point(300.0, 10.0, kOtherClient)), why);
    EXPECT_EQ(text(rig.ask(request::PointAxes{{.azimuth = 10_deg, .elevation = 10_deg}}, kOtherClient)), why);
    EXPECT_EQ(text(rig.ask(request::Move{{.azimuth = 3_deg_s}}, kOtherClient)), why);
    EXPECT_EQ(text(rig.ask(request::Park{}, kOtherClient)), why);
    EXPECT_EQ(text(rig.ask(request::Home{}, kOtherClient)), why);
    EXPECT_NEAR(target(), 40.0, 1e-9);
    EXPECT_TRUE(rig.point(50.0, 30.0));
    EXPECT_TRUE(rig.control.measured()) << "reading is open to all";
}

TEST_F(StationClients, AnybodyStops)
{
    ASSERT_TRUE(rig.point(80.0, 30.0));
    rig.run(Seconds(2.0));
    EXPECT_TRUE(rig.ask(request::Hold{}, kOtherClient));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_FALSE(rig.point(300.0, 10.0, kOtherClient)) << "to stop is not to take the lead";
    ASSERT_TRUE(rig.ask(request::SetReadOnly{.clientId = 2}));
    ASSERT_TRUE(rig.point(80.0, 30.0));
    EXPECT_TRUE(rig.ask(request::Hold{}, kOtherClient));
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// Story: "P 90 -5" was answered with RPRT 0, and nobody could see why the mount stood at 0°.
// REQ-CONTROL-33: A target that the limits cut off is never clipped silently. While that lasts the status, an advisory
// and the line of the client give the reason. The log has it once.
TEST_F(StationClients, ATargetOutsideIsToldForAsLongAsItLasts)
{
    const auto limitedLines = [this] {
        const auto lines = rig.log.since(0, EventLog::kCapacity);
        return std::ranges::count_if(lines, [](const LogEntry& line) {
            return line.text.startsWith(QStringLiteral("goes to the nearest permitted point"));
        });
    };
    for (int second = 0; second < 30; ++second) {
        ASSERT_TRUE(rig.point(90.0, -5.0));
        rig.run(Seconds(1.0));
    }
    const StationStatus shown = rig.control.status();
    EXPECT_NEAR(shown.elevation.actual->degrees(), 0.0, 0.05);
    EXPECT_TRUE(shown.limited);
    EXPECT_EQ(shown.limitedReason.toStdString(), "elevation -5.0° below limit 0.0°");
    EXPECT_NEAR(shown.target->elevation.degrees(), -5.0, 1e-9) << "the target is shown as it was asked";
    ASSERT_EQ(shown.alarms.size(), 1U);
    EXPECT_EQ(shown.alarms.front().severity, Severity::Advisory);
    EXPECT_EQ(shown.alarms.front().what.toStdString(),
              "The target is outside the limits (elevation -5.0° below limit 0.0°).");
    EXPECT_EQ(shown.alarms.front().action.toStdString(), "The mount goes to the nearest permitted point.");
    EXPECT_EQ(status(kClient).advice.toStdString(),
              "asks for a position outside the limits (elevation -5.0° below limit 0.0°). The mount goes to the "
              "nearest permitted position");
    EXPECT_TRUE(status(kOtherClient).advice.isEmpty());
    EXPECT_EQ(limitedLines(), 1) << "once, not with each of its points";

    ASSERT_TRUE(rig.point(90.0, 5.0));
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.control.status().limited);
    EXPECT_TRUE(rig.control.status().limitedReason.isEmpty());
    EXPECT_TRUE(rig.control.status().alarms.empty());
    EXPECT_TRUE(status(kClient).advice.isEmpty());
    ASSERT_TRUE(rig.point(90.0, -5.0));
    EXPECT_EQ(limitedLines(), 2) << "outside again";
}

// REQ-CONTROL-33
TEST_F(StationClients, ATrimThatLeadsOutsideIsTold)
{
    ASSERT_TRUE(rig.point(90.0, 1.0));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = 0_deg, .elevation = -4_deg}));
    ASSERT_TRUE(rig.point(90.0, 1.0));
    rig.run(Seconds(1.0));
    EXPECT_TRUE(rig.control.status().limited);
    EXPECT_FALSE(rig.control.status().limitedReason.isEmpty());
}

TEST_F(StationClients, ASilentDriverIsReleasedAndTheMountHolds)
{
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(rig.point(40.0 + i, 30.0));
        rig.run(Seconds(1.0));
    }
    rig.run(Seconds(8.9));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_FALSE(rig.point(300.0, 10.0, kOtherClient));
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.point(300.0, 10.0, kOtherClient));
}

// Story: Gpredict at a threshold of 0.1° pauses 12 to 16 s between two targets. It lost control to another program.
// REQ-CONTROL-501: A client that reads the position while the mount tracks its target keeps control without a new
// target. It loses control 10 s after its last reading.
TEST_F(StationClients, WhoReadsWhileItIsFollowedKeepsControl)
{
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(rig.point(40.0 + i, 30.0));
        rig.run(Seconds(1.0));
    }
    for (int second = 0; second < 15; ++second) {
        rig.control.positionRead(kClient.clientId);
        rig.control.positionRead(kOtherClient.clientId);
        rig.run(Seconds(1.0));
    }
    EXPECT_FALSE(rig.point(300.0, 10.0, kOtherClient));
    rig.run(Seconds(8.5));
    EXPECT_FALSE(rig.point(300.0, 10.0, kOtherClient)) << "nobody has read for 9.5 s";
    rig.control.positionRead(kOtherClient.clientId);
    rig.run(Seconds(0.6));
    EXPECT_TRUE(rig.point(300.0, 10.0, kOtherClient));
}

TEST_F(StationClients, LimitedOrRefusedTheLeadGoesByWhatIsAccepted)
{
    rig.profile.rotctld.outsideLimits = profile::OutsideLimits::Refuse;
    StationRig strict(rig.profile);
    strict.run(Seconds(0.2));
    EXPECT_FALSE(strict.point(20.0, -20.0));
    EXPECT_TRUE(strict.point(20.0, 20.0, kOtherClient)) << "who could not move the mount does not lead";
}

TEST_F(StationClients, TheOperatorGivesControlToOne)
{
    ASSERT_TRUE(rig.point(80.0, 30.0));
    rig.run(Seconds(2.0));
    ASSERT_TRUE(rig.ask(request::GiveControl{.clientId = 2}));
    EXPECT_EQ(rig.lastLog(), "gives control to rotctld 2");
    EXPECT_EQ(rig.state(), StationState::Hold) << "the other one's motion ends";
    EXPECT_FALSE(rig.point(80.0, 30.0));
    EXPECT_TRUE(rig.point(20.0, 30.0, kOtherClient));
    EXPECT_TRUE(status(kOtherClient).inControl);
    EXPECT_TRUE(status(kOtherClient).driving);
    EXPECT_FALSE(status(kClient).inControl);
}

TEST_F(StationClients, GivingControlGivesTheAuthorityBack)
{
    ASSERT_TRUE(rig.point(80.0, 30.0));
    ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = 1_deg_s}}));
    EXPECT_FALSE(rig.point(80.0, 30.0));
    ASSERT_TRUE(rig.ask(request::GiveControl{.clientId = 1}));
    EXPECT_EQ(rig.control.status().authority, Authority::Clients);
    EXPECT_TRUE(rig.point(80.0, 30.0));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    EXPECT_EQ(text(rig.ask(request::GiveControl{.clientId = 1})), "STOP is latched. Reset STOP first.");
    EXPECT_EQ(rig.control.status().authority, Authority::Operator);
}

TEST_F(StationClients, WhoLedBeforeAJogLeadsAfterIt)
{
    ASSERT_TRUE(rig.point(80.0, 30.0));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    rig.run(Seconds(30.0));
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    EXPECT_FALSE(rig.point(300.0, 30.0, kOtherClient));
    EXPECT_TRUE(rig.point(80.0, 30.0));
}

TEST_F(StationClients, ReadOnlyEndsItsMotionAndRefusesTheNext)
{
    ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 3_deg_s}}, kClient));
    rig.run(Seconds(2.0));
    ASSERT_TRUE(rig.ask(request::SetReadOnly{.clientId = 1}));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_EQ(text(rig.point(80.0, 30.0)), "The operator has made this client read-only.");
    EXPECT_EQ(text(rig.ask(request::Rearm{}, kClient)), "The operator has made this client read-only.");
    EXPECT_TRUE(status(kClient).readOnly);
    ASSERT_TRUE(rig.ask(request::SetReadOnly{.clientId = 1, .readOnly = false}));
    EXPECT_TRUE(rig.point(80.0, 30.0));
}

TEST_F(StationClients, OnlyTheOperatorDecidesAboutClients)
{
    EXPECT_FALSE(rig.ask(request::GiveControl{.clientId = 2}, kOtherClient));
    EXPECT_FALSE(rig.ask(request::SetReadOnly{.clientId = 1}, kOtherClient));
    EXPECT_FALSE(rig.ask(request::Disconnect{.clientId = 1}, kOtherClient));
    EXPECT_TRUE(rig.point(80.0, 30.0));
}

TEST_F(StationClients, WhoGoesOnAskingInVainIsShown)
{
    ASSERT_TRUE(rig.point(80.0, 30.0));
    const SteadyTime asked = rig.clock.now();
    ASSERT_FALSE(rig.point(20.0, 30.0, kOtherClient));
    EXPECT_TRUE(status(kOtherClient, asked).wanting);
    EXPECT_FALSE(status(kClient, asked).wanting);
    EXPECT_FALSE(status(kOtherClient).wanting) << "it has never asked";
    rig.run(Seconds(5.1));
    EXPECT_FALSE(status(kOtherClient, asked).wanting) << "that is over";
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    EXPECT_FALSE(status(kOtherClient, rig.clock.now()).wanting) << "all are refused, and are told why";
}

// REQ-CONTROL-403 (StationTakenControl.*): STOP, Re-arm, the answer about the wrap, Go and other actions may take
// control from the clients as a side effect. This is never silent. The log reports it. The status shows it while a
// connected client wants to move the mount. It ends when the operator hands control back or takes it explicitly.
class StationTakenControl : public StationClients
{
protected:
    bool tookControl() { return rig.control.status().tookControl; }
    // The client sends targets and reads the position for this time.
    void insist(const Source& client, int seconds)
    {
        for (int second = 0; second < seconds; ++second) {
            (void)rig.point(80.0 + second, 30.0, client);
            rig.control.positionRead(client.clientId);
            rig.run(Seconds(1.0));
        }
    }
};

TEST_F(StationTakenControl, ByAMotionOfTheOperator)
{
    EXPECT_FALSE(tookControl());
    insist(kClient, 3);
    EXPECT_FALSE(tookControl());
    ASSERT_TRUE(rig.point(20, 30, kOperator));
    EXPECT_TRUE(tookControl());
    const auto lines = rig.log.since(0, EventLog::kCapacity);
    EXPECT_TRUE(std::ranges::any_of(lines, [](const LogEntry& line) {
        return line.source == kOperator.name &&
               line.text == QStringLiteral(
                                "takes control from rotctld 1, and Boresight refuses motion commands of "
                                "clients");
    }));
    insist(kClient, 20);
    EXPECT_TRUE(tookControl()) << "it still asks";
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    EXPECT_FALSE(tookControl());
}

TEST_F(StationTakenControl, ByStopWhichIsLoggedToo)
{
    insist(kClient, 3);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    EXPECT_TRUE(tookControl());
    const auto lines = rig.log.since(0, EventLog::kCapacity);
    EXPECT_TRUE(lines.at(lines.size() - 2).text.startsWith(QStringLiteral("STOP is latched")));
    EXPECT_TRUE(lines.back().text.startsWith(QStringLiteral("takes control from rotctld 1")));
    rig.run(Seconds(5.0));
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    EXPECT_TRUE(tookControl()) << "the reset gives nothing back";
    ASSERT_TRUE(rig.ask(request::GiveControl{.clientId = 2}));
    EXPECT_FALSE(tookControl());
}

TEST_F(StationTakenControl, ByARearm)
{
    insist(kClient, 3);
    rig.azimuth.fault = 35;
    rig.azimuth.mode = moteus::Mode::Fault;
    rig.run(Seconds(0.5));
    ASSERT_EQ(rig.state(), StationState::Fault);
    EXPECT_FALSE(tookControl());
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    EXPECT_TRUE(tookControl());
    const auto lines = rig.log.since(0, EventLog::kCapacity);
    EXPECT_TRUE(std::ranges::any_of(lines, [](const LogEntry& line) {
        return line.text.startsWith(QStringLiteral("takes control from rotctld 1"));
    }));
}

TEST_F(StationTakenControl, TakenExplicitlyItIsNoSurprise)
{
    insist(kClient, 3);
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    EXPECT_FALSE(tookControl());
    ASSERT_TRUE(rig.point(20, 30, kOperator));
    insist(kClient, 3);
    EXPECT_FALSE(tookControl()) << "it was taken before";
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    insist(kClient, 3);
    ASSERT_TRUE(rig.ask(request::Hold{}));
    EXPECT_TRUE(tookControl());
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    EXPECT_FALSE(tookControl()) << "now it is wanted so";
}

// A client that has reached its target only reads the position.
TEST_F(StationTakenControl, WhoHadControlWantsItForAsLongAsItReads)
{
    insist(kClient, 3);
    ASSERT_TRUE(rig.ask(request::Hold{}));
    for (int second = 0; second < 30; ++second) {
        rig.control.positionRead(kClient.clientId);
        rig.control.positionRead(kOtherClient.clientId);
        rig.run(Seconds(1.0));
    }
    EXPECT_TRUE(tookControl());
    rig.run(Seconds(10.1));
    EXPECT_FALSE(tookControl()) << "no client wants any more";
    rig.control.positionRead(kOtherClient.clientId);
    EXPECT_FALSE(tookControl()) << "this one only looks";
    EXPECT_FALSE(rig.point(20, 30, kOtherClient));
    EXPECT_TRUE(tookControl()) << "a client waits for control again";
}

TEST_F(StationTakenControl, OnlyWhoIsThereAndMayMoveTheMountWaits)
{
    insist(kClient, 3);
    ASSERT_TRUE(rig.ask(request::Hold{}));
    EXPECT_TRUE(tookControl());
    ASSERT_TRUE(rig.ask(request::SetReadOnly{.clientId = kClient.clientId}));
    EXPECT_FALSE(tookControl());
    ASSERT_TRUE(rig.ask(request::SetReadOnly{.clientId = kClient.clientId, .readOnly = false}));
    EXPECT_TRUE(tookControl());
    rig.control.sourceGone(kClient);
    EXPECT_FALSE(tookControl());
}

// A shell script connects for each command.
TEST_F(StationTakenControl, AProgramThatConnectsForEachCommandWaitsWhenItAsksAgain)
{
    rig.control.sourceGone(kOtherClient);
    (void)rig.point(80, 30);
    rig.control.sourceGone(kClient);
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    EXPECT_FALSE(tookControl()) << "nobody is there";
    rig.run(Seconds(1.0));
    const Source again{.kind = SourceKind::Client, .clientId = 7, .name = QStringLiteral("rotctld 7")};
    rig.control.clientCame(again, "10.0.0.7");
    EXPECT_FALSE(rig.point(80, 30, again));
    rig.control.sourceGone(again);
    rig.run(Seconds(1.0));
    EXPECT_TRUE(tookControl());
    rig.run(Seconds(10.0));
    EXPECT_FALSE(tookControl());
}

// A fault during a motion. The clients go on sending for some seconds.
void failInMidMotion(StationRig& rig, const Source& streaming, int seconds)
{
    ASSERT_TRUE(rig.point(80.0, 30.0, streaming));
    rig.run(Seconds(2.0));
    rig.elevation.mode = moteus::Mode::Fault;
    rig.elevation.fault = 33;
    for (int i = 0; i < seconds; ++i) {
        rig.run(Seconds(1.0));
        EXPECT_FALSE(rig.point(80.0, 30.0, streaming));
    }
}

// Story: a client that the lock refused sent "R 1". It was accepted, and the stream of the locked client moved the
// mount at once.
// REQ-CONTROL-23a: A client re-arms only if it may move the mount. The other clients that kept sending through the
// fault wait for a deliberate act: `R 1`, a pause of 10 s, a new connection, or the operator's permission. A client
// that may not move the mount cannot set the speed either.
TEST_F(StationClients, WhoMayNotMoveMayNotRearm)
{
    rig.profile.rotctld.control = profile::ControlRule::Locked;
    rig.profile.rotctld.lockedTo = "10.0.0.7";
    rig.setProfile(rig.profile);
    failInMidMotion(rig, kClient, 12);
    EXPECT_EQ(text(rig.ask(request::Rearm{}, kOtherClient)), "The mount is locked to 10.0.0.7.");
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.point(80.0, 30.0));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_TRUE(rig.ask(request::Rearm{}, kClient));
}

// REQ-CONTROL-23a
TEST_F(StationClients, WhileAnotherLeadsAClientMayNotRearm)
{
    failInMidMotion(rig, kClient, 3);
    EXPECT_EQ(text(rig.ask(request::Rearm{}, kOtherClient)),
              "rotctld 1 has control. It sent its last command 5 s ago.");
}

// REQ-CONTROL-23a
TEST_F(StationClients, AStreamThatWentOnThroughTheFaultWaitsForAnActOfItsOwn)
{
    failInMidMotion(rig, kClient, 12);
    ASSERT_TRUE(rig.ask(request::Rearm{}, kOtherClient)) << "nobody leads any more";
    const double place = rig.azimuthDegrees();
    for (int i = 0; i < 30; ++i) {
        rig.run(Seconds(1.0));
        EXPECT_FALSE(rig.point(80.0, 30.0));
    }
    EXPECT_NEAR(rig.azimuthDegrees(), place, 0.05) << "it merely kept sending";
    ASSERT_TRUE(rig.ask(request::Rearm{}, kClient)) << "there is no fault, but it acts";
    EXPECT_TRUE(rig.point(80.0, 30.0));
}

// REQ-CONTROL-23a
TEST_F(StationClients, WhoRearmsItselfGoesOnAtOnce)
{
    failInMidMotion(rig, kClient, 3);
    ASSERT_TRUE(rig.ask(request::Rearm{}, kClient));
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.point(80.0, 30.0));
}

}  // namespace
}  // namespace boresight
