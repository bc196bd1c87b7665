// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/local_client.h"

#include "core/local_socket/local_server.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <chrono>

namespace boresight::ctl {
namespace {

// Story: while the window reconnected its station, a command was answered with "no station".
// REQ-CTL-930: A command waits for a station that reconnects, within the time limit for an answer.
TEST(LocalClient, WaitsForAStationThatReconnects)
{
    constexpr std::uint16_t kPort = 4533;
    constexpr int kAttempts = 3;
    const QTemporaryDir runtime;
    const auto path = [&runtime] { return local::socketPath(runtime.path(), kPort); };
    local::LocalServer server(
        [](const local::LocalRequest&, const local::Reply& reply) { reply(local::LocalAnswer()); });
    int attempts = 0;
    QLocalSocket socket;
    const QDeadlineTimer patience(std::chrono::minutes(1));
    EXPECT_TRUE(connectBy(patience, path, socket, [&] {
        if (++attempts == kAttempts) {
            ASSERT_TRUE(server.listen(runtime.path(), kPort));
        }
    }));
    EXPECT_EQ(attempts, kAttempts);
}

// REQ-CTL-930
TEST(LocalClient, DoesNotWaitForEver)
{
    QLocalSocket socket;
    EXPECT_FALSE(connectBy(
        QDeadlineTimer(0), [] { return QStringLiteral("/nowhere/4533.sock"); }, socket, [] { FAIL(); }));
}

}  // namespace
}  // namespace boresight::ctl
