// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognise/recognise.h"

#include "core/ephemeris/sky_object.h"
#include "core/orbit/sgp4.h"
#include "core/recognise/rise_search.h"
#include "core/targets/target_path.h"
#include "core/targets/track_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace boresight::recognise {
namespace {

// Farther than any lead and any error of a clock carries a satellite.
constexpr double kNear = 0.95;      // cosine of 18°
constexpr double kNearRise = 0.98;  // cosine of 11°
constexpr Angle kFarthestRise = 0.5_deg;
constexpr Angle kUsualRise = 0.15_deg;
constexpr std::chrono::minutes kAroundRise{1};
// Docked modules with elements of different days differ by this near the zenith.
constexpr Angle kTogether = 0.8_deg;
// Two satellites are together if they are at the same place at these times from now.
constexpr std::array kLater{std::chrono::minutes(0), std::chrono::minutes(2), std::chrono::minutes(4),
                            std::chrono::minutes(6), std::chrono::minutes(9), std::chrono::minutes(12)};

struct Candidate
{
    targets::Target target;
    UnitAt unitAt;
    double misfit = 0.0;
};

using Days = std::chrono::duration<double, std::chrono::days::period>;

bool isFresh(const orbit::ElementSet& set, const orbit::JulianDate& now, double oldestDays)
{
    return std::abs(orbit::minutesBetween(set.epoch, now)) <= oldestDays * orbit::kMinutesPerDay;
}

UnitAt pathOf(const orbit::Sgp4& orbit, const orbit::Observer& observer)
{
    return [orbit, observer](UtcTime utc) -> std::optional<orbit::Vector> {
        const orbit::JulianDate date = orbit::julianDate(utc);
        const orbit::OrbitResult state = orbit.propagate(date);
        return state ? std::optional(unitOf(observer.look(orbit::groundState(*state, date)).direction)) : std::nullopt;
    };
}

UnitAt pathOf(const targets::Target& target, const Site& site)
{
    return [path = std::make_shared<targets::TargetPath>(target, site)](UtcTime utc) -> std::optional<orbit::Vector> {
        const Result<SkyPointing> direction = path->at(utc);
        return direction ? std::optional(unitOf(*direction)) : std::nullopt;
    };
}

// What is asked of one path.
class Question
{
public:
    Question(const SentPoints& points, const Sky& sky)
        : m_points(points),
          m_sky(sky),
          m_observer(sky.site),
          m_rough(m_observer),
          m_now(points.back().utc),
          m_last(unitOf(points.back().direction)),
          m_waits(waitsAtHorizon(points))
    {}

    [[nodiscard]] std::vector<Candidate> satellites() const;
    [[nodiscard]] std::vector<Candidate> bodies() const;

private:
    // A quick look that leaves out nearly all satellites.
    [[nodiscard]] std::optional<UtcTime> worthwhile(const orbit::GroundState& state) const;
    [[nodiscard]] std::optional<double> misfitOf(const UnitAt& unitAt, UtcTime about) const;
    [[nodiscard]] std::optional<double> riseMisfit(const std::optional<Rise>& rise) const;
    [[nodiscard]] UtcTime latestRise() const { return m_now + targets::kLongestWait; }

