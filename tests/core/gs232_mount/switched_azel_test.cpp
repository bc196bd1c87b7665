// SPDX-License-Identifier: GPL-3.0-or-later
// A GS-232 rotator with rare motor starts that tracks the Moon by WSJT-X.
#include "core/ephemeris/rise_set.h"
#include "tests/core/gs232_mount/gs232_bench.h"
#include "tests/fakes/azel_writer.h"

#include <gtest/gtest.h>

namespace boresight::gs232 {
namespace {

const Site kLisbon{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

profile::Profile moonProfile()
{
    profile::Profile profile = switchedProfile();
    profile.site = {.known = true,
                    .latitude = kLisbon.latitude,
                    .longitude = kLisbon.longitude,
                    .heightMetres = kLisbon.heightMetres};
    profile.azel = {.onlyWhileReceiving = profile::OnlyWhileReceiving::On};
    return profile;
}

class SwitchedMotorAzel : public testing::Test
{
protected:
    SwitchedMotorAzel()
    {
        ephemeris::Almanac almanac(kLisbon);
        bench.clock().setUtc(
            ephemeris::nextRise(almanac, ephemeris::Body::Moon, bench.clock().utc(), 40_deg).value_or(UtcTime{}));
    }
    void run(int seconds)
    {
        for (int second = 0; second < seconds; ++second) {
            (void)bench.control().receive(writer.readingAt(bench.clock().utc()));
            bench.run(Seconds(1.0));
        }
    }

    Gs232Bench bench{moonProfile()};
    fakes::AzelWriter writer{kLisbon};
};

// REQ-AZEL-924: While WSJT-X transmits, no motor starts: an axis that stands in its dead-band stays there.
TEST_F(SwitchedMotorAzel, StartsNoMotorWhileTheRadioTransmits)
{
    run(3);
    ASSERT_TRUE(bench.ask(request::FollowAzel{}));
    run(60);
    const int before = bench.box().starts();
    int whileTransmitting = 0;
    for (int minute = 0; minute < 40; ++minute) {
        writer.flag = ", T";
        const int starts = bench.box().starts();
        run(50);
        whileTransmitting += bench.box().starts() - starts;
        writer.flag = ", R";
        run(50);
    }
    EXPECT_EQ(whileTransmitting, 0);
    EXPECT_GT(bench.box().starts(), before) << "it tracks the Moon";
    EXPECT_FALSE(bench.control().faultLatched());
}

}  // namespace
}  // namespace boresight::gs232
