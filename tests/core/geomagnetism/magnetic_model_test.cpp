// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/magnetic_model.h"

#include "tests/core/geomagnetism/synthetic_model.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace boresight;
using namespace boresight::geomagnetism;

namespace {

constexpr double kEquator = 6378.137;                             // km, WGS-84
constexpr double kPole = kEquator * (1.0 - 1.0 / 298.257223563);  // km
constexpr Site kZeroZero{};

double shrunk(double kilometres, int power)
{
    return std::pow(6371.2 / kilometres, power);
}

MagneticModel modelOf(const SyntheticTerms& terms)
{
    return MagneticModel(parseCoefficients(coefficientText(terms, "2025.0 TEST 01/01/2025")).value());
}

MagneticModel fieldOf(int n, int m, double g, double h)
{
    return modelOf({{{n, m}, {.main = {g, h}}}});
}

Site site(double latitude, double longitude, double metres = 0.0)
{
    return {Angle::fromDegrees(latitude), Angle::fromDegrees(longitude), metres};
}

FieldParts at(const MagneticModel& model, const Site& place, double year = 2025.0)
{
    return model.at(place, year).value().now;
}

// A model with several kinds of terms that change with time.
MagneticModel mixed()
{
    return modelOf({{{1, 0}, {{-29351.8, 0.0}, {12.0, 0.0}}},
                    {{1, 1}, {{-1410.8, 4545.4}, {9.7, -21.5}}},
                    {{2, 1}, {{2950.0, -3100.0}, {-5.0, -25.0}}},
                    {{5, 3}, {{-140.0, 12.0}, {1.2, 0.8}}},
                    {{12, 7}, {{400.0, -300.0}, {2.0, 1.0}}}});
}

}  // namespace

// A dipole along the axis. North of the equator its needle points down, and at the pole the field is twice as strong.
// REQ-GEOMAGNETISM-03: Closed forms of single terms are met on the ellipsoid, at the equator, in between, and exactly
// at the poles.
TEST(MagneticModel, AnAxialDipoleHasItsClosedForm)
{
    const MagneticModel dipole = fieldOf(1, 0, -30000.0, 0.0);
    const FieldParts equator = at(dipole, site(0.0, 77.0, 1000.0));
    EXPECT_NEAR(equator.north, 30000.0 * shrunk(kEquator + 1.0, 3), 1e-6);
    EXPECT_NEAR(equator.east, 0.0, 1e-9);
    EXPECT_NEAR(equator.down, 0.0, 1e-6);
    EXPECT_NEAR(equator.declination.degrees(), 0.0, 1e-9);
    const FieldParts pole = at(dipole, site(90.0, 77.0));
    EXPECT_NEAR(pole.down, 60000.0 * shrunk(kPole, 3), 1e-6);
    EXPECT_NEAR(pole.horizontal, 0.0, 1e-6);
    EXPECT_NEAR(pole.inclination.degrees(), 90.0, 1e-6);
    EXPECT_NEAR(at(dipole, site(-90.0, 0.0)).down, -60000.0 * shrunk(kPole, 3), 1e-6);
}

// In between, tan of the geocentric latitude is (b/a)² times that of the geodetic latitude. The field strength follows
// from it.
// REQ-GEOMAGNETISM-03
TEST(MagneticModel, TheGroundIsThatOfTheEllipsoid)
{
    const double latitude = std::atan(std::pow(kPole / kEquator, 2) * std::tan(Angle::fromDegrees(50.0).radians()));
    const double radius = kEquator * kPole / std::hypot(kPole * std::cos(latitude), kEquator * std::sin(latitude));
    const FieldParts field = at(fieldOf(1, 0, -30000.0, 0.0), site(50.0, 10.0));
    EXPECT_NEAR(field.total, 30000.0 * shrunk(radius, 3) * std::sqrt(1.0 + 3.0 * std::pow(std::sin(latitude), 2)),
                1e-6);
    const double needle = std::atan2(2.0 * std::sin(latitude), std::cos(latitude));  // below the geocentric horizon
    const double turned = Angle::fromDegrees(50.0).radians() - latitude;
    EXPECT_NEAR(field.inclination.radians(), needle - turned, 1e-9);
}

// A dipole across the axis is horizontal at the poles, where every direction is a meridian. All values are finite
// there, and the declination is the longitude.
// REQ-GEOMAGNETISM-03
TEST(MagneticModel, ThePolesAreExact)
{
    for (const double longitude : {-150.0, 0.0, 33.0, 90.0}) {
        const FieldParts north = at(fieldOf(1, 1, 5000.0, 0.0), site(90.0, longitude));
        EXPECT_NEAR(north.horizontal, 5000.0 * shrunk(kPole, 3), 1e-6);
        EXPECT_NEAR(north.declination.degrees(), longitude, 1e-9);
        EXPECT_NEAR(north.down, 0.0, 1e-6);
        const FieldParts south = at(fieldOf(1, 1, 5000.0, 0.0), site(-90.0, longitude));
        EXPECT_NEAR(south.horizontal, 5000.0 * shrunk(kPole, 3), 1e-6);
        const Angle away = south.declination - Angle::fromDegrees(180.0 - longitude);
        EXPECT_NEAR(away.wrapped180().degrees(), 0.0, 1e-9);
    }
    const MagneticModel all = mixed();
    for (const double pole : {90.0, -90.0}) {
        const FieldParts exactly = at(all, site(pole, 20.0));
        const FieldParts beside = at(all, site(pole * (1.0 - 1e-9), 20.0));
        EXPECT_NEAR(exactly.north, beside.north, 0.01);
        EXPECT_NEAR(exactly.east, beside.east, 0.01);
        EXPECT_NEAR(exactly.down, beside.down, 0.01);
    }
}

