// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognise/recognise.h"

#include "core/ephemeris/sky_object.h"
#include "core/orbit/sgp4.h"
#include "core/recognise/rise_search.h"
#include "core/targets/target_path.h"
#include "core/targets/track_rules.h"

#include <algorithm>
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
// Two satellites are together if they are no farther apart than this through the visible pass. Docked modules have
// nearly equal elements. At the horizon this is 4 km.
constexpr Angle kTogether = 0.1_deg;
constexpr std::chrono::seconds kPassStep{30};
// Of a satellite that is up for hours, the first two hours decide.
constexpr std::size_t kMostMoments = 240;

struct Fit
{
    double misfit = 0.0;
    Angle lead = {};
    UtcTime from;  // now, or the rise
};

struct Candidate
{
    targets::Target target;
    UnitAt unitAt;
    Fit fit;
};

struct Moment
{
    UtcTime utc;
    orbit::Vector unit;
};

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
    [[nodiscard]] std::optional<Fit> moving(const UnitAt& unitAt) const;
    [[nodiscard]] std::optional<Fit> rising(const UnitAt& unitAt, UtcTime from, UtcTime until) const;
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

std::optional<Fit> Question::moving(const UnitAt& unitAt) const
{
    const auto fit = movingFit(m_points, unitAt);
    return fit ? std::optional(Fit{.misfit = fit->misfit, .lead = fit->lead, .from = m_now}) : std::nullopt;
}

std::optional<Fit> Question::rising(const UnitAt& unitAt, UtcTime from, UtcTime until) const
{
    const auto rise = exactRise(unitAt, from, until);
    const Angle off = rise ? angleBetween(rise->unit, m_last) : 180_deg;
    if (!rise || rise->utc > latestRise() || off > kFarthestRise + 0.5 * stepOf(m_points)) {
        return std::nullopt;
    }
    return Fit{.misfit = std::pow(off / (kUsualRise + 0.5 * stepOf(m_points)), 2), .from = rise->utc};
}

std::vector<Candidate> Question::satellites() const
{
    const orbit::JulianDate now = orbit::julianDate(m_now);
    std::vector<Candidate> found;
    for (const orbit::ElementSet& set : *m_sky.satellites) {
        if (!targets::isFresh(set, m_now, m_sky.oldestDays)) {
            continue;
        }
        const orbit::Sgp4 orbit(set);
        const orbit::OrbitResult state = orbit.propagate(now);
        const auto about = state ? worthwhile(orbit::groundState(*state, now)) : std::nullopt;
        if (!about) {
            continue;
        }
        UnitAt unitAt = pathOf(orbit, m_observer);
        const auto fit =
            m_waits ? rising(unitAt, std::max(m_now, *about - kAroundRise), *about + kAroundRise) : moving(unitAt);
        if (fit) {
            found.push_back({.target = targets::satelliteTarget(set), .unitAt = std::move(unitAt), .fit = *fit});
        }
    }
    return found;
}

std::vector<Candidate> Question::bodies() const
{
    std::vector<Candidate> found;
    for (const targets::Target& target : targets::objectTargets()) {
        UnitAt unitAt = pathOf(target, m_sky.site);
        if (const auto fit = m_waits ? rising(unitAt, m_now, latestRise()) : moving(unitAt)) {
            found.push_back({.target = target, .unitAt = std::move(unitAt), .fit = *fit});
        }
    }
    return found;
}

// From the rise, or from now, to the set.
std::vector<Moment> visiblePass(const Candidate& one)
{
    std::vector<Moment> pass;
    for (UtcTime utc = one.fit.from; pass.size() < kMostMoments; utc += kPassStep) {
        const auto unit = one.unitAt(utc);
        if (!unit || (!pass.empty() && unit->z < 0.0)) {
            break;
        }
        pass.push_back({.utc = utc, .unit = *unit});
    }
    return pass;
}

bool isTogether(const std::vector<Moment>& pass, const UnitAt& other)
{
    return std::ranges::all_of(pass, [&](const Moment& moment) {
        const auto unit = other(moment.utc);
        return unit && angleBetween(moment.unit, *unit) <= kTogether;
    });
}

// The smallest number is the oldest: a station, and not a ship that is docked to it.
std::int64_t numberOf(const Candidate& candidate)
{
    const auto* const set = std::get_if<orbit::ElementSet>(&candidate.target.kind);
    return set ? set->number : 0;
}

double misfitOf(const Candidate& candidate)
{
    return candidate.fit.misfit;
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
    const double best = misfitOf(std::ranges::min(all, {}, misfitOf));
    std::erase_if(all, [best](const Candidate& one) { return misfitOf(one) > best + kClearly; });
    std::ranges::sort(all, {}, misfitOf);
    // What is together with the best one counts as one of them.
    const std::vector<Moment> pass = visiblePass(all.front());
    const auto apart =
        std::ranges::stable_partition(all, [&](const Candidate& one) { return isTogether(pass, one.unitAt); });
    std::ranges::sort(all.begin(), apart.begin(), {}, numberOf);
    Recognition found{.isMoving = !waitsAtHorizon(points), .lead = all.front().fit.lead};
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
