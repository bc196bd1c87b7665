// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which clients may connect, how many, and what the kernel keeps for them.
#include "tests/core/rotctld/server_fixture.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace boresight::rotctld {
namespace {

using namespace std::chrono_literals;

// Every address of 127.0.0.0/8 is this computer, but the server takes each for a different host.
Descriptor connectAs(const char* own, std::uint16_t port)
{
    Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    const void* const untyped = &address;
    ::inet_pton(AF_INET, own, &address.sin_addr);
    EXPECT_EQ(::bind(socket.get(), static_cast<const sockaddr*>(untyped), sizeof address), 0);
    ::inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
    address.sin_port = htons(port);
    EXPECT_EQ(::connect(socket.get(), static_cast<const sockaddr*>(untyped), sizeof address), 0);
    return socket;
}

TEST(RotctldServer, RefusesClientsAboveItsLimit)
{
    ServerFixture fixture({.maxClients = 2});
    const auto one = fixture.connect();
    auto two = fixture.connect();
    const auto three = fixture.connect();
    EXPECT_EQ(three->receiveUntilClosed(), "");
    EXPECT_EQ(fixture.rotator.remarks.at(0), "refused: 2 clients are connected");
    EXPECT_EQ(one->ask("p\n", 2), "0.00\n0.00\n");
    two.reset();
    ServerFixture::turn();
    EXPECT_EQ(fixture.connect()->ask("p\n", 2), "0.00\n0.00\n");
}

// Story: one computer used every slot, and the tracking program of another computer could not connect.
// REQ-ROTCTLD-09a: One host uses at most three quarters of the slots.
TEST(RotctldServer, OneHostLeavesSlotsToTheOthers)
{
    ServerFixture fixture({.host = "0.0.0.0", .maxClients = 4});
    std::vector<std::unique_ptr<fakes::TcpPeer>> crowd;
    for (int i = 0; i < 3; ++i) {
        crowd.push_back(fixture.connect());
        EXPECT_EQ(crowd.back()->ask("p\n", 2), "0.00\n0.00\n");
    }
    EXPECT_EQ(fixture.connect()->receiveUntilClosed(), "");
    EXPECT_EQ(fixture.connect()->receiveUntilClosed(), "");
    EXPECT_EQ(fixture.rotator.remarks, std::vector<std::string>{"refused: 3 clients of its host are connected"});
    const Descriptor other = connectAs("127.0.0.2", fixture.server->port());
    ServerFixture::turn();
    EXPECT_EQ(fixture.server->clients().back().address.substr(0, 10), "127.0.0.2:");
    crowd.pop_back();
    ServerFixture::turn();
    EXPECT_EQ(fixture.connect()->ask("p\n", 2), "0.00\n0.00\n");
}

// REQ-ROTCTLD-09
TEST(RotctldServer, TurnsAwayWhoMayNotConnect)
{
    ServerFixture fixture({.allow = {"10.0.0.0/8"}});
    const auto foreignProtocol = fixture.connect();
    EXPECT_EQ(foreignProtocol->receiveUntilClosed(), "");
    EXPECT_EQ(fixture.rotator.remarks,
              std::vector<std::string>{"refused: its address is not permitted (rotctld.allow)"});
    EXPECT_TRUE(fixture.rotator.connected.empty());
    fixture.server->setAllowed({"10.0.0.0/8", "127.0.0.1"});
    const auto friendly = fixture.connect();
    EXPECT_EQ(friendly->ask("p\n", 2), "0.00\n0.00\n");
    fixture.server->setAllowed({"192.168.0.0/16"});
    EXPECT_EQ(friendly->receiveUntilClosed(), "");
    EXPECT_EQ(fixture.goneReason(), "its address is no longer permitted (rotctld.allow)");
    fixture.server->setAllowed({});
    EXPECT_EQ(fixture.connect()->ask("p\n", 2), "0.00\n0.00\n");
}

TEST(RotctldServer, TheNumberOfClientsCanBeChangedWhileItRuns)
{
    ServerFixture fixture({.maxClients = 8});
    const auto one = fixture.connect();
    const auto two = fixture.connect();
    EXPECT_EQ(one->ask("p\n", 2), "0.00\n0.00\n");
    EXPECT_EQ(two->ask("p\n", 2), "0.00\n0.00\n");
    fixture.server->setMaxClients(1);
    EXPECT_EQ(fixture.connect()->receiveUntilClosed(), "");
    EXPECT_EQ(two->ask("p\n", 2), "0.00\n0.00\n") << "who is connected stays";
    fixture.server->setMaxClients(8);
    EXPECT_EQ(fixture.connect()->ask("p\n", 2), "0.00\n0.00\n");
}

TEST(RotctldServer, AnIpv4ClientOfADualListenerIsAnIpv4Client)
{
    ServerFixture fixture({.host = "::", .allow = {"127.0.0.0/8"}});
    if (!fixture.listening) {
        GTEST_SKIP() << "no IPv6 here";
    }
    const auto peer = fixture.connect();
    EXPECT_EQ(peer->ask("p\n", 2), "0.00\n0.00\n");
    EXPECT_EQ(fixture.server->clients().at(0).address.substr(0, 10), "127.0.0.1:");
}

TEST(RotctldServer, QueuesConnectsBackToBack)
{
    ServerFixture fixture;
    std::vector<std::unique_ptr<fakes::TcpPeer>> peers;
    bool serving = false;
    for (int i = 0; i < 128; ++i) {  // while the server is busy with another task
        peers.push_back(std::make_unique<fakes::TcpPeer>("127.0.0.1", fixture.server->port(), [&serving] {
            if (serving) {
                ServerFixture::turn();
            }
        }));
        ASSERT_TRUE(peers.back()->connected());
    }
    serving = true;
    for (const auto& peer : peers) {
        EXPECT_EQ(peer->ask("p\n", 2), "0.00\n0.00\n");
    }
}

// REQ-ROTCTLD-06: When file descriptors run out, connected clients keep working and new ones wait. 32 descriptors are
// reserved for the journal, the log and the bus.
TEST(RotctldServer, SurvivesDescriptorShortage)
{
    ServerFixture fixture;
    const auto one = fixture.connect();
    EXPECT_EQ(one->ask("p\n", 2), "0.00\n0.00\n");
    std::vector<Descriptor> hoard;
    do {
        hoard.emplace_back(::dup(0));
    } while (hoard.back().valid());
    hoard.resize(hoard.size() - 2);  // frees the failed one, and one for the client end of the next connection
    const auto waiting = fixture.connect();
    ASSERT_TRUE(waiting->connected());
    ServerFixture::turn();
    EXPECT_EQ(fixture.rotator.remarks, std::vector<std::string>{"no file descriptor is free, so new clients wait"});
    EXPECT_EQ(one->ask("p\n", 2), "0.00\n0.00\n");
    fixture.elapse(1s);
    EXPECT_EQ(fixture.rotator.remarks.size(), 1U);
    hoard.clear();
    fixture.elapse(1s);
    EXPECT_EQ(waiting->ask("p\n", 2), "0.00\n0.00\n");
}

// Story: with a limit of 64 descriptors the clients used all of them, and the journal could not be written any more.
// REQ-ROTCTLD-06
TEST(RotctldServer, LeavesDescriptorsForTheJournal)
{
    const auto lowestFree = [] { return Descriptor(::dup(0)).get(); };
    ServerFixture fixture;
    rlimit usual{};
    ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &usual), 0);
    rlimit low = usual;
    low.rlim_cur = static_cast<rlim_t>(lowestFree()) + 60;
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &low), 0);
    std::vector<std::unique_ptr<fakes::TcpPeer>> peers;
    while (peers.size() < 30 && fixture.rotator.remarks.empty()) {
        peers.push_back(fixture.connect());
        ServerFixture::turn();
    }
    EXPECT_EQ(fixture.rotator.remarks, std::vector<std::string>{"no file descriptor is free, so new clients wait"});
    EXPECT_GE(low.rlim_cur - static_cast<rlim_t>(lowestFree()), 30U);
    EXPECT_EQ(peers.front()->ask("p\n", 2), "0.00\n0.00\n");
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &usual), 0);
    fixture.elapse(1s);
    EXPECT_EQ(peers.back()->ask("p\n", 2), "0.00\n0.00\n") << "who waited is served";
}

// Story: the kernel kept 4 MB of answers for a client that never read, so the server noticed it minutes later.
// REQ-ROTCTLD-1422: The kernel keeps at most 64 kB of unsent answers for each client.
TEST(RotctldServer, KeepsFewAnswersInTheKernel)
{
    const auto listener = listenOn("127.0.0.1", 0);
    ASSERT_TRUE(listener.has_value());
    const fakes::TcpPeer peer("127.0.0.1", localPort(*listener), [] {});
    const auto accepted = acceptOne(*listener);
    ASSERT_TRUE(accepted.has_value());
    int bytes = 0;
    socklen_t length = sizeof bytes;
    ASSERT_EQ(::getsockopt(accepted->socket.get(), SOL_SOCKET, SO_SNDBUF, &bytes, &length), 0);
    EXPECT_LE(bytes, 65'536);
}

}  // namespace
}  // namespace boresight::rotctld
