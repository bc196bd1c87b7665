// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cross_check/ampere_link.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

constexpr Seconds kNotesKept{25.0};  // s: the longest latency and average that a profile allows, with some reserve
constexpr std::size_t kFewest = 15;  // for a sensor with one value per second
// A smaller difference between the lowest and the highest current does not disturb a compass.
constexpr double kLeastAmperes = 0.3;
constexpr int kFewestChanges = 3;        // between a low and a high current, in both directions
constexpr double kLeastExplained = 0.8;  // of the coefficient: this explains two thirds of the variance

SteadyTime later(SteadyTime time, Seconds by)
{
    return time + std::chrono::duration_cast<SteadyTime::duration>(by);
}

}  // namespace

void AmpereLink::note(SteadyTime now, double amperes)
{
    m_notes.push_back({now, amperes});
    while (now - m_notes.front().time > kNotesKept) {
        m_notes.pop_front();
    }
    while (!m_pairs.empty() && now - m_pairs.front().time > kSpan) {
        m_pairs.pop_front();
    }
}

void AmpereLink::take(SteadyTime middle, Seconds width, Angle difference)
{
    const auto first = std::ranges::lower_bound(m_notes, later(middle, -width / 2.0), {}, &Note::time);
    const auto last = std::ranges::upper_bound(m_notes, later(middle, width / 2.0), {}, &Note::time);
    if (first == last) {
        return;
    }
    double sum = 0.0;
    for (auto note = first; note != last; ++note) {
        sum += note->amperes;
    }
    m_pairs.push_back({middle, sum / static_cast<double>(last - first), difference.degrees()});
}

// How often the current changed between the lowest and the highest quarter of its range, in both directions.
int AmpereLink::changes(double low, double high) const
{
    const double quarter = (high - low) / 4.0;
    int changes = 0;
    std::optional<bool> isHigh;
    for (const Pair& pair : m_pairs) {
        const bool up = pair.amperes > high - quarter;
        if (up || pair.amperes < low + quarter) {
            changes += isHigh && *isHigh != up ? 1 : 0;
            isHigh = up;
        }
    }
    return changes;
}

std::optional<CurrentCorrelation> AmpereLink::correlation() const
{
    if (m_pairs.size() < kFewest) {
        return std::nullopt;
    }
    const auto [least, most] = std::ranges::minmax(m_pairs, {}, &Pair::amperes);
    if (most.amperes - least.amperes < kLeastAmperes || changes(least.amperes, most.amperes) < kFewestChanges) {
        return std::nullopt;
    }
    const double count = static_cast<double>(m_pairs.size());
    double meanAmperes = 0.0;
    double meanDegrees = 0.0;
    for (const Pair& pair : m_pairs) {
        meanAmperes += pair.amperes / count;
        meanDegrees += pair.degrees / count;
    }
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const Pair& pair : m_pairs) {
        const double x = pair.amperes - meanAmperes;
        const double y = pair.degrees - meanDegrees;
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    const double coefficient = yy > 0.0 ? xy / std::sqrt(xx * yy) : 0.0;
    return std::abs(coefficient) < kLeastExplained
               ? std::nullopt
               : std::optional(
                     CurrentCorrelation{.coefficient = coefficient, .perAmpere = Angle::fromDegrees(xy / xx)});
}

}  // namespace boresight
