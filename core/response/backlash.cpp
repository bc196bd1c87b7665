// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/response/backlash.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace boresight::response {
namespace {

constexpr std::size_t kShortestLeg = 40;  // samples
constexpr std::size_t kShortestGap = 3;
constexpr std::size_t kFewestReversals = 4;
// In squares of the noise of one sample. A step of torque counts from this on. Chance reaches half of it.
constexpr double kClearStep = 25.0;
constexpr double kLeastStep = 0.08;  // as a share of the torque with the load
// As a share of the leg. The gap must end well before the leg, otherwise its end is not seen.
constexpr double kLargestPart = 0.7;
constexpr std::ptrdiff_t kAveraged = 2;  // samples on each side, to average the steps of the encoder

// Samples in one direction: from `first` to before `last`.
struct Leg
{
    std::size_t first = 0;
    std::size_t last = 0;
    double way = 1.0;
};

std::vector<Leg> legsOf(Samples samples)
{
    std::vector<Leg> legs;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const Angle moved = samples[i].wanted - samples[i - 1].wanted;
        if (moved == Angle{}) {
            continue;
        }
        const double way = moved < Angle{} ? -1.0 : 1.0;
        if (legs.empty() || legs.back().way != way) {
            legs.push_back({.first = i, .last = i, .way = way});
        }
        legs.back().last = i + 1;
    }
    std::erase_if(legs, [](const Leg& leg) { return leg.last - leg.first < kShortestLeg; });
    return legs;
}

struct Level
{
    double mean = 0.0;
    double spread = 0.0;
};

// The torque along the direction of the leg in its second half, where the load moves with the axis.
Level loadedLevel(Samples samples, const Leg& leg)
{
    const Samples half = samples.subspan((leg.first + leg.last) / 2, leg.last - (leg.first + leg.last) / 2);
    double sum = 0.0;
    double squares = 0.0;
    for (const Sample& one : half) {
        sum += leg.way * *one.torque;
        squares += *one.torque * *one.torque;
    }
    const auto count = static_cast<double>(half.size());
    const double mean = sum / count;
    return {.mean = mean, .spread = std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

// Sums over a series of torques, to compute how well a level describes a part of it.
class Sums
{
public:
    explicit Sums(const std::vector<double>& values) : m_sums{0.0}, m_squares{0.0}
    {
        for (const double value : values) {
            m_sums.push_back(m_sums.back() + value);
            m_squares.push_back(m_squares.back() + value * value);
        }
    }

    [[nodiscard]] double mean(std::size_t from, std::size_t to) const
    {
        return (m_sums[to] - m_sums[from]) / static_cast<double>(to - from);
    }
    // The sum of the squared differences from the level.
    [[nodiscard]] double rest(std::size_t from, std::size_t to, double level) const
    {
        return m_squares[to] - m_squares[from] - 2.0 * level * (m_sums[to] - m_sums[from]) +
               level * level * static_cast<double>(to - from);
    }

private:
    std::vector<double> m_sums;
    std::vector<double> m_squares;
};

struct Steps  // steps of the torque after a reversal
{
    std::size_t begin = 0;  // where the motor loses the load
    std::size_t end = 0;    // where it meets the load on the other side
    double level = 0.0;     // between them
    double gain = 0.0;      // how much better than a single step, in squares of the noise
};

// Finds the two steps that fit best: the load before the reversal, a level between them, and the load after it.
Steps stepsIn(const std::vector<double>& torques, const Level& before, const Level& after)
{
    const Sums sums(torques);
    const std::size_t count = torques.size();
    double single = std::numeric_limits<double>::infinity();
    double best = single;
    Steps steps;
    for (std::size_t begin = 1; begin + kShortestGap < count; ++begin) {
        const double first = sums.rest(0, begin, before.mean);
        single = std::min(single, first + sums.rest(begin, count, after.mean));
        for (std::size_t end = begin + kShortestGap; end < count; ++end) {
            const double level = sums.mean(begin, end);
            const double left = first + sums.rest(begin, end, level) + sums.rest(end, count, after.mean);
            if (left < best && std::abs(level) < after.mean) {
                best = left;
                steps = {.begin = begin, .end = end, .level = level};
            }
        }
    }
    const double noise = std::max(after.spread * after.spread, 1e-12);
    steps.gain = (single - best) / noise;
    return steps;
}

Angle placeAround(Samples samples, std::size_t middle)
{
    Angle sum;
    for (std::ptrdiff_t off = -kAveraged; off <= kAveraged; ++off) {
        sum += samples[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(middle) + off)].actual;
    }
    return sum / static_cast<double>(2 * kAveraged + 1);
}

struct Reversal
{
    Angle gap;
    double freeTorque = 0.0;
    double loadTorque = 0.0;
    bool shown = false;
    bool longer = false;  // the gap is longer than the leg
};

// `sense`: the sign of the reported torque, -1 if it counts against the angle.
Reversal reversalOf(Samples samples, const Leg& before, const Leg& after, double sense)
{
    Level was = loadedLevel(samples, before);
    was.mean *= -sense;
    Level load = loadedLevel(samples, after);
    load.mean *= sense;
    const std::size_t from = (before.first + before.last) / 2;
    std::vector<double> torques;
    for (std::size_t i = from; i < after.last; ++i) {
        torques.push_back(sense * after.way * *samples[i].torque);
    }
    const Steps steps = stepsIn(torques, was, load);
    if (steps.gain < kClearStep || load.mean - steps.level < kLeastStep * load.mean || from + steps.begin < 4 ||
        from + steps.end + 4 >= samples.size()) {
        return {.loadTorque = load.mean};
    }
    const Angle gap = after.way * (placeAround(samples, from + steps.end) - placeAround(samples, from + steps.begin));
    const double part = (static_cast<double>(from + steps.end) - static_cast<double>(after.first)) /
                        static_cast<double>(after.last - after.first);
    return {.gap = gap,
            .freeTorque = steps.level,
            .loadTorque = load.mean,
            .shown = part <= kLargestPart && gap > Angle{},
            .longer = part > kLargestPart};
}

// `pitch`: the way from one sample to the next, which makes both ends of every gap equally uncertain.
BacklashFigures meanOf(const std::vector<Reversal>& shown, std::size_t tried, Angle pitch)
{
    const auto count = static_cast<double>(shown.size());
    BacklashFigures figures{.reversals = static_cast<int>(shown.size()), .tried = static_cast<int>(tried)};
    for (const Reversal& one : shown) {
        figures.gap += one.gap / count;
        figures.freeTorque += one.freeTorque / count;
        figures.loadTorque += one.loadTorque / count;
    }
    double squares = 0.0;
    for (const Reversal& one : shown) {
        const double off = (one.gap - figures.gap).radians();
        squares += off * off;
    }
    figures.uncertainty =
        Angle::fromRadians(2.0 * std::hypot(std::sqrt(squares / (count - 1.0) / count), pitch.radians()));
    return figures;
}

}  // namespace

