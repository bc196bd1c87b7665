// SPDX-License-Identifier: GPL-3.0-or-later
// Readings of the wind from the page of a web server.
#include "core/inputs/station_wind.h"
#include "tests/core/station/moving_station.h"
#include "tests/fakes/canned_web.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

// REQ-WIND-43: The page of a web server is read at the interval in the profile, and each page is a reading. If the
// server does not answer, this is reported, and the alarm about the silence has the reason.
TEST(StationWindPage, IsRead)
{
    const QTemporaryDir folder;
    MovingStation moving(folder.path());
    Station& station = *moving.station;
    fakes::CannedWeb web;
    web.answersWith("/live", "200 OK", {}, R"({"wind": {"speed": 9.0}})");
    profile::Profile profile = anyPort();
    profile.wind.source = web.address("/live");
    profile.wind.format.key = "wind.speed";
    profile.wind.poll = Seconds(1.0);
    station.reload(profile);
    ASSERT_TRUE(fakes::waitUntil([&] { return station.status().wind.accepted > 0; }));
    EXPECT_EQ(station.status().wind.speed, 9.0);
    web.stopListening();
    ASSERT_TRUE(fakes::waitUntil([&] { return !station.status().wind.trouble.isEmpty(); }));
    moving.run(Seconds(31.0));
    const auto alarms = station.status().alarms;
    EXPECT_TRUE(std::ranges::any_of(alarms, [](const Alarm& one) {
        return one.name == QLatin1String("wind.silent") && one.what.contains(QLatin1String("/live: "));
    })) << "the alarm has the reason";
}

}  // namespace
}  // namespace boresight
