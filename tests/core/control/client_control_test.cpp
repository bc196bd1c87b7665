// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/client_control.h"

#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

Source client(std::uint64_t id)
{
    return {.kind = SourceKind::Client, .clientId = id, .name = QStringLiteral("rotctld client %1").arg(id)};
}

class ClientControlTest : public ::testing::Test
{
protected:
    ClientControlTest()
    {
        lead.came(client(1), "10.0.0.7");
        lead.came(client(2), "10.0.0.9");
    }
    // Asks for a motion and moves if that is allowed. Returns the reason of a refusal, else an empty text.
    std::string moves(std::uint64_t id)
    {
        const Result<> may = lead.admits(rules, client(id), clock.now());
        if (!may) {
            EXPECT_EQ(may.error().code, ErrorCode::Refused);
            return textOf(may.error());
        }
        lead.moved(client(id), clock.now());
        return {};
    }
    // The same through a client's request.
    std::string asks(std::uint64_t id)
    {
        lead.asked(client(id), clock.now());
        return moves(id);
    }
    void pass(double seconds) { clock.advance(Seconds(seconds)); }
    bool hasControl(std::uint64_t id) { return lead.hasControl(rules, id, clock.now()); }

    fakes::ManualClock clock;
    profile::RotctldSettings rules;
    ClientControl lead;
};

// Story: Gpredict with a threshold of 0.1° sends nothing for 12 to 16 s while a satellite moves slowly. In mid-pass it
// lost control to a program that sent a target in that pause.
// REQ-CONTROL-27 (ClientControlTest.*): Only one of several clients moves the mount, by the rule of the profile: the
// first client, the newest client, or the clients of one host. The first client keeps control until it leaves, or until
// for 10 s it neither asked for a motion nor read the position during tracking. The motions of the other clients are
// refused with the reason. Every client may read and stop. The operator gives control to a client, makes it read-only,
// or disconnects it.
TEST_F(ClientControlTest, WhoIsFollowedAndReadsKeepsTheLead)
{
    EXPECT_EQ(moves(1), "");
    for (int second = 0; second < 60; ++second) {
        pass(1.0);
        lead.followed(1, clock.now());
        lead.followed(2, clock.now());
    }
    EXPECT_EQ(moves(2), "rotctld client 1 has control. It sent its last command 60 s ago.");
    pass(10.0);
    EXPECT_EQ(moves(2), "");
    lead.followed(1, clock.now());
    EXPECT_TRUE(hasControl(2));
}

TEST_F(ClientControlTest, TheFirstKeepsTheLeadWhileItSends)
{
    EXPECT_FALSE(hasControl(1));
    for (int i = 0; i < 30; ++i) {
        EXPECT_EQ(moves(1), "");
        pass(3.0);
        EXPECT_EQ(moves(2), "rotctld client 1 has control. It sent its last command 3 s ago.");
        EXPECT_TRUE(hasControl(1));
        EXPECT_FALSE(hasControl(2));
    }
}

TEST_F(ClientControlTest, TenSecondsOfSilenceFreeTheLead)
{
    EXPECT_EQ(moves(1), "");
    pass(9.99);
    EXPECT_EQ(moves(2), "rotctld client 1 has control. It sent its last command 9 s ago.");
    pass(0.01);
    EXPECT_EQ(moves(2), "");
    EXPECT_EQ(moves(1), "rotctld client 2 has control. It sent its last command a moment ago.");
}

TEST_F(ClientControlTest, WhoLeavesFreesTheLead)
{
    EXPECT_EQ(moves(1), "");
    EXPECT_EQ(moves(1), "");
    lead.gone(client(2));
    lead.came(client(3), "10.0.0.9");
    EXPECT_NE(moves(3), "") << "another one has left";
    lead.gone(client(1));
    EXPECT_EQ(moves(3), "");
}

// For example `rotctl P 90 45` twice from a shell, or a program that connects for each command.
TEST_F(ClientControlTest, AHostThatConnectsForEachCommandKeepsTheLead)
{
    EXPECT_EQ(moves(1), "");
    lead.gone(client(1));
    pass(2.0);
    EXPECT_EQ(moves(2), "10.0.0.7 has control. It connects for each command. It sent its last command 2 s ago.");
    for (std::uint64_t id = 3; id < 10; ++id) {
        lead.came(client(id), "10.0.0.7");
        EXPECT_EQ(moves(id), "");
        lead.gone(client(id));
        pass(9.0);
        EXPECT_NE(moves(2), "");
    }
    pass(1.0);
    EXPECT_EQ(moves(2), "");
}

TEST_F(ClientControlTest, AnEarlierConnectionOfTheSameHostIsAnotherProgram)
{
    lead.came(client(3), "10.0.0.7");
    EXPECT_EQ(moves(3), "");
    lead.gone(client(3));
    EXPECT_NE(moves(1), "");
    pass(10.0);
    EXPECT_EQ(moves(1), "");
}

TEST_F(ClientControlTest, TheLastMovesWhereTheProfileSaysSo)
{
    rules.control = profile::ControlRule::Last;
    EXPECT_EQ(moves(1), "");
    EXPECT_EQ(moves(2), "");
    EXPECT_EQ(moves(1), "");
    EXPECT_FALSE(hasControl(1)) << "nobody is kept out";
}

TEST_F(ClientControlTest, OnlyTheLockedHostMoves)
{
    EXPECT_EQ(moves(1), "") << "before the lock";
    rules.control = profile::ControlRule::Locked;
    rules.lockedTo = "10.0.0.9";
    EXPECT_EQ(moves(1), "The mount is locked to 10.0.0.9.");
    EXPECT_EQ(moves(2), "");
    EXPECT_TRUE(lead.locked(rules, 2));
    EXPECT_FALSE(lead.locked(rules, 1));
    lead.came(client(3), "10.0.0.9");
    EXPECT_NE(moves(3), "") << "of two programs there the first";
    EXPECT_FALSE(lead.give(rules, 1, clock.now()));
}