Result<BacklashFigures> backlashFigures(Samples samples)
{
    const auto silent = [](const Sample& one) { return !one.torque.has_value(); };
    if (std::ranges::any_of(samples, silent)) {
        return failure(ErrorCode::NotAvailable, Text::tr("The drive reported no torque, so there is no result."));
    }
    const std::vector<Leg> legs = legsOf(samples);
    if (legs.size() <= kFewestReversals) {
        return failure(ErrorCode::Refused, Text::tr("The axis reversed too few times, so there is no result."));
    }
    const auto loaded = [&](double sum, const Leg& leg) { return sum + loadedLevel(samples, leg).mean; };
    const double sense = std::accumulate(legs.begin(), legs.end(), 0.0, loaded) < 0.0 ? -1.0 : 1.0;
    std::vector<Reversal> shown;
    std::size_t longer = 0;
    for (std::size_t i = 1; i < legs.size(); ++i) {
        const Reversal one = reversalOf(samples, legs[i - 1], legs[i], sense);
        longer += one.longer ? 1 : 0;
        if (one.shown) {
            shown.push_back(one);
        }
    }
    const std::size_t tried = legs.size() - 1;
    if (2 * longer > tried) {
        return failure(ErrorCode::Refused,
                       Text::tr("The backlash is larger than the movement of the run, so there is no result."));
    }
    if (shown.size() < kFewestReversals || 2 * shown.size() < tried) {
        return failure(ErrorCode::Refused,
                       Text::tr("The torque shows no gap when the axis reverses, so there is no result. The backlash "
                                "may be too small for the encoder. Weight or wind may keep the gear on one side."));
    }
    const Leg& leg = legs.front();
    const Angle way = samples[leg.last - 1].wanted - samples[leg.first].wanted;
    return meanOf(shown, tried, abs(way) / static_cast<double>(leg.last - leg.first));
}

}  // namespace boresight::response