    const SentPoints& m_points;
    const Sky& m_sky;
    orbit::Observer m_observer;
    RoughRise m_rough;
    UtcTime m_now;
    orbit::Vector m_last;
    bool m_waits;
};

std::optional<UtcTime> Question::worthwhile(const orbit::GroundState& state) const
{
    if (!m_waits) {
        const orbit::Vector unit = unitOf(m_observer.look(state).direction);
        return dot(unit, m_last) > kNear ? std::optional(m_now) : std::nullopt;
    }
    const auto rise = m_rough.of(state, m_now, latestRise() + kAroundRise);
    return rise && dot(rise->unit, m_last) > kNearRise ? std::optional(rise->utc) : std::nullopt;
}

std::optional<double> Question::riseMisfit(const std::optional<Rise>& rise) const
{
    const Angle off = rise ? angleBetween(rise->unit, m_last) : 180_deg;
    const bool fits = rise && rise->utc <= latestRise() && off <= kFarthestRise + 0.5 * stepOf(m_points);
    return fits ? std::optional(std::pow(off / (kUsualRise + 0.5 * stepOf(m_points)), 2)) : std::nullopt;
}

std::optional<double> Question::misfitOf(const UnitAt& unitAt, UtcTime about) const
{
    return m_waits ? riseMisfit(exactRise(unitAt, std::max(m_now, about - kAroundRise), about + kAroundRise))
                   : movingMisfit(m_points, unitAt);
}

std::vector<Candidate> Question::satellites() const
{
    const orbit::JulianDate now = orbit::julianDate(m_now);
    std::vector<Candidate> found;
    for (const orbit::ElementSet& set : *m_sky.satellites) {
        if (!isFresh(set, now, m_sky.oldestDays)) {
            continue;
        }
        const orbit::Sgp4 orbit(set);
        const orbit::OrbitResult state = orbit.propagate(now);
        const auto about = state ? worthwhile(orbit::groundState(*state, now)) : std::nullopt;
        if (!about) {
            continue;
        }
        UnitAt unitAt = pathOf(orbit, m_observer);
        if (const auto misfit = misfitOf(unitAt, *about)) {
            found.push_back({.target = targets::satelliteTarget(set), .unitAt = std::move(unitAt), .misfit = *misfit});
        }
    }
    return found;
}

std::vector<Candidate> Question::bodies() const
{
    std::vector<Candidate> found;
    for (const targets::Target& target : targets::objectTargets()) {
        UnitAt unitAt = pathOf(target, m_sky.site);
        const auto misfit =
            m_waits ? riseMisfit(exactRise(unitAt, m_now, latestRise())) : movingMisfit(m_points, unitAt);
        if (misfit) {
            found.push_back({.target = target, .unitAt = std::move(unitAt), .misfit = *misfit});
        }
    }
    return found;
}

bool isTogether(const UnitAt& one, const UnitAt& other, UtcTime now)
{
    return std::ranges::all_of(kLater, [&](std::chrono::minutes time) {
        const auto a = one(now + time);
        const auto b = other(now + time);
        return a && b && angleBetween(*a, *b) <= kTogether;
    });
}

// Of those at the same place: the one whose path is nearest to the points. Among equal ones the smallest number is the
// oldest: a station, and not a ship that is docked to it.
std::pair<double, std::int64_t> rankOf(const Candidate& candidate)
{
    constexpr double kAlike = 0.25;
    const auto* const set = std::get_if<orbit::ElementSet>(&candidate.target.kind);
    return {std::floor(candidate.misfit / kAlike), set ? set->number : 0};
}

}  // namespace

Recognition recognise(const SentPoints& points, const Sky& sky)
{
    if (points.empty() || (!waitsAtHorizon(points) && !showsMotion(points))) {
        return {};
    }
    const Question question(points, sky);
    std::vector<Candidate> all = question.satellites();
    std::ranges::move(question.bodies(), std::back_inserter(all));
    if (all.empty()) {
        return {};
    }
    const UtcTime now = points.back().utc;
    const double best = std::ranges::min(all, {}, &Candidate::misfit).misfit;
    std::erase_if(all, [best](const Candidate& one) { return one.misfit > best + kClearly; });
    std::ranges::sort(all, {}, &Candidate::misfit);
    // What is together with the best one counts as one of them.
    const UnitAt bestAt = all.front().unitAt;
    const auto apart =
        std::ranges::stable_partition(all, [&](const Candidate& one) { return isTogether(bestAt, one.unitAt, now); });
    std::ranges::sort(all.begin(), apart.begin(), {}, rankOf);
    Recognition found;
    found.fits.push_back(all.front().target);
    for (auto one = all.begin() + 1; one != apart.begin(); ++one) {
        found.together.push_back(one->target.name);
    }
    for (const Candidate& one : apart) {
        found.fits.push_back(one.target);
    }
    return found;
}

}  // namespace boresight::recognise
