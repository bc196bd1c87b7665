// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

// One quantity over the last half hour, stored so that any part of it can be drawn at once without losing a peak: the
// least and greatest value of each time bin, and above that of two bins, four bins and so on (a min/max pyramid). The
// owner numbers the bins. More than kJoin bins without a value are a gap, and a line never crosses a gap. Pure. 1.5 MB,
// allocated with the first value.
namespace boresight::ui {

struct PeakRange
{
    float min = 0.0F;
    float max = 0.0F;

    void include(const PeakRange& other);
    bool operator==(const PeakRange&) const = default;
};

// The contents of one column of pixels. A column with a gap in it comes twice: the part before the gap and the part
// after.
struct PeakColumn
{
    std::int64_t column = 0;
    PeakRange range;
    bool joined = false;  // connected to the column before

    bool operator==(const PeakColumn&) const = default;
};

// Columns of equal width, with `bins` of time in `columns` pixels. A column always begins at the same bins, whatever
// part of the time is shown, so that a moving picture does not flicker.
struct PeakGrid
{
    std::int64_t bins = 1;
    std::int64_t columns = 1;

    [[nodiscard]] std::int64_t firstBin(std::int64_t column) const;
    [[nodiscard]] std::int64_t columnOf(std::int64_t bin) const;
};

class PeakRing
{
public:
    static constexpr int kLevels = 13;
    static constexpr std::int64_t kBins = 23 << (kLevels - 1);  // 94,208: at 20 ms half an hour and 84 s to spare
    static constexpr std::int64_t kJoin = 5;                    // this many bins may be empty within a line

    // Adds to this bin, or to the newest one if that is later.
    void add(std::int64_t bin, float value);

    // The range over the bins [first, end). Empty if there is no value.
    [[nodiscard]] std::optional<PeakRange> range(std::int64_t first, std::int64_t end) const;
    // The non-empty columns of [first, end), oldest first.
    [[nodiscard]] std::vector<PeakColumn> columns(const PeakGrid& grid, std::int64_t first, std::int64_t end) const;
    // The last value at or before `bin`, if there is no gap in between.
    [[nodiscard]] std::optional<PeakRange> at(std::int64_t bin) const;

    [[nodiscard]] static std::size_t bytes();

private:
    struct Gap  // bins [first, end) without a value
    {
        std::int64_t first;
        std::int64_t end;
    };

    void begin(std::int64_t bin);
    void moveTo(std::int64_t bin);
    [[nodiscard]] PeakRange& node(int level, std::int64_t number);
    [[nodiscard]] const PeakRange& node(int level, std::int64_t number) const;
    [[nodiscard]] std::int64_t oldest() const;

    std::array<std::vector<PeakRange>, kLevels> m_levels;
    std::deque<Gap> m_gaps;
    std::int64_t m_first = 0;  // bin of the first value ever
    std::int64_t m_last = -1;  // bin of the newest value; below m_first: no value yet
};

}  // namespace boresight::ui
