// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

// One quantity over the last half hour, kept so that any part of it is drawn at once without losing a peak: least and
// greatest value of each bin of time, above that of each two bins, each four and so on (a min/max pyramid). Bins are
// counted by the owner; where no value came for more than kJoin bins there is a gap, and what lies on either side of
// it is never one line. Pure; 1.5 MB, allocated with the first value.
namespace boresight::ui {

struct PeakRange
{
    float min = 0.0F;
    float max = 0.0F;

    void include(const PeakRange& other);
    bool operator==(const PeakRange&) const = default;
};

// What one column of pixels shows. A column that holds a gap comes twice: what was before it, and what came after.
struct PeakColumn
{
    std::int64_t column = 0;
    PeakRange range;
    bool joined = false;  // to the column before

    bool operator==(const PeakColumn&) const = default;
};

// Columns of equal width, `bins` of time in `columns` pixels: a column is found at the same bins whatever part of the
// time is shown, so that a picture that moves on does not flicker.
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
    static constexpr std::int64_t kJoin = 5;                    // so many bins may stay empty within a line

    // Into this bin, or the newest one if that is later.
    void add(std::int64_t bin, float value);

    // Over the bins [first, end); empty if there is nothing.
    [[nodiscard]] std::optional<PeakRange> range(std::int64_t first, std::int64_t end) const;
    // The columns [first, end) that hold something, oldest first.
    [[nodiscard]] std::vector<PeakColumn> columns(const PeakGrid& grid, std::int64_t first, std::int64_t end) const;
    // The last value not later than `bin` and not across a gap from it.
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
    std::int64_t m_last = -1;  // of the newest; below m_first: nothing yet
};

}  // namespace boresight::ui
