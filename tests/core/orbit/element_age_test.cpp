// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/element_age.h"

#include "core/elements/julian_date.h"

#include <gmock/gmock.h>

namespace boresight::orbit {
namespace {

using testing::AllOf;
using testing::DoubleNear;
using testing::Ge;
using testing::Le;

constexpr std::chrono::hours kDay{24};
const UtcTime kEpoch = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21};

ElementSet orbitOf(double revolutionsPerDay, double meanMotionDot)
{
    return {.epoch = julianDate(kEpoch), .revolutionsPerDay = revolutionsPerDay, .meanMotionDot = meanMotionDot};
}

// REQ-ORBIT-30: The expected error of elements along the orbit grows by 1 to 3 km a day for low orbits, faster with
// atmospheric drag, and never exceeds half an orbit.
TEST(ElementAge, TheErrorGrowsWithAgeAndDrag)
{
    const ElementSet high = orbitOf(14.2, 1e-6);       // 850 km
    const ElementSet station = orbitOf(15.5, 1.6e-4);  // the ISS
    const auto kilometres = [](const ElementSet& set, int days) {
        return expectedError(set, kEpoch + days * kDay).kilometres;
    };
    EXPECT_THAT(kilometres(high, 0), Le(1.0));
    EXPECT_THAT(kilometres(high, 10) / 10.0, AllOf(Ge(1.0), Le(3.0)));
    EXPECT_THAT(kilometres(station, 1), AllOf(Ge(2.0), Le(5.0)));
    EXPECT_THAT(kilometres(station, 10), AllOf(Ge(100.0), Le(200.0))) << "drag grows with the square";
    EXPECT_EQ(kilometres(station, -10), kilometres(station, 10));
    EXPECT_THAT(expectedError(station, kEpoch + 10 * kDay).time.count(),
                DoubleNear(kilometres(station, 10) / 7.66, 0.5));  // with the speed of the ISS
    EXPECT_THAT(expectedError(station, kEpoch + 3000 * kDay).time.count(), DoubleNear(86400 / 15.5 / 2, 1.0));
}

}  // namespace
}  // namespace boresight::orbit
