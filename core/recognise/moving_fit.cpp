// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognise/moving_fit.h"

#include <algorithm>
#include <cmath>

namespace boresight::recognise {
namespace {

// The clock of the client may be wrong by 3 s, and its position may be half a second old.
constexpr Seconds kClock{3.5};
// An error of the clock of this size is as likely as elements that are off by kAcross.
constexpr Seconds kUsualClock{1.5};
constexpr Angle kAcross = 0.2_deg;
constexpr Angle kFarthestAcross = 0.8_deg;
// Between two points the path must travel like the client, within this part and this angle.
constexpr double kTravelPart = 0.2;
constexpr Angle kTravelRest = 0.05_deg;
constexpr Seconds kApart{0.5};
constexpr int kRounds = 6;

// Where the path is nearest to a point.
struct Nearest
{
    orbit::Vector unit;
    Seconds ahead;      // of the time at which the point arrived
    Angle lead;         // the same along the path. 0: the point is behind
    double rate = 0.0;  // rad/s
};

UtcTime later(UtcTime utc, Seconds time)
{
    return utc + std::chrono::round<UtcTime::duration>(time);
}

std::optional<Nearest> nearestTo(const SentPoint& point, const UnitAt& unitAt, Angle lead)
{
    const orbit::Vector wanted = unitOf(point.direction);
    Nearest found{};
    for (int round = 0; round < kRounds; ++round) {
        const auto here = unitAt(later(point.utc, found.ahead));
        const auto next = unitAt(later(point.utc, found.ahead + kApart));
        if (!here || !next) {
            return std::nullopt;
        }
        const orbit::Vector rate = (1.0 / kApart.count()) * (*next - *here);
        found.unit = *here;
        found.rate = length(rate);
        if (found.rate <= 0.0) {
            break;
        }
        const Seconds ahead = found.ahead + Seconds(dot(wanted - *here, rate) / dot(rate, rate));
        const Seconds latest = kClock + Seconds(lead.radians() / found.rate);
        const Seconds bounded = std::clamp(ahead, -kClock, latest);
        if (std::chrono::abs(bounded - found.ahead) < Seconds(0.01)) {
            break;
        }
        found.ahead = bounded;
    }
    if (const auto present = unitAt(point.utc); present && found.ahead > Seconds(0.0)) {
        found.lead = angleBetween(*present, found.unit);
    }
    return found;
}

}  // namespace

std::optional<MovingFit> movingFit(const SentPoints& points, const UnitAt& unitAt)
{
    const Angle lead = leadOf(points);
    const Angle step = stepOf(points);
    std::vector<Nearest> found;
    double across = 0.0;
    for (const SentPoint& point : points) {
        const auto nearest = nearestTo(point, unitAt, lead);
        const Angle off = nearest ? angleBetween(nearest->unit, unitOf(point.direction)) : 180_deg;
        if (off > kFarthestAcross + 0.5 * step) {
            return std::nullopt;
        }
        across += std::pow(off / (kAcross + 0.5 * step), 2);
        found.push_back(*nearest);
    }
    const orbit::Vector sent = unitOf(points.back().direction) - unitOf(points.front().direction);
    const orbit::Vector seen = found.back().unit - found.front().unit;
    if (length(sent - seen) > kTravelPart * length(sent) + (kTravelRest + step).radians()) {
        return std::nullopt;
    }
    const auto [earliest, latest] = std::ranges::minmax(found, {}, &Nearest::ahead);
    const double slowest = std::ranges::min(found, {}, &Nearest::rate).rate;
    const Seconds led(slowest > 0.0 ? (lead + step).radians() / slowest : 0.0);
    if (latest.ahead - earliest.ahead > kUsualClock + led) {
        return std::nullopt;
    }
    // A time ahead that the lead explains is no error of the clock.
    const Seconds clock = std::max({earliest.ahead - led, -latest.ahead, Seconds(0.0)});
    return MovingFit{.misfit = across / static_cast<double>(points.size()) + std::pow(clock / kUsualClock, 2),
                     .lead = std::ranges::max(found, {}, &Nearest::lead).lead};
}

}  // namespace boresight::recognise
