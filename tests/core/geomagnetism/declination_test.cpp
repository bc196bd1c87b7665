// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/declination.h"

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::geomagnetism;

namespace {

Declination lisbon(DeclinationBy by)
{
    return {.by = by, .here = -0.87_deg, .origin = DeclinationOrigin::Model};
}

}  // namespace

// 0.87° west in Lisbon. The firmware of the sensor, made for Berlin, has added 5.07°.
// REQ-GEOMAGNETISM-07: A declination is applied once: by the sensor, by Boresight or not at all. An unknown declination
// is never treated as 0.
TEST(Declination, IsAppliedOnce)
{
    EXPECT_NEAR(declinationCorrection(lisbon(DeclinationBy::Boresight))->degrees(), -5.94, 1e-9);
    EXPECT_EQ(declinationCorrection(lisbon(DeclinationBy::Sensor)), 0_deg);
    EXPECT_EQ(declinationCorrection(lisbon(DeclinationBy::None)), 0_deg);
    Declination plain = lisbon(DeclinationBy::Boresight);
    plain.inSensor = 0_deg;
    EXPECT_NEAR(declinationCorrection(plain)->degrees(), -0.87, 1e-9);
}

// REQ-GEOMAGNETISM-07
TEST(Declination, OneThatIsNotKnownIsNeverZero)
{
    const Declination unknown{.by = DeclinationBy::Boresight};
    ASSERT_FALSE(declinationCorrection(unknown));
    EXPECT_EQ(declinationCorrection(unknown).error().code, ErrorCode::NotAvailable);
    EXPECT_EQ(
        describe(unknown).toStdString(),
        "Boresight cannot apply the declination. The declination of this site is not known. Enter it, or enter the "
        "site and the file of the magnetic model.");
    EXPECT_TRUE(declinationCorrection({.by = DeclinationBy::Sensor})) << "nothing is needed";
}

// REQ-GEOMAGNETISM-08: The correction is reported with its numbers. A sensor made for another place is reported as
// doubtful.
TEST(Declination, IsSaidInWordsWithTheNumbers)
{
    EXPECT_EQ(describe(lisbon(DeclinationBy::Sensor)).toStdString(),
              "The sensor applies the declination (+5.07°). Boresight adds nothing.");
    EXPECT_EQ(describe(lisbon(DeclinationBy::Boresight)).toStdString(),
              "Boresight adds a declination of -0.87° (magnetic model) and removes the sensor's +5.07°. The sum is "
              "-5.94°.");
    EXPECT_EQ(describe({.by = DeclinationBy::Boresight, .inSensor = 0_deg, .here = 12.5_deg}).toStdString(),
              "Boresight adds a declination of +12.50° (entered) and removes the sensor's +0.00°. The sum is +12.50°.");
    EXPECT_EQ(describe(lisbon(DeclinationBy::None)).toStdString(),
              "Nothing corrects the declination. The sensor adds +5.07° to the heading.");
}

// REQ-GEOMAGNETISM-08
TEST(Declination, ASensorMadeForAnotherPlaceIsDoubted)
{
    const std::string wrong =
        "The declination here is -0.87° (magnetic model), but the sensor added +5.07°. Its headings are off by "
        "+5.94°.";
    EXPECT_EQ(doubt(lisbon(DeclinationBy::Sensor)).toStdString(), wrong);
    EXPECT_EQ(doubt(lisbon(DeclinationBy::None)).toStdString(), wrong);
    EXPECT_EQ(doubt(lisbon(DeclinationBy::Boresight)).toStdString(), "");
    EXPECT_EQ(doubt({.by = DeclinationBy::Sensor, .here = 5.3_deg}).toStdString(), "")
        << "near enough: Berlin some years later";
    EXPECT_EQ(doubt({.by = DeclinationBy::Sensor}).toStdString(), "") << "nobody knows";
}
