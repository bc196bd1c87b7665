// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/gpredict_client.h"
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

#include <cmath>

// Several rotctld clients over real sockets, and an operator: who moves the antenna, judged by its true motion.
namespace boresight::system_test {
namespace {

const std::string kDone = "RPRT 0\n";
const std::string kRefused = "RPRT -9\n";

class ClientsTest : public ::testing::Test
{
protected:
    ClientsTest() : one(rig.connect()), other(rig.connect())
    {
        one->ask("p\n", 2);
        other->ask("p\n", 2);
        rig.onTick = [this] { watchReversals(); };
    }

    // Both clients send a target each second. Returns their last replies.
    std::pair<std::string, std::string> bothAsk(int seconds)
    {
        std::pair<std::string, std::string> heard;
        for (int i = 0; i < seconds; ++i) {
            heard.first = one->ask("P 200 50\n");
            rig.run(Seconds(0.5));
            heard.second = other->ask("P 160 40\n");
            rig.run(Seconds(0.5));
        }
        return heard;
    }
    [[nodiscard]] ClientStatus statusOf(std::size_t number) const { return rig.status().clients.at(number); }
    [[nodiscard]] double azimuth() const { return rig.truth(Axis::Azimuth); }
    // Counts how often the real antenna reversed its direction.
    void watchReversals()
    {
        const AngularRate rate = rig.link->truth(Axis::Azimuth).rate;
        const int way = rate > kTurning ? 1 : rate < -kTurning ? -1 : 0;
        reversals += way != 0 && m_way != 0 && way != m_way ? 1 : 0;
        m_way = way != 0 ? way : m_way;
    }

