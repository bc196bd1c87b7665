// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/atomic_time.h"

#include "core/elements/iso_epoch.h"

#include <gtest/gtest.h>

namespace boresight::tables {
namespace {

using namespace std::chrono_literals;

AtomicTime written(const char* text, TimeSystem system)
{
    return atomicTime(orbit::parseIsoEpoch(text).value(), system);
}

// REQ-TABLES-900: A moment is the same in UTC, TAI, GPS and TT. A leap second counts like any other second.
TEST(AtomicTime, IsTheSameInEverySystem)
{
    const AtomicTime time = written("2026-11-27T12:00:00", TimeSystem::Utc);
    EXPECT_EQ(written("2026-11-27T12:00:37", TimeSystem::Tai), time);
    EXPECT_EQ(written("2026-11-27T12:00:18", TimeSystem::Gps), time);
    EXPECT_EQ(written("2026-11-27T12:01:09.184", TimeSystem::Tt), time);
    EXPECT_EQ(written("2016-12-31T23:59:60", TimeSystem::Utc), written("2016-12-31T23:59:59", TimeSystem::Utc) + 1s);
    EXPECT_EQ(written("2017-01-01T00:00:00", TimeSystem::Utc),
              written("2016-12-31T23:59:60.5", TimeSystem::Utc) + 500ms);
    EXPECT_EQ(written("2017-01-01T00:00:36", TimeSystem::Tai), written("2016-12-31T23:59:60", TimeSystem::Utc));
}

// REQ-TABLES-900
TEST(AtomicTime, GoesToUtcAndBack)
{
    const UtcTime midnight = std::chrono::sys_days(std::chrono::year(2017) / 1 / 1);
    for (const auto& apart : {-40s, -37s, -36s, -1s, 0s, 1s, 36s, 37s, 86400s}) {
        EXPECT_EQ(utcTime(atomicTime(midnight + apart)), midnight + apart) << apart.count();
    }
    EXPECT_EQ(utcTime(atomicTime(midnight) - 1ns), midnight + 1s - 1ns) << "the leap second is the second after it";
    for (const int year : {1958, 1972, 2199}) {
        const UtcTime utc = std::chrono::sys_days(std::chrono::year(year) / 6 / 1) + 12h;
        EXPECT_EQ(utcTime(atomicTime(utc)), utc) << year;
    }
}

TEST(AtomicTime, KnowsTheNamesOfTheSystems)
{
    EXPECT_EQ(timeSystem("GPS"), TimeSystem::Gps);
    EXPECT_EQ(timeSystem("TDT"), TimeSystem::Tt);
    EXPECT_FALSE(timeSystem("UT1"));
    EXPECT_FALSE(timeSystem(""));
}

}  // namespace
}  // namespace boresight::tables
