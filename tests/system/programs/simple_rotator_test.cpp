// SPDX-License-Identifier: GPL-3.0-or-later
// boresightd --simulate=simple: the whole station on the simplest rotator, driven over rotctld.
#include "tests/fakes/wait_until.h"
#include "tests/system/programs/boresightd_process.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace boresight::system_test {
namespace {

std::pair<double, double> position(fakes::TcpPeer& client)
{
    std::istringstream reply(client.ask("p\n", 2));
    std::pair<double, double> place{-1.0, -1.0};
    reply >> place.first >> place.second;
    return place;
}

// REQ-MOUNT-05 (SimpleRotator.*): `--simulate=simple` is the station on the simplest rotator, which reads whole
// degrees. An unknown kind is refused with the list of kinds.
TEST(SimpleRotator, ArrivesWhereAClientSendsItAndReadsWholeDegrees)
{
    BoresightdProcess daemon({QStringLiteral("--simulate=simple")});
    ASSERT_TRUE(daemon.listens()) << daemon.complaints();
    const auto client = daemon.connect();
    ASSERT_TRUE(fakes::waitUntil([&] { return client->ask("P 30.4 12.3\n") == "RPRT 0\n"; }));
    const auto arrived = [&] { return position(*client) == std::pair(30.0, 12.0); };
    bool whole = true;
    EXPECT_TRUE(fakes::waitUntil(
        [&] {
            const auto [azimuth, elevation] = position(*client);
            whole = whole && azimuth == std::round(azimuth) && elevation == std::round(elevation);
            return arrived();
        },
        std::chrono::seconds(60)));
    EXPECT_TRUE(whole);
    EXPECT_EQ(daemon.terminate(), 0);
}

// REQ-ROTCTLDMOUNT-51: `--simulate=rotctld` is the station on Hamlib's dummy rotator.
TEST(SimulatedRotctld, ArrivesWhereAClientSendsIt)
{
    BoresightdProcess daemon({QStringLiteral("--simulate=rotctld")});
    ASSERT_TRUE(daemon.listens()) << daemon.complaints();
    const auto client = daemon.connect();
    ASSERT_TRUE(fakes::waitUntil([&] { return client->ask("P 30.4 12.3\n") == "RPRT 0\n"; })) << daemon.complaints();
    EXPECT_TRUE(fakes::waitUntil([&] {
        const auto [azimuth, elevation] = position(*client);
        return std::abs(azimuth - 30.4) < 0.06 && std::abs(elevation - 12.3) < 0.06;
    }));
    EXPECT_EQ(daemon.terminate(), 0);
}

// REQ-GS232-100: `--simulate=gs232` and `--simulate=esp32` are the station on a simulated box of this kind. At the
// first start the travel fits the box.
TEST(SimulatedBoxes, ArriveWhereAClientSendsThem)
{
    for (const char* const kind : {"gs232", "esp32"}) {
        BoresightdProcess daemon({QStringLiteral("--simulate=%1").arg(QLatin1String(kind))});
        ASSERT_TRUE(daemon.listens()) << daemon.complaints();
        const auto client = daemon.connect();
        ASSERT_TRUE(fakes::waitUntil([&] { return position(*client).first > 0.0 || position(*client).first == 0.0; }))
            << kind;
        const double target = std::string_view(kind) == "esp32" ? 186.0 : 6.0;
        ASSERT_TRUE(fakes::waitUntil([&] {
            return client->ask("P " + std::to_string(target) + " 24\n") == "RPRT 0\n";
        })) << kind
            << daemon.complaints();
        EXPECT_TRUE(fakes::waitUntil([&] {
            const auto [azimuth, elevation] = position(*client);
            return std::abs(azimuth - target) <= 2.1 && std::abs(elevation - 24.0) <= 2.1;
        })) << kind;
        EXPECT_EQ(daemon.terminate(), 0);
    }
}

TEST(SimpleRotator, AnotherKindIsRefused)
{
    BoresightdProcess daemon({QStringLiteral("--simulate=nonsense")});
    EXPECT_FALSE(daemon.listens());
    EXPECT_NE(daemon.complaints().find(
                  "--simulate=nonsense is unknown. Use --simulate for the drivers of the profile, or one of"),
              std::string::npos);
}

}  // namespace
}  // namespace boresight::system_test