TEST_F(ClientControlTest, OneHostWrittenTwoWaysIsOneHost)
{
    rules.control = profile::ControlRule::Locked;
    rules.lockedTo = "0:0:0:0:0:0:0:1";
    lead.came(client(3), "::1");
    EXPECT_EQ(moves(3), "");
}

TEST_F(ClientControlTest, TheOperatorGivesTheLead)
{
    EXPECT_EQ(moves(1), "");
    EXPECT_TRUE(lead.give(rules, 2, clock.now()));
    EXPECT_TRUE(hasControl(2));
    pass(4.0);
    EXPECT_EQ(moves(1), "rotctld client 2 received control 4 s ago.");
    EXPECT_EQ(moves(2), "");
    EXPECT_TRUE(lead.give(rules, 1, clock.now()));
    pass(10.0);
    EXPECT_EQ(moves(2), "") << "who says nothing for 10 s does not keep it";
}

TEST_F(ClientControlTest, ReadOnlyMovesNothingAndLeadsNot)
{
    EXPECT_EQ(moves(1), "");
    EXPECT_TRUE(lead.setReadOnly(1, true));
    EXPECT_EQ(moves(1), "The operator has made this client read-only.");
    EXPECT_FALSE(hasControl(1));
    EXPECT_EQ(moves(2), "");
    EXPECT_TRUE(lead.give(rules, 1, clock.now())) << "control given is no longer read-only";
    EXPECT_FALSE(lead.readOnly(1));
    EXPECT_EQ(moves(1), "");
    rules.control = profile::ControlRule::Last;
    EXPECT_TRUE(lead.setReadOnly(2, true));
    EXPECT_EQ(moves(2), "The operator has made this client read-only.");
    EXPECT_TRUE(lead.setReadOnly(2, false));
    EXPECT_EQ(moves(2), "");
}

TEST_F(ClientControlTest, WhoLedBeforeTheOperatorTookOverGoesOn)
{
    EXPECT_EQ(moves(1), "");
    pass(60.0);  // the operator jogs meanwhile
    lead.resume(clock.now());
    EXPECT_NE(moves(2), "");
    EXPECT_EQ(moves(1), "");
}

TEST_F(ClientControlTest, NobodyThereCannotBeToldAnything)
{
    EXPECT_EQ(lead.give(rules, 77, clock.now()).error().code, ErrorCode::NotAvailable);
    EXPECT_EQ(lead.setReadOnly(77, true).error().code, ErrorCode::NotAvailable);
    EXPECT_EQ(moves(1), "");
}

// Story: a client without control re-armed. Another client had kept sending through the fault, and its stream moved the
// mount at once.
// REQ-CONTROL-23a
TEST_F(ClientControlTest, AfterAClientsRearmTheOthersThatKeptSendingWait)
{
    asks(1);
    lead.rearmed(client(2), clock.now());
    EXPECT_TRUE(lead.waits(1));
    EXPECT_FALSE(lead.waits(2));
    for (int i = 0; i < 60; ++i) {
        pass(1.0);
        EXPECT_EQ(asks(1),
                  "Another client re-armed the drives while this client kept sending. Pause this client for 10 s, or "
                  "send R 1.");
    }
    EXPECT_TRUE(lead.mayAct(rules, client(1), clock.now()));
    lead.acted(client(1));
    EXPECT_EQ(asks(1), "");
}

// REQ-CONTROL-23a
TEST_F(ClientControlTest, APauseANewConnectionOrTheOperatorEndsTheWait)
{
    asks(1);
    lead.rearmed(client(2), clock.now());
    pass(10.0);
    EXPECT_EQ(asks(1), "") << "a pause";
    asks(1);
    lead.rearmed(client(2), clock.now());
    lead.gone(client(1));
    lead.came(client(3), "10.0.0.7");
    EXPECT_EQ(asks(3), "") << "a new connection after a stream";
    lead.rearmed(client(2), clock.now());
    EXPECT_NE(asks(3), "");
    EXPECT_TRUE(lead.give(rules, 3, clock.now()));
    EXPECT_EQ(asks(3), "") << "the operator's word";
    lead.rearmed(client(2), clock.now());
    lead.resume(clock.now());
    EXPECT_EQ(asks(3), "");
}

TEST_F(ClientControlTest, WhoAskedForNothingBeforeTheRearmDoesNotWait)
{
    lead.rearmed(client(2), clock.now());
    EXPECT_EQ(asks(1), "");
    pass(10.0);
    lead.rearmed(client(2), clock.now());
    EXPECT_EQ(asks(1), "") << "its stream had ended";
}

// REQ-CONTROL-23a
TEST_F(ClientControlTest, AProgramThatConnectsForEachCommandWaitsUnderItsAddress)
{
    asks(1);
    lead.gone(client(1));
    lead.rearmed(client(2), clock.now());
    for (std::uint64_t id = 10; id < 20; ++id) {
        lead.came(client(id), "10.0.0.7");
        EXPECT_NE(asks(id), "");
        lead.gone(client(id));
        lead.came(client(id + 100), "10.0.0.7");  // this client only reads
        lead.gone(client(id + 100));
        pass(1.0);
    }
    lead.came(client(20), "10.0.0.7");
    lead.rearmed(client(20), clock.now());
    lead.gone(client(20));
    lead.came(client(21), "10.0.0.7");
    EXPECT_EQ(asks(21), "") << "it has re-armed itself";
}

}  // namespace
}  // namespace boresight
