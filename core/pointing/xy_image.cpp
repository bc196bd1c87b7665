// SPDX-License-Identifier: GPL-3.0-or-later
// X and Y are divided into small cells. A cell of which any part is forbidden is forbidden. Large cells that are
// entirely free or entirely forbidden are not divided. Then rows of cells that hardly differ are joined, and each run
// of forbidden cells in a row becomes a box. A box is as high as the shape allows, so that boxes overlap and leave no
// slit.
#include "core/pointing/xy_image.h"

#include "core/pointing/ranges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace boresight::pointing {

namespace {

constexpr Angle kCell = Angle::fromDegrees(0.5);
// Rows are joined if they are together no higher than this, or if that forbids no more than this beside an edge,
// measured on the sky.
constexpr Angle kJoined = Angle::fromDegrees(1.0);

// What a part of the sky has in common with the forbidden places.
enum class Cover
{
    None,
    Part,
    Whole
};

// All products of one number of each range.
std::pair<double, double> product(const std::pair<double, double>& a, const std::pair<double, double>& b)
{
    return std::minmax({a.first * b.first, a.first * b.second, a.second * b.first, a.second * b.second});
}

// The cosine or the sine of all angles of a range.
std::pair<double, double> cosines(const TravelRange& range)
{
    const auto [least, most] = std::minmax({std::cos(range.min.radians()), std::cos(range.max.radians())});
    const bool hasTop = std::floor(range.max / kFullTurn) >= std::ceil(range.min / kFullTurn);
    const bool hasBottom =
        std::floor((range.max - 180_deg) / kFullTurn) >= std::ceil((range.min - 180_deg) / kFullTurn);
    return {hasBottom ? -1.0 : least, hasTop ? 1.0 : most};
}

std::pair<double, double> sines(const TravelRange& range)
{
    return cosines({.min = range.min - 90_deg, .max = range.max - 90_deg});
}

Angle arcSine(double sine)
{
    return Angle::fromRadians(std::asin(std::clamp(sine, -1.0, 1.0)));
}

// A range of true azimuths and elevations that contains the directions of all X and Y of a box.
AxisBox skyOf(const AxisBox& cell, Angle xAxis)
{
    const std::pair<double, double> level = cosines(cell.elevation);
    const auto [lowest, highest] = product(level, cosines(cell.azimuth));
    const std::pair<double, double> across = product(level, sines(cell.azimuth));
    const std::pair<double, double> along = sines(cell.elevation);
    AxisBox sky{.azimuth = {0_deg, kFullTurn}, .elevation = {arcSine(lowest), arcSine(highest)}};
    const bool hasPole = across.first <= 0.0 && across.second >= 0.0 && along.first <= 0.0 && along.second >= 0.0;
    if (!hasPole) {
        const Angle middle =
            Angle::fromRadians(std::atan2(0.5 * (across.first + across.second), 0.5 * (along.first + along.second)));
        sky.azimuth = {middle, middle};
        for (const double right : {across.first, across.second}) {
            for (const double ahead : {along.first, along.second}) {
                const Angle corner = Angle::fromRadians(std::atan2(right, ahead)).nearestTo(middle);
                sky.azimuth = {std::min(sky.azimuth.min, corner), std::max(sky.azimuth.max, corner)};
            }
        }
        sky.azimuth = {sky.azimuth.min + xAxis, sky.azimuth.max + xAxis};
    }
    return sky;
}

Cover coverOf(const KeepOut& keepOut, const AxisBox& sky)
{
    const bool allRound = abs(keepOut.azimuthTo - keepOut.azimuthFrom) >= kFullTurn - kRounding;
    const Angle width = allRound ? kFullTurn : (keepOut.azimuthTo - keepOut.azimuthFrom).wrapped360();
    const Angle from = keepOut.azimuthFrom;
    if (sky.elevation.max <= keepOut.elevationMin || sky.elevation.min >= keepOut.elevationMax) {
        return Cover::None;
    }
    const double next = std::ceil((sky.azimuth.min - from - width + kRounding) / kFullTurn);
    if (from + next * kFullTurn >= sky.azimuth.max - kRounding) {
        return Cover::None;
    }
    const double last = std::floor((sky.azimuth.min - from) / kFullTurn);
    const bool isInside = sky.elevation.min >= keepOut.elevationMin && sky.elevation.max <= keepOut.elevationMax;
    const bool isBetween = allRound || from + last * kFullTurn + width >= sky.azimuth.max;
    return isInside && isBetween ? Cover::Whole : Cover::Part;
}

// The line through the points of a horizon with all elevations negated, to find its lowest places.
Skyline negated(const Skyline& horizon)
{
    std::vector<HorizonPoint> points;
    for (std::size_t i = 0; i < horizon.lineCount(); ++i) {
        const HorizonPoint point = horizon.line(i).from;
        points.push_back({.azimuth = point.azimuth, .elevation = -point.elevation});
    }
    return Skyline(points);
}

// Cells of X and Y. A row is a range of Y.
class Raster
{
public:
    Raster(const AxisBox& ranges, Angle xAxis)
        : m_ranges(ranges),
          m_xAxis(xAxis),
          m_columns(cellsOf(ranges.azimuth)),
          m_rows(cellsOf(ranges.elevation)),
          m_forbidden(m_columns * m_rows, 0)
    {}