// REQ-GEOMAGNETISM-03
TEST(MagneticModel, HigherTermsHaveTheirClosedForms)
{
    EXPECT_NEAR(at(fieldOf(2, 0, 1000.0, 0.0), kZeroZero).down, 1500.0 * shrunk(kEquator, 4), 1e-6);
    EXPECT_NEAR(at(fieldOf(2, 1, 1000.0, 0.0), kZeroZero).north, -std::sqrt(3.0) * 1000.0 * shrunk(kEquator, 4), 1e-6);
    // P(12, 12) at the equator is 23!! √(2 / 24!).
    double doubleFactorial = 1.0;
    for (int odd = 1; odd <= 23; odd += 2) {
        doubleFactorial *= odd;
    }
    const double sectoral = doubleFactorial * std::sqrt(2.0 / std::tgamma(25.0));
    EXPECT_NEAR(at(fieldOf(12, 12, 0.0, 100.0), site(0.0, 7.5)).down, -13.0 * 100.0 * sectoral * shrunk(kEquator, 14),
                1e-6);
    EXPECT_NEAR(at(fieldOf(12, 12, 100.0, 0.0), site(0.0, 7.5)).east, 12.0 * 100.0 * sectoral * shrunk(kEquator, 14),
                1e-6);
}

// The reported yearly change agrees with the values of the following years.
// REQ-GEOMAGNETISM-04: The yearly change is the change from year to year.
TEST(MagneticModel, TellsTheChangeThatTheYearsBring)
{
    const MagneticModel model = mixed();
    for (const Site& place : {site(38.8, -9.1), site(-33.9, 151.2), site(78.2, 15.4), site(90.0, 30.0)}) {
        const FieldParts change = model.at(place, 2027.0).value().changePerYear;
        const FieldParts before = at(model, place, 2026.99);
        const FieldParts after = at(model, place, 2027.01);
        const auto perYear = [&](double FieldParts::*part) { return (after.*part - before.*part) / 0.02; };
        const auto turnPerYear = [&](Angle FieldParts::*part) { return (after.*part - before.*part).degrees() / 0.02; };
        EXPECT_NEAR(change.north, perYear(&FieldParts::north), 1e-6);
        EXPECT_NEAR(change.east, perYear(&FieldParts::east), 1e-6);
        EXPECT_NEAR(change.down, perYear(&FieldParts::down), 1e-6);
        EXPECT_NEAR(change.horizontal, perYear(&FieldParts::horizontal), 1e-4);
        EXPECT_NEAR(change.total, perYear(&FieldParts::total), 1e-4);
        EXPECT_NEAR(change.declination.degrees(), turnPerYear(&FieldParts::declination), 1e-6);
        EXPECT_NEAR(change.inclination.degrees(), turnPerYear(&FieldParts::inclination), 1e-6);
    }
}

// REQ-GEOMAGNETISM-05: A model is used for its five years and one more. From the last half year on its end is reported.
// Outside this time it is refused with the reason.
TEST(MagneticModel, IsRefusedOutsideItsFiveYearsAndTheOneAfter)
{
    const MagneticModel model = mixed();
    EXPECT_TRUE(model.at(kZeroZero, 2025.0));
    EXPECT_TRUE(model.at(kZeroZero, 2030.0));
    EXPECT_TRUE(model.at(kZeroZero, 2031.0));
    const auto late = model.at(kZeroZero, 2031.01);
    ASSERT_FALSE(late);
    EXPECT_EQ(late.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(textOf(late.error()),
              "The magnetic model TEST is valid from 2025.00 to 2030.00, not in 2031.01. Get the present World "
              "Magnetic Model (.COF), or enter the declination.");
    EXPECT_FALSE(model.at(kZeroZero, 2024.99));
    EXPECT_FALSE(model.at(kZeroZero, std::nan("")));
}

// REQ-GEOMAGNETISM-05
TEST(MagneticModel, WarnsFromItsLastHalfYearOn)
{
    const MagneticModel model = mixed();
    EXPECT_EQ(model.expiry(2029.49).toStdString(), "");
    EXPECT_EQ(model.expiry(2029.51).toStdString(),
              "The magnetic model TEST is valid until 2030.00. Get the next model before then.");
    EXPECT_EQ(model.expiry(2030.2).toStdString(),
              "The magnetic model TEST was valid until 2030.00. Its declination is less exact each year. Get the "
              "present World Magnetic Model (.COF).");
}

// 2000 and 6000 nT are the limits in the report of the World Magnetic Model.
// REQ-GEOMAGNETISM-06: Below a horizontal field of 6000 nT a compass is doubtful, below 2000 nT it is no evidence.
TEST(MagneticModel, TellsWhereACompassIsNoEvidence)
{
    const auto zone = [](double horizontal) { return compassZone({.horizontal = horizontal}); };
    EXPECT_EQ(zone(1999.0), CompassZone::Blackout);
    EXPECT_EQ(zone(2000.0), CompassZone::Caution);
    EXPECT_EQ(zone(5999.0), CompassZone::Caution);
    EXPECT_EQ(zone(6000.0), CompassZone::Good);
}

// Without a horizontal field the needle has no direction, and no value is NaN or infinite.
TEST(MagneticModel, WhereTheNeedleHasNoDirectionNothingIsInfinite)
{
    const MagneticField none = modelOf({}).at(kZeroZero, 2026.0).value();
    EXPECT_EQ(none.changePerYear, FieldParts{});
    EXPECT_EQ(none.now.declination, 0_deg);
}