    static constexpr AngularRate kTurning = AngularRate::fromDegrees(0.2);
    SimulatedStation rig{anyPort(), sim::commissionedPair({.azimuth = 180_deg, .elevation = 45_deg})};
    std::unique_ptr<fakes::TcpPeer> one;
    std::unique_ptr<fakes::TcpPeer> other;
    int reversals = 0;

private:
    int m_way = 0;
};

// REQ-CONTROL-27 (ClientsTest.*)
TEST_F(ClientsTest, OnlyTheDriverMovesTheAntenna)
{
    EXPECT_EQ(bothAsk(15), std::pair(kDone, kRefused));
    EXPECT_TRUE(rig.settle());
    EXPECT_NEAR(azimuth(), 200.0, 0.1);
    EXPECT_EQ(reversals, 0);
    EXPECT_EQ(std::lround(std::stod(other->ask("p\n", 2))), 200) << "reading is open to all";
    EXPECT_TRUE(statusOf(0).inControl && statusOf(0).driving && !statusOf(0).wanting);
    EXPECT_TRUE(statusOf(1).wanting && !statusOf(1).inControl && !statusOf(1).driving);
    EXPECT_TRUE(rig.logSays(QStringLiteral("P 160.00 40.00 refused: rotctld 127.0.0.1:")));
}

TEST_F(ClientsTest, AnybodyStopsTheAntenna)
{
    ASSERT_EQ(one->ask("P 300 50\n"), kDone);
    rig.run(Seconds(3.0));
    EXPECT_EQ(other->ask("S\n"), kDone);
    EXPECT_TRUE(rig.settle(Seconds(5.0)));
    EXPECT_LT(azimuth(), 250.0);
    EXPECT_EQ(other->ask("P 160 40\n"), kRefused);
}

TEST_F(ClientsTest, WhoeverIsLeftTakesOver)
{
    EXPECT_EQ(bothAsk(3), std::pair(kDone, kRefused));
    one.reset();
    rig.run(Seconds(0.1));
    EXPECT_EQ(other->ask("P 160 40\n"), kDone);
    EXPECT_TRUE(rig.settle());
    EXPECT_NEAR(azimuth(), 160.0, 0.1);
}

TEST_F(ClientsTest, ADriverThatVanishesIsReleasedAfterTenSeconds)
{
    EXPECT_EQ(bothAsk(10).first, kDone);
    EXPECT_EQ(one->ask("P 201 50\n"), kDone);
    rig.run(Seconds(9.5));  // its computer failed: no FIN, no data
    EXPECT_EQ(rig.status().state, StationState::Hold);
    EXPECT_NEAR(azimuth(), 201.0, 0.1);
    EXPECT_EQ(other->ask("P 160 40\n"), kRefused);
    rig.run(Seconds(0.6));
    EXPECT_EQ(other->ask("P 160 40\n"), kDone);
    EXPECT_TRUE(rig.settle());
    EXPECT_NEAR(azimuth(), 160.0, 0.1);
}

TEST_F(ClientsTest, TheOperatorGivesControlAndTakesIt)
{
    EXPECT_EQ(bothAsk(2), std::pair(kDone, kRefused));
    const std::uint64_t otherId = statusOf(1).id;
    EXPECT_EQ(rig.ask(request::GiveControl{.clientId = otherId}), "");
    EXPECT_EQ(bothAsk(2), std::pair(kRefused, kDone));
    EXPECT_EQ(rig.ask(request::TakeAuthority{}), "");
    EXPECT_EQ(bothAsk(15), std::pair(kRefused, kRefused));
    EXPECT_EQ(rig.ask(request::GiveAuthority{}), "");
    EXPECT_EQ(bothAsk(2), std::pair(kRefused, kDone)) << "who led before";
    EXPECT_EQ(rig.ask(request::SetReadOnly{.clientId = otherId}), "");
    EXPECT_EQ(bothAsk(2), std::pair(kDone, kRefused));
}

TEST_F(ClientsTest, TheOperatorDisconnects)
{
    const std::uint64_t id = statusOf(0).id;
    EXPECT_EQ(rig.ask(request::Disconnect{.clientId = id}), "");
    EXPECT_EQ(one->receiveUntilClosed(), "");
    EXPECT_EQ(rig.status().clients.size(), 1U);
    EXPECT_EQ(rig.ask(request::Disconnect{.clientId = id}), "this client has disconnected");
}

TEST_F(ClientsTest, AProgramThatConnectsForEachCommandKeepsTheLead)
{
    const auto once = [this](const std::string& command) { return rig.connect()->ask(command); };
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(once("P 200 50\n"), kDone);
        rig.run(Seconds(3.0));
        EXPECT_EQ(one->ask("P 160 40\n"), kRefused);
    }
    rig.run(Seconds(7.1));
    EXPECT_EQ(one->ask("P 160 40\n"), kDone);
}

// Each rule of the profile, with the same two clients.
// REQ-CONTROL-27 (ClientsByProfile.*)
TEST(ClientsByProfile, LastAsHamlibAndLocked)
{
    profile::Profile profile = anyPort();
    profile.rotctld.control = profile::ControlRule::Last;
    SimulatedStation last(profile);
    const auto one = last.connect();
    const auto other = last.connect();
    EXPECT_EQ(one->ask("P 10 20\n"), kDone);
    EXPECT_EQ(other->ask("P 20 20\n"), kDone);

    profile.rotctld.control = profile::ControlRule::Locked;
    profile.rotctld.lockedTo = "127.0.0.1";
    SimulatedStation here(profile);
    const auto local = here.connect();
    EXPECT_EQ(local->ask("P 10 20\n"), kDone);
    EXPECT_TRUE(here.status().clients.at(0).locked);

    profile.rotctld.lockedTo = "10.0.0.7";
    SimulatedStation elsewhere(profile);
    const auto lockedOut = elsewhere.connect();
    EXPECT_EQ(lockedOut->ask("P 10 20\n"), kRefused);
    EXPECT_EQ(lockedOut->ask("S\n"), kDone);
    EXPECT_FALSE(elsewhere.status().clients.at(0).wanting) << "the operator wants it so";
}

TEST(ClientsByProfile, TheRuleAndWhoMayConnectChangeWhileRunning)
{
    SimulatedStation rig;
    const auto one = rig.connect();
    const auto other = rig.connect();
    ASSERT_EQ(one->ask("P 10 20\n"), kDone);
    EXPECT_EQ(other->ask("P 20 20\n"), kRefused);
    profile::Profile profile = *rig.status().profile;
    profile.rotctld.control = profile::ControlRule::Last;
    ASSERT_EQ(rig.ask(request::ApplyProfile{profile}), "");
    EXPECT_EQ(other->ask("P 20 20\n"), kDone);
    profile.rotctld.allow = {"10.0.0.0/8"};
    ASSERT_EQ(rig.ask(request::ApplyProfile{profile}), "");
    EXPECT_EQ(other->receiveUntilClosed(), "");
    EXPECT_TRUE(rig.status().clients.empty());
    EXPECT_EQ(rig.connect()->receiveUntilClosed(), "");
    EXPECT_TRUE(rig.logSays(QStringLiteral("refused: its address is not permitted (rotctld.allow)")));
}

// Story: the profile showed the number of clients as "in force now", but the server kept the number of its start.
// REQ-CONTROL-500: The number of clients in the profile applies at once. Clients that are connected stay served.
TEST(ClientsByProfile, TheNumberOfClientsChangesWhileRunning)
{
    SimulatedStation rig;
    const auto one = rig.connect();
    const auto other = rig.connect();
    ASSERT_NE(one->ask("p\n", 2), "");
    ASSERT_NE(other->ask("p\n", 2), "");
    const auto permit = [&](int clients) {
        profile::Profile profile = *rig.status().profile;
        profile.rotctld.maxClients = clients;
        return rig.ask(request::ApplyProfile{profile});
    };
    ASSERT_EQ(permit(2), "");
    EXPECT_EQ(rig.connect()->receiveUntilClosed(), "");
    EXPECT_EQ(rig.status().clients.size(), 2U);
    EXPECT_EQ(one->ask("P 10 20\n"), kDone);
    EXPECT_NE(other->ask("p\n", 2), "");
    ASSERT_EQ(permit(3), "");
    EXPECT_NE(rig.connect()->ask("p\n", 2), "");
}

// Gpredict as delivered, with a threshold of 5°, and again after its user has followed the advice.
// REQ-CONTROL-28 (ClientsAdvice.*): A Gpredict whose targets jump gets advice on what to set, until they no longer
// jump.
TEST(ClientsAdvice, AGpredictThatLeapsIsToldWhatToSet)
{
    const SatellitePass pass({.maxElevation = 40_deg, .culmination = 180_deg});
    SimulatedStation rig(anyPort(), sim::commissionedPair({.azimuth = 180_deg, .elevation = 45_deg}));
    Seconds time = -pass.halfDuration() + Seconds(30.0);
    const auto track = [&](GpredictClient& gpredict, Seconds until) {
        for (; time < until; time += SimulatedStation::kTick) {
            rig.tick();
            gpredict.tick(time);
        }
        return rig.status().clients.back();
    };
    GpredictClient coarse(rig.connect(), pass, 5_deg);
    const ClientStatus before = track(coarse, Seconds(-60.0));
    EXPECT_EQ(before.program.toStdString(), "Gpredict or SatDump");
    EXPECT_TRUE(before.advice.contains(QStringLiteral("Set Threshold to 0.1"))) << before.advice.toStdString();
    EXPECT_NEAR(before.commandsPerSecond, 1.25, 0.5);
    coarse.setThreshold(0.1_deg);
    EXPECT_EQ(track(coarse, Seconds(0.0)).advice.toStdString(), "");
    EXPECT_EQ(coarse.complaints(), std::vector<std::string>{});
}

// REQ-CONTROL-1760: A Gpredict that received errors in three cycles in a row gets the advice that it will disengage
// after six, with the remedy or the reason, until a cycle has no error.
TEST(ClientsAdvice, AGpredictThatIsRefusedIsToldBeforeItDisengages)
{
    profile::Profile strict = anyPort();
    strict.rotctld.outsideLimits = profile::OutsideLimits::Refuse;
    SimulatedStation rig(strict, sim::commissionedPair({.azimuth = 180_deg, .elevation = 45_deg}));
    const auto gpredict = rig.connect();
    const auto cycle = [&](const char* target) {
        std::string answer = gpredict->ask(target);
        EXPECT_EQ(gpredict->ask("p\n", 2).find("RPRT"), std::string::npos);
        rig.tick();
        return answer;
    };
    const auto advice = [&] { return rig.status().clients.at(0).advice.toStdString(); };
    gpredict->ask("p\n", 2);
    ASSERT_EQ(cycle("P 180.00 45.00\n"), kDone);
    for (int i = 0; i < 2; ++i) {
        ASSERT_EQ(cycle("P 180.00 -60.00\n"), "RPRT -1\n");
        EXPECT_EQ(advice(), "");
    }
    ASSERT_EQ(cycle("P 180.00 -60.00\n"), "RPRT -1\n");
    EXPECT_EQ(rig.status().clients.at(0).program.toStdString(), "Gpredict or SatDump");
    EXPECT_EQ(advice(), "3 errors in a row. Gpredict disengages after 6. Set rotctld.outside_limits to \"nearest\".");
    ASSERT_EQ(rig.ask(request::Stop{}), "");
    ASSERT_EQ(cycle("P 180.00 45.00\n"), kRefused);
    EXPECT_TRUE(rig.status().clients.at(0).advice.startsWith(
        QStringLiteral("4 errors in a row. Gpredict disengages after 6. Reason: ")))
        << advice();
    ASSERT_EQ(rig.ask(request::ResetStop{}), "");
    gpredict->ask("p\n", 2);
    EXPECT_EQ(advice(), "");
}

// REQ-CONTROL-1761: The status has the number of odd commands of each client.
TEST(ClientsListed, WithTheirOddCommands)
{
    SimulatedStation rig;
    const auto client = rig.connect();
    client->ask("P nan 10\n");
    client->ask("P 1 rubbish\n");
    client->ask("p\n", 2);
    rig.tick();
    EXPECT_EQ(rig.status().clients.at(0).oddCommands, 2U);
}

}  // namespace
}  // namespace boresight::system_test