    // `coverOfSky` returns the Cover of a range of true azimuths and elevations.
    template <class CoverOfSky>
    void forbid(const CoverOfSky& coverOfSky)
    {
        divide({0, m_columns, 0, m_rows}, coverOfSky);
    }

    [[nodiscard]] std::vector<AxisBox> boxes() const
    {
        const std::vector<Row> rows = joinedRows();
        std::vector<AxisBox> list;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            for (const TravelRange& run : rows[i].runs) {
                std::size_t first = i;
                std::size_t last = i;
                while (first > 0 && contains(rows[first - 1], run)) {
                    --first;
                }
                while (last + 1 < rows.size() && contains(rows[last + 1], run)) {
                    ++last;
                }
                const AxisBox box{.azimuth = run, .elevation = {rows[first].y.min, rows[last].y.max}};
                if (std::ranges::find(list, box) == list.end()) {
                    list.push_back(box);
                }
            }
        }
        return list;
    }

private:
    // Of cells: from the first to before the last.
    struct Part
    {
        std::size_t left;
        std::size_t right;
        std::size_t bottom;
        std::size_t top;
    };
    struct Row
    {
        TravelRange y;
        std::vector<TravelRange> runs;    // of forbidden X
        std::vector<TravelRange> common;  // of all rows that were joined
    };

    static std::size_t cellsOf(const TravelRange& range)
    {
        return range.max > range.min ? static_cast<std::size_t>(std::ceil((range.max - range.min) / kCell)) : 0;
    }
    static Angle edge(const TravelRange& range, std::size_t index, std::size_t count)
    {
        return range.min + (range.max - range.min) * (static_cast<double>(index) / static_cast<double>(count));
    }
    [[nodiscard]] Angle x(std::size_t column) const { return edge(m_ranges.azimuth, column, m_columns); }
    [[nodiscard]] Angle y(std::size_t row) const { return edge(m_ranges.elevation, row, m_rows); }

    template <class CoverOfSky>
    void divide(const Part& part, const CoverOfSky& coverOfSky)
    {
        const std::size_t width = part.right - part.left;
        const std::size_t height = part.top - part.bottom;
        if (width == 0 || height == 0) {
            return;
        }
        const AxisBox cell{.azimuth = {x(part.left), x(part.right)}, .elevation = {y(part.bottom), y(part.top)}};
        const Cover cover = coverOfSky(skyOf(cell, m_xAxis));
        if (cover == Cover::None) {
            return;
        }
        if (cover == Cover::Whole || (width == 1 && height == 1)) {
            for (std::size_t row = part.bottom; row < part.top; ++row) {
                const auto begin = m_forbidden.begin() + static_cast<std::ptrdiff_t>(row * m_columns + part.left);
                std::fill_n(begin, width, char{1});
            }
            return;
        }
        if (width >= height) {
            const std::size_t middle = part.left + width / 2;
            divide({part.left, middle, part.bottom, part.top}, coverOfSky);
            divide({middle, part.right, part.bottom, part.top}, coverOfSky);
        } else {
            const std::size_t middle = part.bottom + height / 2;
            divide({part.left, part.right, part.bottom, middle}, coverOfSky);
            divide({part.left, part.right, middle, part.top}, coverOfSky);
        }
    }

