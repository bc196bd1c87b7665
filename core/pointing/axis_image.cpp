// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/axis_image.h"

#include "core/pointing/ranges.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace boresight::pointing {

namespace {

constexpr std::array kSides{Side::Upright, Side::OverTheTop};

// A side edge is sampled at this many places, an upper or lower edge at this distance. Between two samples the error is
// below 0.01°. The margin is larger.
constexpr int kSamples = 32;
constexpr Angle kApart = Angle::fromDegrees(3.5);
constexpr Angle kMargin = Angle::fromDegrees(0.02);
constexpr Angle kDeep = Angle::fromDegrees(-45.0);
// A keep-out is enclosed in few boxes, because every route considers the corners of each box. The boxes extend beyond
// the keep-out by about twice the skew. The limits are the width of an arc and the rise of the tangent of the
// elevation.
constexpr Angle kWidest = Angle::fromRadians(2.0);
constexpr double kHighest = 2.0;
// A line of the horizon is divided until each part is this straight, and no part is longer than kLongest.
constexpr Angle kStraight = Angle::fromDegrees(0.01);
constexpr Angle kLongest = Angle::fromDegrees(5.0);
constexpr int kDeepest = 12;

void include(TravelRange& range, Angle angle)
{
    range = {.min = std::min(range.min, angle), .max = std::max(range.max, angle)};
}

void include(AxisBox& box, const AxisPosition& place)
{
    include(box.azimuth, place.azimuth);
    include(box.elevation, place.elevation);
}

Angle part(const TravelRange& range, int index, int count)
{
    return range.min + (range.max - range.min) * (double(index) / count);
}

// The highest elevation at each azimuth, for a line that may run back over itself. Between its points a line is
// straight. So a part that is the highest at both ends of an interval is the highest in the whole interval.
class Envelope
{
public:
    explicit Envelope(const std::vector<HorizonPoint>& line) : m_line(line)
    {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const bool forward = line[i].azimuth >= line[i - 1].azimuth;
            m_parts.push_back(forward ? Part{line[i - 1], line[i]} : Part{line[i], line[i - 1]});
            m_widest = std::max(m_widest, m_parts.back().to.azimuth - m_parts.back().from.azimuth);
        }
        std::ranges::sort(m_parts, {}, [](const Part& one) { return one.from.azimuth; });
    }

    [[nodiscard]] std::vector<HorizonPoint> highest() const
    {
        std::vector<HorizonPoint> envelope;
        for (const HorizonPoint& point : m_line) {
            HorizonPoint top = point;
            for (const Angle turn : {-kFullTurn, Angle{}, kFullTurn}) {
                raise(top, point.azimuth + turn);
            }
            envelope.push_back(top);
        }
        return envelope;
    }

private:
    struct Part
    {
        HorizonPoint from;
        HorizonPoint to;
    };

    void raise(HorizonPoint& top, Angle azimuth) const
    {
        const auto azimuthOf = [](const Part& one) { return one.from.azimuth; };
        auto part = std::ranges::lower_bound(m_parts, azimuth - m_widest, {}, azimuthOf);
        for (; part != m_parts.end() && part->from.azimuth <= azimuth; ++part) {
            const auto& [from, to] = *part;
            if (to.azimuth < azimuth) {
                continue;
            }
            const Angle width = to.azimuth - from.azimuth;
            const Angle there =
                width > Angle{} ? from.elevation + (to.elevation - from.elevation) * ((azimuth - from.azimuth) / width)
                                : std::max(from.elevation, to.elevation);
            top.elevation = std::max(top.elevation, there);
        }
    }

    const std::vector<HorizonPoint>& m_line;
    std::vector<Part> m_parts;
    Angle m_widest;
};

}  // namespace

// At twice this distance from the zenith, moving the beam by the skew turns its azimuth by at most 30°.
AxisImage::AxisImage(const PointingModel& model)
    : m_model(model),
      m_skew(model.skew()),
      m_tame(model.isSkewed() ? TravelRange{-89_deg + 2.0 * m_skew, 89_deg - 2.0 * m_skew}
                              : TravelRange{-90_deg, 90_deg})
{}

