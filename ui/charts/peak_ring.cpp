// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/peak_ring.h"

#include <algorithm>
#include <limits>

namespace boresight::ui {

namespace {

// An empty range: it contains nothing, and including it in another range changes nothing.
constexpr PeakRange kNothing{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};

bool holds(const PeakRange& range)
{
    return range.min <= range.max;
}

// Rounds down, also for negative numbers.
std::int64_t floorOf(std::int64_t dividend, std::int64_t divisor)
{
    const std::int64_t quotient = dividend / divisor;
    return dividend % divisor < 0 ? quotient - 1 : quotient;
}

}  // namespace

void PeakRange::include(const PeakRange& other)
{
    min = std::min(min, other.min);
    max = std::max(max, other.max);
}

std::int64_t PeakGrid::firstBin(std::int64_t column) const
{
    return floorOf(column * bins, columns);
}

// The last column that begins at this bin or earlier.
std::int64_t PeakGrid::columnOf(std::int64_t bin) const
{
    return floorOf((bin + 1) * columns - 1, bins);
}

std::size_t PeakRing::bytes()
{
    std::size_t nodes = 0;
    for (int level = 0; level < kLevels; ++level) {
        nodes += static_cast<std::size_t>(kBins >> level);
    }
    return nodes * sizeof(PeakRange);
}

PeakRange& PeakRing::node(int level, std::int64_t number)
{
    return m_levels[static_cast<std::size_t>(level)][static_cast<std::size_t>(number % (kBins >> level))];
}

const PeakRange& PeakRing::node(int level, std::int64_t number) const
{
    return m_levels[static_cast<std::size_t>(level)][static_cast<std::size_t>(number % (kBins >> level))];
}

std::int64_t PeakRing::oldest() const
{
    return std::max(m_first, m_last - kBins + 1);
}

void PeakRing::begin(std::int64_t bin)
{
    for (int level = 0; level < kLevels; ++level) {
        m_levels[static_cast<std::size_t>(level)].assign(static_cast<std::size_t>(kBins >> level), kNothing);
    }
    m_first = bin;
    m_last = bin;
}

// Clears the nodes that are entered, because they still hold the values of the last round of the ring.
void PeakRing::moveTo(std::int64_t bin)
{
    for (int level = 0; level < kLevels; ++level) {
        const std::int64_t entered = bin >> level;
        if (entered == m_last >> level) {
            break;  // a wider node is not entered either
        }
        const std::int64_t round = kBins >> level;
        for (std::int64_t number = std::max((m_last >> level) + 1, entered - round + 1); number <= entered; ++number) {
            node(level, number) = kNothing;
        }
    }
    if (bin - m_last > kJoin + 1) {
        m_gaps.push_back({m_last + 1, bin});
    }
    m_last = bin;
    while (!m_gaps.empty() && m_gaps.front().end <= oldest()) {
        m_gaps.pop_front();
    }
}

void PeakRing::add(std::int64_t bin, float value)
{
    if (m_last < m_first) {
        begin(bin);
    }
    if (bin > m_last) {
        moveTo(bin);
    }
    for (int level = 0; level < kLevels; ++level) {
        PeakRange& range = node(level, m_last >> level);
        if (range.min <= value && value <= range.max) {
            break;  // the wider nodes contain it, too
        }
        range.include({value, value});
    }
}

// From left to right, using the widest nodes that lie within the range.
std::optional<PeakRange> PeakRing::range(std::int64_t first, std::int64_t end) const
{
    PeakRange sum = kNothing;
    std::int64_t bin = std::max(first, oldest());
    const std::int64_t stop = std::min(end, m_last + 1);
    while (bin < stop) {
        int level = 0;
        while (level + 1 < kLevels && bin % (std::int64_t{2} << level) == 0 &&
               bin + (std::int64_t{2} << level) <= stop) {
            ++level;
        }
        sum.include(node(level, bin >> level));
        bin += std::int64_t{1} << level;
    }
    return holds(sum) ? std::optional(sum) : std::nullopt;
}

std::vector<PeakColumn> PeakRing::columns(const PeakGrid& grid, std::int64_t first, std::int64_t end) const
{
    std::vector<PeakColumn> found;
    const std::int64_t firstBin = std::max(grid.firstBin(first), oldest());
    const std::int64_t endBin = std::min(grid.firstBin(end), m_last + 1);
    auto gap = m_gaps.begin();
    bool joined = false;
    for (std::int64_t bin = firstBin; bin < endBin;) {
        while (gap != m_gaps.end() && gap->end <= bin) {
            ++gap;
        }
        if (gap != m_gaps.end() && gap->first <= bin) {
            bin = gap->end;
            joined = false;
            continue;
        }
        const std::int64_t column = grid.columnOf(bin);
        const std::int64_t runEnd = gap != m_gaps.end() ? std::min(gap->first, endBin) : endBin;
        const std::int64_t next = std::min(grid.firstBin(column + 1), runEnd);
        if (const auto values = range(bin, next)) {
            found.push_back({.column = column, .range = *values, .joined = joined});
            joined = true;
        }
        bin = next;
    }
    return found;
}

std::optional<PeakRange> PeakRing::at(std::int64_t bin) const
{
    for (std::int64_t back = 0; back <= kJoin; ++back) {
        if (const auto value = range(bin - back, bin - back + 1)) {
            return value;
        }
    }
    return std::nullopt;
}

}  // namespace boresight::ui