    [[nodiscard]] std::vector<TravelRange> runsOf(std::size_t row) const
    {
        std::vector<TravelRange> runs;
        for (std::size_t column = 0; column < m_columns; ++column) {
            if (m_forbidden[row * m_columns + column] == 0) {
                continue;
            }
            if (!runs.empty() && runs.back().max == x(column)) {
                runs.back().max = x(column + 1);
            } else {
                runs.push_back({x(column), x(column + 1)});
            }
        }
        return runs;
    }

    // All runs of both, where runs that touch become one.
    [[nodiscard]] static std::vector<TravelRange> together(std::vector<TravelRange> runs,
                                                           const std::vector<TravelRange>& more)
    {
        runs.insert(runs.end(), more.begin(), more.end());
        std::ranges::sort(runs, {}, [](const TravelRange& run) { return run.min; });
        std::vector<TravelRange> all;
        for (const TravelRange& run : runs) {
            if (!all.empty() && run.min <= all.back().max) {
                all.back().max = std::max(all.back().max, run.max);
            } else {
                all.push_back(run);
            }
        }
        return all;
    }

    // The row with this one added. Empty if they differ by too much.
    [[nodiscard]] static std::optional<Row> joined(const Row& row, const std::vector<TravelRange>& runs, Angle top)
    {
        Row wider = row;
        wider.y.max = top;
        if (wider.y.max - wider.y.min <= kJoined + kRounding) {
            wider.runs = together(row.runs, runs);
            wider.common = wider.runs;
            return wider;
        }
        if (row.runs.size() != runs.size()) {
            return std::nullopt;
        }
        const double width = cosines(wider.y).second;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            TravelRange& outer = wider.runs[i];
            TravelRange& inner = wider.common[i];
            outer = {std::min(outer.min, runs[i].min), std::max(outer.max, runs[i].max)};
            inner = common(inner, runs[i]);
            if (width * std::max(inner.min - outer.min, outer.max - inner.max) > kJoined) {
                return std::nullopt;
            }
        }
        return wider;
    }

    [[nodiscard]] std::vector<Row> joinedRows() const
    {
        std::vector<Row> rows;
        for (std::size_t i = 0; i < m_rows; ++i) {
            const std::vector<TravelRange> runs = runsOf(i);
            const auto wider = rows.empty() ? std::nullopt : joined(rows.back(), runs, y(i + 1));
            if (wider) {
                rows.back() = *wider;
            } else {
                rows.push_back({.y = {y(i), y(i + 1)}, .runs = runs, .common = runs});
            }
        }
        return rows;
    }

    [[nodiscard]] static bool contains(const Row& row, const TravelRange& run)
    {
        return std::ranges::any_of(row.runs,
                                   [&](const TravelRange& one) { return one.min <= run.min && one.max >= run.max; });
    }

    AxisBox m_ranges;
    Angle m_xAxis;
    std::size_t m_columns;
    std::size_t m_rows;
    std::vector<char> m_forbidden;
};

}  // namespace

XYImage::XYImage(const AxisBox& ranges, Angle xAxis)
    : m_ranges{.azimuth = common(ranges.azimuth, {-180_deg, 180_deg}),
               .elevation = common(ranges.elevation, {-90_deg, 90_deg})},
      m_xAxis(xAxis)
{}

std::vector<AxisBox> XYImage::of(const Skyline& horizon) const
{
    if (horizon.empty()) {
        return {};
    }
    const Skyline depth = negated(horizon);
    Raster raster(m_ranges, m_xAxis);
    raster.forbid([&](const AxisBox& sky) {
        if (horizon.highest(sky.azimuth.min, sky.azimuth.max) <= sky.elevation.min) {
            return Cover::None;
        }
        return -depth.highest(sky.azimuth.min, sky.azimuth.max) >= sky.elevation.max ? Cover::Whole : Cover::Part;
    });
    return raster.boxes();
}

std::vector<AxisBox> XYImage::of(const std::vector<KeepOut>& keepOuts) const
{
    Raster raster(m_ranges, m_xAxis);
    raster.forbid([&](const AxisBox& sky) {
        Cover most = Cover::None;
        for (const KeepOut& keepOut : keepOuts) {
            most = std::max(most, coverOf(keepOut, sky));
        }
        return most;
    });
    return raster.boxes();
}

}  // namespace boresight::pointing
