// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/rotctld/server_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace boresight::rotctld {
namespace {

using namespace std::chrono_literals;

std::string repeated(std::string_view command, int count)
{
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += command;
    }
    return text;
}

// REQ-ROTCTLD-02: Each reply leaves in one write, in the order of the commands, without waiting for a drive. Default
// replies to `p` and `P` have less than 128 bytes.
// REQ-ROTCTLD-05 (RotctldServer.*): One client cannot harm another client or the tick. One pass of the event loop
// handles at most 96 commands. A pause, half a line, a flood, unread replies or an endless line affects its own client
// only. If necessary that client is dropped with a reason.
TEST(RotctldServer, AnswersInOneSegmentEach)
{
    ServerFixture fixture;
    const auto peer = fixture.connect();
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(peer->ask("p\n", 2), "0.00\n0.00\n");
        EXPECT_EQ(peer->ask("P 0,00 45,00\n"), "RPRT 0\n");
        fixture.rotator.stop({});
    }
    EXPECT_EQ(peer->segments().size(), 200U);
    EXPECT_LT(std::ranges::max(peer->segments()), 128U);
}

// The best of many rounds: a server that waits for a drive is slow in every round, other load of this computer is not.
// REQ-ROTCTLD-02
TEST(RotctldServer, AnswersAtOnceWithoutDrive)
{
    ServerFixture fixture;
    fixture.rotator.fault = Error{.code = ErrorCode::NoAnswer, .text = QStringLiteral("no drive answers")};
    const auto peer = fixture.connect();
    auto best = std::chrono::nanoseconds::max();
    for (int run = 0; run < 50 && best >= 50ms; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        EXPECT_EQ(peer->ask("p\n"), "RPRT -6\n");
        EXPECT_EQ(peer->ask("P 10 5\n"), "RPRT -6\n");
        best = std::min<std::chrono::nanoseconds>(best, std::chrono::steady_clock::now() - begin);
    }
    EXPECT_LT(best, 50ms);
}

TEST(RotctldServer, LastPositionWins)
{
    ServerFixture fixture;
    const auto one = fixture.connect();
    const auto other = fixture.connect();
    EXPECT_EQ(one->ask("P 10 5\n"), "RPRT 0\n");
    EXPECT_EQ(other->ask("P 20 6\n"), "RPRT 0\n");
    EXPECT_NEAR(fixture.rotator.lastRequest->azimuth.degrees(), 20.0, 1e-6);
    EXPECT_EQ(one->ask("S\n"), "RPRT 0\n");
}

TEST(RotctldServer, PauseDelaysNobodyElse)
{
    ServerFixture fixture;
    const auto sleeper = fixture.connect();
    const auto other = fixture.connect();
    sleeper->send("\\pause 600\np\n");
    ServerFixture::turn();
    EXPECT_EQ(other->ask("S\n"), "RPRT 0\n");
    EXPECT_EQ(sleeper->receive([](const auto&) { return true; }, 5ms, 0ms), "");
    fixture.elapse(600s);
    EXPECT_EQ(sleeper->receiveLines(3), "RPRT 0\n0.00\n0.00\n");
}

