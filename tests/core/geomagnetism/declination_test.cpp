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

// 0.87° west in Lisbon; the sensor's firmware, made for Berlin, has added 5.07°.
// REQ-GEOMAGNETISM-07: A declination is applied once: by the sensor, by Boresight or not at all. One that is not known
// is never 0.
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
    EXPECT_EQ(describe(unknown).toStdString(),
              "Declination by Boresight: the declination of this place is not known: type it, or "
              "give site and magnetic model");
    EXPECT_TRUE(declinationCorrection({.by = DeclinationBy::Sensor})) << "nothing is needed";
}

// REQ-GEOMAGNETISM-08: What is done is reported with its numbers. A sensor made for another place is doubted.
TEST(Declination, IsSaidInWordsWithTheNumbers)
{
    EXPECT_EQ(describe(lisbon(DeclinationBy::Sensor)).toStdString(),
              "Declination by the sensor: it has added +5.07°, Boresight adds nothing");
    EXPECT_EQ(describe(lisbon(DeclinationBy::Boresight)).toStdString(),
              "Declination by Boresight: the sensor's +5.07° is taken away and -0.87° by the magnetic model is added, "
              "together -5.94°");
    EXPECT_EQ(describe({.by = DeclinationBy::Boresight, .inSensor = 0_deg, .here = 12.5_deg}).toStdString(),
              "Declination by Boresight: the sensor's +0.00° is taken away and +12.50° as typed is added, together "
              "+12.50°");
    EXPECT_EQ(describe(lisbon(DeclinationBy::None)).toStdString(),
              "No declination: the heading stays as it comes, with the sensor's +5.07° in it");
}

// REQ-GEOMAGNETISM-08
TEST(Declination, ASensorMadeForAnotherPlaceIsDoubted)
{
    const std::string wrong =
        "the declination here is -0.87° by the magnetic model, the sensor has added +5.07°: its headings are +5.94° "
        "off";
    EXPECT_EQ(doubt(lisbon(DeclinationBy::Sensor)).toStdString(), wrong);
    EXPECT_EQ(doubt(lisbon(DeclinationBy::None)).toStdString(), wrong);
    EXPECT_EQ(doubt(lisbon(DeclinationBy::Boresight)).toStdString(), "");
    EXPECT_EQ(doubt({.by = DeclinationBy::Sensor, .here = 5.3_deg}).toStdString(), "")
        << "near enough: Berlin some years later";
    EXPECT_EQ(doubt({.by = DeclinationBy::Sensor}).toStdString(), "") << "nobody knows";
}
