// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/magnetic_model.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/geomagnetism/legendre.h"

#include <cmath>

namespace boresight::geomagnetism {

namespace {

constexpr double kReferenceRadius = 6371.2;  // km, of the model
constexpr double kEquatorRadius = 6378.137;  // km, of the ellipsoid of WGS-84
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kNoticeYears = 0.5;

struct Vector
{
    double north = 0.0;
    double east = 0.0;
    double down = 0.0;
};

// A geodetic place in geocentric coordinates, and the angle between its geodetic and its geocentric horizon.
struct Geocentric
{
    double radius = 0.0;  // km
    double cosColatitude = 0.0;
    double sinColatitude = 0.0;
    double turn = 0.0;  // geocentric minus geodetic latitude, radians
};

Geocentric geocentric(const Site& site)
{
    const double latitude = site.latitude.radians();
    const double height = site.heightMetres / 1000.0;
    const double square = kFlattening * (2.0 - kFlattening);
    const double normal = kEquatorRadius / std::sqrt(1.0 - square * std::sin(latitude) * std::sin(latitude));
    const double fromAxis = (normal + height) * std::cos(latitude);
    const double fromEquator = (normal * (1.0 - square) + height) * std::sin(latitude);
    const double radius = std::hypot(fromAxis, fromEquator);
    return {.radius = radius,
            .cosColatitude = fromEquator / radius,
            .sinColatitude = fromAxis / radius,
            .turn = std::atan2(fromEquator, fromAxis) - latitude};
}

// The field of these terms at the site: north, east and down.
Vector fieldOf(const Terms& terms, const Geocentric& place, Angle longitude)
{
    const Legendre legendre(place.cosColatitude, place.sinColatitude);
    Vector field;
    for (int n = 1; n <= kDegree; ++n) {
        const double power = std::pow(kReferenceRadius / place.radius, n + 2);
        for (int m = 0; m <= n; ++m) {
            const auto [g, h] = terms[termIndex(n, m)];
            const double cosTurn = std::cos(m * longitude.radians());
            const double sinTurn = std::sin(m * longitude.radians());
            const double along = power * (g * cosTurn + h * sinTurn);
            field.north += along * legendre.slope(n, m);
            field.down -= (n + 1) * along * legendre.value(n, m);
            if (m > 0) {
                field.east += m * power * (g * sinTurn - h * cosTurn) * legendre.overSine(n, m);
            }
        }
    }
    const double cosTurn = std::cos(place.turn);
    const double sinTurn = std::sin(place.turn);
    return {.north = field.north * cosTurn - field.down * sinTurn,
            .east = field.east,
            .down = field.north * sinTurn + field.down * cosTurn};
}

double ratio(double part, double whole)
{
    return whole != 0.0 ? part / whole : 0.0;
}

FieldParts partsOf(const Vector& field)
{
    const double horizontal = std::hypot(field.north, field.east);
    return {.north = field.north,
            .east = field.east,
            .down = field.down,
            .horizontal = horizontal,
            .total = std::hypot(horizontal, field.down),
            .declination = Angle::fromRadians(std::atan2(field.east, field.north)),
            .inclination = Angle::fromRadians(std::atan2(field.down, horizontal))};
}

// Without a horizontal field the needle has no direction, so its change is 0.
FieldParts changeOf(const FieldParts& now, const Vector& change)
{
    const double horizontal = ratio(now.north * change.north + now.east * change.east, now.horizontal);
    const double sideways = ratio(now.north * change.east - now.east * change.north, now.horizontal);
    const double total = ratio(now.horizontal * horizontal + now.down * change.down, now.total);
    const double steeper = ratio(now.horizontal * change.down - now.down * horizontal, now.total);
    return {.north = change.north,
            .east = change.east,
            .down = change.down,
            .horizontal = horizontal,
            .total = total,
            .declination = Angle::fromRadians(ratio(sideways, now.horizontal)),
            .inclination = Angle::fromRadians(ratio(steeper, now.total))};
}

QString yearText(double year)
{
    return toQString(formatFixed(year, 2));
}

}  // namespace

Result<MagneticField> MagneticModel::at(const Site& site, double year) const
{
    if (!(year >= validFrom() && year <= validTo() + kYearsBeyond)) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("The magnetic model %1 is valid from %2 to %3, not in %4. Get the present World "
                                "Magnetic Model (.COF), or enter the declination.")
                           .arg(toQString(name()), yearText(validFrom()), yearText(validTo()), yearText(year)));
    }
    Terms terms = m_coefficients.main;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        terms[i].g += (year - m_coefficients.epoch) * m_coefficients.change[i].g;
        terms[i].h += (year - m_coefficients.epoch) * m_coefficients.change[i].h;
    }
    const Geocentric place = geocentric(site);
    const FieldParts now = partsOf(fieldOf(terms, place, site.longitude));
    return MagneticField{.now = now,
                         .changePerYear = changeOf(now, fieldOf(m_coefficients.change, place, site.longitude))};
}

QString MagneticModel::expiry(double year) const
{
    if (!(year >= validTo() - kNoticeYears)) {
        return {};
    }
    if (year > validTo()) {
        return Text::tr(
                   "The magnetic model %1 was valid until %2. Its declination is less exact each year. Get the present "
                   "World Magnetic Model (.COF).")
            .arg(toQString(name()), yearText(validTo()));
    }
    return Text::tr("The magnetic model %1 is valid until %2. Get the next model before then.")
        .arg(toQString(name()), yearText(validTo()));
}

}  // namespace boresight::geomagnetism