// REQ-ROTCTLD-1423
TEST(RotctldServer, DropsWhoNeverReads)
{
    ServerFixture fixture;
    const auto deaf = fixture.connect();
    const auto other = fixture.connect();
    deaf->send(repeated("1\n", 20'000), 200ms);  // the reply to each is more than a kilobyte
    for (int i = 0; i < 10'000; ++i) {
        ServerFixture::turn();  // until the kernel accepts no more
    }
    EXPECT_EQ(other->ask("p\n", 2), "0.00\n0.00\n");
    fixture.elapse(9s);
    EXPECT_TRUE(fixture.rotator.gone.empty());
    fixture.elapse(2s);
    EXPECT_EQ(fixture.goneReason(), "dropped: does not read its answers");
    EXPECT_EQ(fixture.server->clients().size(), 1U);
    EXPECT_EQ(other->ask("p\n", 2), "0.00\n0.00\n");
}

// Silence is not a fault, and a client that reads its answers slowly stays connected.
// REQ-ROTCTLD-1423: A client whose unsent answers did not become fewer for 10 s is dropped. A client that reads some of
// them in this time is not.
TEST(RotctldServer, KeepsWhoReadsSlowly)
{
    ServerFixture fixture;
    const auto slow = fixture.connect();
    const auto untilTheKernelIsFull = [] {
        for (int i = 0; i < 10'000; ++i) {
            ServerFixture::turn();
        }
    };
    const auto some = [](const std::string& bytes) { return bytes.size() >= 300'000; };
    slow->send(repeated("1\n", 20'000), 200ms);
    untilTheKernelIsFull();
    for (int i = 0; i < 3; ++i) {
        fixture.elapse(8s);
        EXPECT_GE(slow->receive(some, 0ms, 60s).size(), 300'000U);
        untilTheKernelIsFull();
    }
    fixture.elapse(9s);
    EXPECT_TRUE(fixture.rotator.gone.empty()) << fixture.goneReason();
    fixture.elapse(2s);
    EXPECT_EQ(fixture.goneReason(), "dropped: does not read its answers");
}

// Story: a client that was reset with unread answers "closed the connection", and its waiting commands still ran.
// REQ-ROTCTLD-1424: A client that breaks its connection with answers unread is logged as lost, with the reason.
TEST(RotctldServer, WhoBreaksItsConnectionWithAnswersUnreadIsLost)
{
    ServerFixture fixture;
    const auto deaf = fixture.connect();
    deaf->send(repeated("1\n", 20'000), 200ms);
    for (int i = 0; i < 10'000; ++i) {
        ServerFixture::turn();  // until the kernel accepts no more
    }
    deaf->reset();
    for (int i = 0; i < 1'000 && fixture.rotator.gone.empty(); ++i) {
        ServerFixture::turn();
    }
    EXPECT_EQ(fixture.goneReason().substr(0, 5), "lost:");
    EXPECT_NE(fixture.goneReason(), "lost: its answers cannot be sent") << "that is no reason";
}

TEST(RotctldServer, DropsALineWithoutEnd)
{
    for (const char filling : {'x', '1', 'P', ' ', '#', '\\', ';'}) {
        ServerFixture fixture;
        const auto peer = fixture.connect();
        const auto other = fixture.connect();
        peer->send(filling == 'P' ? "P " + std::string(1'000'000, '7') : std::string(1'000'000, filling));
        peer->receiveUntilClosed();
        EXPECT_EQ(fixture.goneReason(), "sent 4096 bytes without a line end") << filling;
        EXPECT_EQ(fixture.rotator.actions, 0);
        EXPECT_EQ(other->ask("p\n", 2), "0.00\n0.00\n");
    }
}

TEST(RotctldServer, DropsHalfACommandAfterAMinute)
{
    ServerFixture fixture;
    const auto half = fixture.connect();
    const auto idle = fixture.connect();
    half->send("P 10");
    ServerFixture::turn();
    fixture.elapse(59s);
    EXPECT_TRUE(fixture.rotator.gone.empty());
    fixture.elapse(2s);
    EXPECT_EQ(fixture.goneReason(), "dropped: left a command unfinished");
    fixture.elapse(1h);
    EXPECT_EQ(idle->ask("p\n", 2), "0.00\n0.00\n");  // a silent client may stay connected
}

// The client reads its replies and sends 5000 commands in each second of the hand-turned clock. In this second the
// server gets a few turns with at most eight commands each. So commands wait all the time, on a fast computer as on a
// slow one.
TEST(RotctldServer, DropsAFloodAfterTenSeconds)
{
    ServerFixture fixture;
    const auto flood = fixture.connect();
    const auto other = fixture.connect();
    const std::string many = repeated("p\n", 5'000);
    int seconds = 0;
    std::string answers;
    while (fixture.rotator.gone.empty() && seconds < 13) {
        ASSERT_TRUE(flood->send(many));
        answers += flood->receive([](const auto&) { return true; }, 0ms, 0ms);
        fixture.elapse(1s);
        ++seconds;
    }
    EXPECT_EQ(fixture.goneReason(), "dropped: floods without waiting for answers");
    EXPECT_GE(seconds, 11);
    EXPECT_EQ(answers.substr(0, 10), "0.00\n0.00\n");
    EXPECT_EQ(other->ask("p\n", 2), "0.00\n0.00\n");
    EXPECT_EQ(fixture.server->clients().size(), 1U);
}

// The control tick shares the event loop: one pass must stay short whatever the clients send.
TEST(RotctldServer, BoundsTheWorkOfOneTurn)
{
    ServerFixture fixture;
    std::vector<std::unique_ptr<fakes::TcpPeer>> floods;
    const std::string many = repeated("p\n", 400);
    int most = 0;
    int turns = 0;
    const auto turn = [&] {
        const int before = fixture.rotator.questions;
        ServerFixture::turn();
        most = std::max(most, fixture.rotator.questions - before);
        ++turns;
    };
    const auto connect = [&] { return std::make_unique<fakes::TcpPeer>("127.0.0.1", fixture.server->port(), turn); };
    std::generate_n(std::back_inserter(floods), 100, connect);
    for (const auto& peer : floods) {
        ASSERT_TRUE(peer->send(many));
    }
    const auto late = connect();
    EXPECT_EQ(late->ask("S\n"), "RPRT 0\n");
    EXPECT_LT(fixture.rotator.questions, 100 * 400 / 2);  // long before the floods are served
    while (fixture.rotator.questions < 100 * 400 && turns < 10'000) {
        turn();
    }
    EXPECT_EQ(fixture.rotator.questions, 100 * 400);
    EXPECT_GE(most, 32);  // so this test did see a busy pass
    // Four commands each of 8 clients that are ready and of 8 that wait, and of 8 more if their timer falls into the
    // same pass.
    EXPECT_LE(most, 96);
}

TEST(RotctldServer, ServesLongPipelinesCompletely)
{
    ServerFixture fixture;
    const auto peer = fixture.connect();
    peer->send(repeated("p\n", 20'000));
    const auto all = [](const std::string& bytes) { return bytes.size() >= 200'000; };
    EXPECT_EQ(peer->receive(all, 0ms, 60s), repeated("0.00\n", 40'000));
}

TEST(RotctldServer, DeliversRepliesBeforeItCloses)
{
    ServerFixture fixture;
    const auto peer = fixture.connect();
    peer->send("p\nS\nq\nP 10 5\nand much more\n");
    EXPECT_EQ(peer->receiveUntilClosed(), "0.00\n0.00\nRPRT 0\n");
    EXPECT_EQ(fixture.goneReason(), "ended the session");
    EXPECT_FALSE(fixture.rotator.lastRequest.has_value());
}

// REQ-ROTCTLD-07: `M` ends with the connection, the target of a `P` stays. The Rotator is notified of each end with its
// reason, within 10 s even if the other computer vanished (TCP keep-alive).
TEST(RotctldServer, TellsWhoLeftAndWhy)
{
    ServerFixture fixture;
    auto closing = fixture.connect();
    EXPECT_EQ(closing->ask("P 100 5\n"), "RPRT 0\n");
    closing.reset();
    ServerFixture::turn();
    EXPECT_EQ(fixture.goneReason(), "closed the connection");
    fixture.elapse(1s);
    EXPECT_TRUE(fixture.rotator.motion().movingRight);  // its last target stays

    const auto resetting = fixture.connect();
    EXPECT_EQ(resetting->ask("M LEFT 50\n"), "RPRT 0\n");
    EXPECT_TRUE(fixture.rotator.motion().movingLeft);
    resetting->reset();
    ServerFixture::turn();
    EXPECT_EQ(fixture.goneReason().substr(0, 5), "lost:");
    EXPECT_FALSE(fixture.rotator.motion().movingLeft);  // but its `M` ends
    EXPECT_TRUE(fixture.server->clients().empty());
}

TEST(RotctldServer, ListsItsClients)
{
    ServerFixture fixture;
    const auto gpredict = fixture.connect();
    const auto unknown = fixture.connect();
    gpredict->ask("p\n", 2);
    gpredict->ask("P 12.34 5.60\n");
    unknown->send("nonsense\n");
    unknown->ask("_\n");
    const auto clients = fixture.server->clients();
    ASSERT_EQ(clients.size(), 2U);
    EXPECT_EQ(clients[0].program, "Gpredict or SatDump");
    EXPECT_EQ(clients[0].lastCommand.toStdString(), "P 12.34 5.60");
    EXPECT_EQ(clients[0].address, fixture.rotator.connected.at(clients[0].id));
    EXPECT_EQ(clients[1].oddCommands, 1U);
}

// REQ-ROTCTLD-1410: If the last command of a client was refused, the list of the clients shows the reason in words. For
// a command that moves or stops the mount, until the next such command.
TEST(RotctldServer, ListsWhyTheLastCommandWasRefused)
{
    ServerFixture fixture;
    const auto client = fixture.connect();
    EXPECT_NE(client->ask("P 12.34 170\n"), "RPRT 0\n");
    EXPECT_EQ(fixture.server->clients()[0].lastCommand.toStdString(), "P 12.34 170: refused. outside the limits");
    client->ask("p\n", 2);
    EXPECT_EQ(fixture.server->clients()[0].lastCommand.toStdString(), "P 12.34 170: refused. outside the limits");
    EXPECT_NE(client->ask("P nan 10\n"), "RPRT 0\n");
    EXPECT_TRUE(fixture.server->clients()[0].lastCommand.startsWith(QStringLiteral("P nan 10: refused. ")));
    EXPECT_EQ(client->ask("P 12.34 5.60\n"), "RPRT 0\n");
    EXPECT_EQ(fixture.server->clients()[0].lastCommand.toStdString(), "P 12.34 5.60");
}

// REQ-ROTCTLD-1411: If the mount does not go to exactly what the client wrote, the list of the clients shows the
// difference beside the last command.
TEST(RotctldServer, ListsWhatBecameOfTheLastTarget)
{
    ServerFixture fixture;
    const auto client = fixture.connect();
    fixture.rotator.became = QStringLiteral("az 40.0° (one turn less)");
    EXPECT_EQ(client->ask("P 400 30\n"), "RPRT 0\n");
    EXPECT_EQ(fixture.server->clients()[0].lastCommand.toStdString(), "P 400 30 → az 40.0° (one turn less)");
    fixture.rotator.became.clear();
    EXPECT_EQ(client->ask("S\n"), "RPRT 0\n");
    EXPECT_EQ(fixture.server->clients()[0].lastCommand.toStdString(), "S");
}

// Story: the column Last showed "p" for each client, because Gpredict reads the position after each target.
// REQ-ROTCTLD-1414: The list of the clients shows the last command of a client that moves or stops the mount. A client
// that only reads is shown with what it reads.
TEST(RotctldServer, ListsTheLastCommandThatActs)
{
    ServerFixture fixture;
    const auto client = fixture.connect();
    const auto last = [&] { return fixture.server->clients()[0].lastCommand.toStdString(); };
    client->ask("p\n", 2);
    EXPECT_EQ(last(), "p");
    client->ask("P 12.34 5.60\n");
    client->ask("p\n", 2);
    EXPECT_EQ(last(), "P 12.34 5.60");
    client->ask("S\n");
    client->ask("p\n", 2);
    EXPECT_EQ(last(), "S");
}

TEST(RotctldServer, HangsUpOnOneClientOnRequest)
{
    ServerFixture fixture;
    const auto one = fixture.connect();
    const auto other = fixture.connect();
    one->ask("p\n", 2);
    other->ask("p\n", 2);
    const std::uint64_t id = fixture.server->clients().at(0).id;
    EXPECT_TRUE(fixture.server->disconnect(id, QStringLiteral("disconnected by the operator")));
    EXPECT_EQ(fixture.goneReason(), "disconnected by the operator");
    one->send("P 90 45\n");
    EXPECT_EQ(one->receiveUntilClosed(), "");
    EXPECT_EQ(fixture.rotator.actions, 0) << "what it says behind that is not heard";
    EXPECT_EQ(fixture.server->clients().size(), 1U);
    EXPECT_FALSE(fixture.server->disconnect(id, QStringLiteral("again")));
    EXPECT_EQ(other->ask("p\n", 2), "0.00\n0.00\n");
}

// REQ-ROTCTLD-10: For each client the station knows the probable program, how often it sends, when it last asked for a
// motion, and whether its targets jump. This also holds while the client is refused.
TEST(RotctldServer, TellsHowAClientBehaves)
{
    ServerFixture fixture;
    const auto peer = fixture.connect();
    for (int i = 0; i < 20; ++i) {
        peer->ask("p\n", 2);
        fixture.elapse(500ms);
    }
    EXPECT_DOUBLE_EQ(fixture.server->clients().at(0).commandsPerSecond, 2.0);
    EXPECT_FALSE(fixture.server->clients().at(0).lastMotion);
    fixture.rotator.fault = Error{.code = ErrorCode::Refused, .text = QStringLiteral("another client has control")};
    for (const char* const azimuth : {"10.00", "16.00", "22.00", "28.00"}) {
        EXPECT_EQ(peer->ask("P " + std::string(azimuth) + " 5.00\n"), "RPRT -9\n");
        fixture.elapse(10s);
    }
    const ClientInfo refused = fixture.server->clients().at(0);
    EXPECT_EQ(fixture.clock.now() - refused.lastMotion.value(), 10s) << "also when it was refused";
    EXPECT_EQ(refused.program, "Gpredict or SatDump") << "also when it was refused";
    EXPECT_NEAR(refused.leap.value().degrees(), 6.0, 1e-4);
}

TEST(RotctldServer, SaysWhyItCannotListen)
{
    ServerFixture fixture;
    Server second({.host = "127.0.0.1", .port = fixture.server->port()},
                  talkRotctld(fixture.rotator, fixture.clock, DumpStateForm::OldAndNew), fixture.rotator,
                  fixture.clock);
    EXPECT_EQ(second.listen().error().code, ErrorCode::Busy);
    Server nowhere({.host = "shack.example"}, talkRotctld(fixture.rotator, fixture.clock, DumpStateForm::OldAndNew),
                   fixture.rotator, fixture.clock);
    EXPECT_EQ(nowhere.listen().error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(nowhere.address(), "");
    EXPECT_EQ(fixture.server->address(), "127.0.0.1:" + std::to_string(fixture.server->port()));
}

TEST(RotctldServer, GivesThePortBack)
{
    ServerFixture fixture;
    const auto peer = fixture.connect();
    const std::uint16_t port = fixture.server->port();
    fixture.server->close();
    EXPECT_EQ(fixture.goneReason(), "the server was closed");
    Server next({.host = "127.0.0.1", .port = port},
                talkRotctld(fixture.rotator, fixture.clock, DumpStateForm::OldAndNew), fixture.rotator, fixture.clock);
    EXPECT_TRUE(next.listen().has_value());
}

}  // namespace
}  // namespace boresight::rotctld