AxisPosition AxisImage::place(const SkyPointing& beam, Side side) const
{
    return m_model.toAxes(side == Side::Upright ? beam : SkyPointing{beam.azimuth + 180_deg, 180_deg - beam.elevation})
        .axes;
}

std::vector<AxisBox> AxisImage::of(const KeepOut& keepOut) const
{
    const bool allRound = abs(keepOut.azimuthTo - keepOut.azimuthFrom) >= kFullTurn - kRounding;
    const Angle width = allRound ? kFullTurn : (keepOut.azimuthTo - keepOut.azimuthFrom).wrapped360();
    const TravelRange azimuths{keepOut.azimuthFrom, keepOut.azimuthFrom + width};
    const TravelRange elevations{keepOut.elevationMin, std::min(keepOut.elevationMax, 90_deg)};
    return m_model.isSkewed() ? enclosed(azimuths, elevations) : shifted(azimuths, elevations);
}

// A keep-out that goes all round and up to the zenith becomes one box across the zenith. With two boxes the zenith in
// its middle would be an edge, and edges are permitted.
std::vector<AxisBox> AxisImage::shifted(const TravelRange& azimuths, const TravelRange& elevations) const
{
    const auto box = [&](Side from, Side to) {
        const Angle top = from == to ? elevations.max : elevations.min;
        return AxisBox::between(place({azimuths.min, elevations.min}, from), place({azimuths.max, top}, to));
    };
    if (azimuths.max - azimuths.min >= kFullTurn && elevations.max >= 90_deg - kRounding) {
        return {box(Side::Upright, Side::OverTheTop)};
    }
    return {box(Side::Upright, Side::Upright), box(Side::OverTheTop, Side::OverTheTop)};
}

std::vector<AxisBox> AxisImage::enclosed(const TravelRange& azimuths, const TravelRange& elevations) const
{
    std::vector<AxisBox> boxes;
    for (const TravelRange& row : rows(common(elevations, m_tame))) {
        for (const TravelRange& column : columns(azimuths)) {
            for (const Side side : kSides) {
                boxes.push_back(enclosing(column, row, side));
            }
        }
    }
    if (elevations.max > m_tame.max) {
        boxes.push_back(zenithCap(std::max(elevations.min, m_tame.max)));
    }
    if (elevations.min < m_tame.min) {
        boxes.push_back(nadirCap(Side::Upright));
        boxes.push_back(nadirCap(Side::OverTheTop));
    }
    return boxes;
}

// Outside the caps the image of a part of the sky has no holes and no folds, so the image of its edges bounds it.
AxisBox AxisImage::enclosing(const TravelRange& azimuths, const TravelRange& elevations, Side side) const
{
    AxisBox box = AxisBox::at(place({azimuths.min, elevations.min}, side));
    const int across = 2 + static_cast<int>((azimuths.max - azimuths.min) / kApart);
    for (int i = 0; i <= across; ++i) {
        const Angle azimuth = part(azimuths, i, across);
        include(box, place({azimuth, elevations.min}, side));
        include(box, place({azimuth, elevations.max}, side));
    }
    for (int i = 0; i <= kSamples; ++i) {
        const Angle elevation = part(elevations, i, kSamples);
        include(box, place({azimuths.min, elevation}, side));
        include(box, place({azimuths.max, elevation}, side));
    }
    const Angle aside = kMargin / std::cos(elevations.max.radians());
    return {.azimuth = {box.azimuth.min - aside, box.azimuth.max + aside},
            .elevation = {box.elevation.min - kMargin, box.elevation.max + kMargin}};
}

// Columns so wide that the lean moves their ends hardly more than their middle.
std::vector<TravelRange> AxisImage::columns(const TravelRange& azimuths) const
{
    const int count = std::max(1, static_cast<int>(std::ceil((azimuths.max - azimuths.min) / kWidest)));
    std::vector<TravelRange> list;
    for (int i = 0; i < count; ++i) {
        list.push_back({part(azimuths, i, count), part(azimuths, i + 1, count)});
    }
    return list;
}

