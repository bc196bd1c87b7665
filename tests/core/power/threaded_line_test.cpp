// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/power/threaded_line.h"

#include "core/base/file_descriptor.h"
#include "core/power/line_worker.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"

#include <QTcpServer>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>

#include <vector>

namespace boresight::power {
namespace {

LineSettings settingsOf(Transport transport, std::uint16_t port)
{
    return {.transport = transport,
            .host = QStringLiteral("127.0.0.1"),
            .port = port,
            .firstRetry = std::chrono::milliseconds(5),
            .longestRetry = std::chrono::milliseconds(20)};
}

// The program of the receiver is served without the event loop of this thread.
// REQ-POWER-08 (ThreadedLine.*)
TEST(ThreadedLine, IsServedWhileItsOwnerDoesNotRun)
{
    QTcpServer server;  // its connections are accepted here, by blocking system calls
    ASSERT_TRUE(server.listen(QHostAddress::LocalHost));
    const int listener = static_cast<int>(server.socketDescriptor());
    fakes::ManualClock clock;
    ThreadedLine line(settingsOf(Transport::Tcp, server.serverPort()), clock);
    std::vector<Value> values;
    QObject::connect(&line, &ThreadedLine::received, [&values](const Value& value) { values.push_back(value); });
    pollfd request{.fd = listener, .events = POLLIN, .revents = 0};
    ASSERT_EQ(poll(&request, 1, 60'000), 1);
    const FileDescriptor program(accept4(listener, nullptr, nullptr, SOCK_CLOEXEC));
    ASSERT_TRUE(program.isOpen());
    EXPECT_FALSE(line.isOpen()) << "its report is still on the way";
    ASSERT_EQ(send(program.number(), "-73.5\n-70\n", 10, MSG_NOSIGNAL), 10);
    ASSERT_TRUE(fakes::waitUntil([&] { return values.size() == 2; }));
    EXPECT_TRUE(line.isOpen());
    EXPECT_EQ(values[0].decibels, -73.5);
    EXPECT_EQ(values[0].arrival, clock.now());
    EXPECT_EQ(line.state().values, 2U);
    clock.advance(Seconds(6.0));
    EXPECT_TRUE(line.problem().contains(QStringLiteral("No data"))) << "by the clock of now";
}

TEST(ThreadedLine, TellsItsTroubles)
{
    const fakes::ManualClock clock;
    const ThreadedLine line(settingsOf(Transport::Tcp, fakes::unusedPort()), clock);
    EXPECT_TRUE(line.problem().isEmpty());
    ASSERT_TRUE(fakes::waitUntil([&] { return !line.problem().isEmpty(); }));
    EXPECT_TRUE(line.problem().contains(QStringLiteral("No connection to the program of the receiver")));
}

// The owner of the line takes no report meanwhile.
TEST(ThreadedLine, OfAFloodTheNewestValuesAreReportedInOneReport)
{
    const std::uint16_t port = fakes::unusedUdpPort();
    const fakes::ManualClock clock;
    LineWorker worker(settingsOf(Transport::Udp, port), clock);
    std::vector<LineReport> reports;
    QObject::connect(&worker, &LineWorker::reported, [&](const LineReport& report) { reports.push_back(report); });
    worker.open();
    ASSERT_EQ(reports.size(), 1U) << "it is open";
    QUdpSocket sender;
    const auto* const line = worker.findChild<PowerLine*>();
    for (int i = 0; i < 100; ++i) {
        sender.writeDatagram(QByteArray::number(-i), QHostAddress::LocalHost, port);
    }
    ASSERT_TRUE(fakes::waitUntil([line] { return line->state().values == 100; }));
    EXPECT_EQ(reports.size(), 1U) << "it was not taken yet";
    worker.taken();
    ASSERT_TRUE(fakes::waitUntil([&] { return reports.size() == 2; }));
    ASSERT_EQ(reports[1].values.size(), ThreadedLine::kMost);
    EXPECT_EQ(reports[1].values.back().decibels, -99.0);
    EXPECT_EQ(reports[1].values.front().decibels, -100.0 + static_cast<double>(ThreadedLine::kMost));
    EXPECT_EQ(reports[1].state.values, 100U);
}

}  // namespace
}  // namespace boresight::power
