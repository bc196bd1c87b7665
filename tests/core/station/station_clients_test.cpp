// SPDX-License-Identifier: GPL-3.0-or-later
// Several clients and an operator: who moves the mount, and what the others hear.
#include "tests/core/station/station_rig.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

class StationClients : public ::testing::Test
{
protected:
    StationClients()
    {
        rig.control.clientCame(kClient, "10.0.0.7");
        rig.control.clientCame(kOtherClient, "10.0.0.9");
        rig.run(Seconds(0.1));
    }
    ClientStatus status(const Source& client, std::optional<SteadyTime> lastMotion = std::nullopt)
    {
        ClientStatus status{.id = client.clientId};
        rig.control.describe(status, lastMotion);
        return status;
    }
    static std::string text(const Result<>& result) { return result ? std::string() : result.error().text; }
    double target() { return rig.control.status().azimuth.target->degrees(); }

    StationRig rig;
};

TEST_F(StationClients, OnlyTheFirstMovesTheMount)
{
    ASSERT_TRUE(rig.point(40.0, 30.0));
    rig.run(Seconds(1.0));
    const std::string why = "rotctld 1 has the lead: it sent its last command 1 s ago";
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

TEST_F(StationClients, LimitedOrRefusedTheLeadGoesByWhatIsAccepted)
{
    rig.profile.rotctld.outsideLimits = profile::OutsideLimits::Refuse;
    StationRig strict(rig.profile);
    strict.run(Seconds(0.1));
    EXPECT_FALSE(strict.point(20.0, -20.0));
    EXPECT_TRUE(strict.point(20.0, 20.0, kOtherClient)) << "who could not move the mount does not lead";
}

TEST_F(StationClients, TheOperatorGivesControlToOne)
{
    ASSERT_TRUE(rig.point(80.0, 30.0));
    rig.run(Seconds(2.0));
    ASSERT_TRUE(rig.ask(request::GiveLead{.clientId = 2}));
    EXPECT_EQ(rig.lastLog(), "gives control to rotctld 2");
    EXPECT_EQ(rig.state(), StationState::Hold) << "the other one's motion ends";
    EXPECT_FALSE(rig.point(80.0, 30.0));
    EXPECT_TRUE(rig.point(20.0, 30.0, kOtherClient));
    EXPECT_TRUE(status(kOtherClient).leading);
    EXPECT_TRUE(status(kOtherClient).driving);
    EXPECT_FALSE(status(kClient).leading);
}

TEST_F(StationClients, GivingControlGivesTheAuthorityBack)
{
    ASSERT_TRUE(rig.point(80.0, 30.0));
    ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = 1_deg_s}}));
    EXPECT_FALSE(rig.point(80.0, 30.0));
    ASSERT_TRUE(rig.ask(request::GiveLead{.clientId = 1}));
    EXPECT_EQ(rig.control.status().authority, Authority::Clients);
    EXPECT_TRUE(rig.point(80.0, 30.0));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    EXPECT_EQ(text(rig.ask(request::GiveLead{.clientId = 1})), "STOP is latched: reset STOP first");
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
    EXPECT_EQ(text(rig.point(80.0, 30.0)), "the operator has made this client read-only");
    EXPECT_EQ(text(rig.ask(request::Rearm{}, kClient)), "the operator has made this client read-only");
    EXPECT_TRUE(status(kClient).readOnly);
    ASSERT_TRUE(rig.ask(request::SetReadOnly{.clientId = 1, .readOnly = false}));
    EXPECT_TRUE(rig.point(80.0, 30.0));
}

TEST_F(StationClients, OnlyTheOperatorDecidesAboutClients)
{
    EXPECT_FALSE(rig.ask(request::GiveLead{.clientId = 2}, kOtherClient));
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

}  // namespace
}  // namespace boresight
