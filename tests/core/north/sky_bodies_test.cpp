// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/sky_bodies.h"

#include <gtest/gtest.h>

using namespace boresight;
using ephemeris::Body;

namespace {

const UtcTime kMorning{std::chrono::sys_days{std::chrono::March / 20 / 2026} + std::chrono::hours(3)};

SkyBodies vienna()
{
    return SkyBodies({.known = true, .latitude = 48.2_deg, .longitude = 16.37_deg, .heightMetres = 200.0});
}

int known(const SkyBodies& bodies)
{
    int count = 0;
    for (const Body body : kBodies) {
        count += (bodies.times(body).rise ? 1 : 0) + (bodies.times(body).set ? 1 : 0);
    }
    return count;
}

}  // namespace

// All four searches in one tick of 20 ms took 59 ms.
// REQ-NORTH-37a (SkyBodies.*): Rise and set of Sun and Moon are searched one after the other, so that no tick waits for
// four searches.
TEST(SkyBodies, OneTimeIsSearchedAtOnce)
{
    SkyBodies bodies = vienna();
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(i, known(bodies));
        bodies.lookAhead(kMorning + std::chrono::milliseconds(250 * i));
    }
    EXPECT_EQ(4, known(bodies));
}

TEST(SkyBodies, ATimeThatHasPassedIsLookedForAnew)
{
    SkyBodies bodies = vienna();
    for (int i = 0; i < 4; ++i) {
        bodies.lookAhead(kMorning);
    }
    const UtcTime rise = bodies.times(Body::Sun).rise.value();
    bodies.lookAhead(rise - std::chrono::hours(30));  // the clock was set back
    EXPECT_LT(bodies.times(Body::Sun).rise.value(), rise - std::chrono::hours(23));
    bodies.lookAhead(rise + std::chrono::seconds(1));
    EXPECT_GT(bodies.times(Body::Sun).rise.value(), rise + std::chrono::hours(23));
}

TEST(SkyBodies, NothingIsKnownWithoutASite)
{
    SkyBodies bodies({});
    bodies.lookAhead(kMorning);
    EXPECT_EQ(0, known(bodies));
    EXPECT_FALSE(bodies.direction(Body::Sun, ephemeris::Refraction::Light, kMorning));
}