// Rows so high that their sides, which lean with the tangent of the elevation, move hardly more at the top than at the
// bottom. Far below the horizon one row is enough, because no beam gets there.
std::vector<TravelRange> AxisImage::rows(const TravelRange& elevations) const
{
    const auto above = [&](Angle from) {
        if (from < kDeep) {
            return kDeep;
        }
        const double rise = kHighest / std::cos(std::max(from, 0_deg).radians());
        return Angle::fromRadians(std::atan(std::tan(from.radians()) + rise));
    };
    std::vector<TravelRange> list;
    for (Angle from = elevations.min; from < elevations.max - kRounding; from = list.back().max) {
        list.push_back({from, std::min(elevations.max, above(from))});
    }
    return list;
}

AxisBox AxisImage::zenithCap(Angle from) const
{
    const Angle radius = 90_deg - from + m_skew;
    // Only sag and elevation offset, which are the same at every azimuth.
    const PointingModel level(PointingTerms{.elevationOffset = m_model.terms().elevationOffset,
                                            .elevationSag = m_model.terms().elevationSag});
    return {.azimuth = {-kBeyond, kBeyond},
            .elevation = {level.toAxes({{}, 90_deg - radius}).axes.elevation,
                          level.toAxes({{}, 90_deg + radius}).axes.elevation}};
}

AxisBox AxisImage::nadirCap(Side side) const
{
    const Angle above =
        -90_deg + 3.0 * m_skew + 1_deg + abs(m_model.terms().elevationOffset) + abs(m_model.terms().elevationSag);
    return {.azimuth = {-kBeyond, kBeyond},
            .elevation = side == Side::Upright ? TravelRange{-kBeyond, above} : TravelRange{180_deg - above, kBeyond}};
}

HorizonPoint AxisImage::lineAt(const HorizonPoint& truth, Side side) const
{
    const AxisPosition axes = place({truth.azimuth, std::clamp(truth.elevation, m_tame.min, m_tame.max)}, side);
    return side == Side::Upright ? HorizonPoint{axes.azimuth, axes.elevation}
                                 : HorizonPoint{axes.azimuth - 180_deg, 180_deg - axes.elevation};
}

// Adds the image of a line without its first point, divided into nearly straight parts.
void AxisImage::trace(std::vector<HorizonPoint>& line, const HorizonPoint& from, const HorizonPoint& to, Side side,
                      int depth) const
{
    const HorizonPoint middle{.azimuth = 0.5 * (from.azimuth + to.azimuth),
                              .elevation = 0.5 * (from.elevation + to.elevation)};
    const HorizonPoint begin = lineAt(from, side);
    const HorizonPoint bend = lineAt(middle, side);
    const HorizonPoint end = lineAt(to, side);
    const Angle off = std::max(abs(bend.azimuth - 0.5 * (begin.azimuth + end.azimuth)),
                               abs(bend.elevation - 0.5 * (begin.elevation + end.elevation)));
    if (depth == 0 || (off <= kStraight && to.azimuth - from.azimuth <= kLongest)) {
        line.push_back(end);
        return;
    }
    trace(line, from, middle, side, depth - 1);
    trace(line, middle, to, side, depth - 1);
}

std::vector<HorizonPoint> AxisImage::of(const Skyline& horizon, Side side) const
{
    std::vector<HorizonPoint> line;
    const bool bent = m_model.isSkewed() || m_model.terms().elevationSag != Angle{};
    for (std::size_t i = 0; i < horizon.lineCount(); ++i) {
        const auto [from, to] = horizon.line(i);
        if (!bent) {
            line.push_back(lineAt(from, side));
            continue;
        }
        if (line.empty()) {
            line.push_back(lineAt(from, side));
        }
        trace(line, from, to, side, kDeepest);
    }
    if (!bent) {
        return line;
    }
    std::vector<HorizonPoint> envelope = Envelope(line).highest();
    for (HorizonPoint& point : envelope) {
        point.elevation += kMargin;
    }
    return envelope;
}

std::vector<AxisBox> AxisImage::capOf(const Skyline& horizon) const
{
    return m_model.isSkewed() && horizon.peak() > m_tame.max ? std::vector{zenithCap(m_tame.max)}
                                                             : std::vector<AxisBox>{};
}

}  // namespace boresight::pointing
