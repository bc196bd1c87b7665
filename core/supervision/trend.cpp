// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/trend.h"

#include <cmath>

namespace boresight::supervision {
namespace {

constexpr Seconds kWindow{60.0};
constexpr Seconds kEnough{40.0};
constexpr Seconds kMeanOver{1.0};
// After a longer gap the drive may have been off, so a new trend begins.
constexpr Seconds kTrendGap{10.0};
// The share of the variance that the line must explain. A value with one step reaches 3/4 at most, one with two equal
// steps 8/9. A warming board (an exponential of 180 s) reaches more than 0.99.
constexpr double kStraight = 0.9;
constexpr double kResolution = 0.1;  // V or °C per minute: the reported values have steps of this size

struct Moments
{
    double n = 0.0;
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;

    void add(double atX, double atY)
    {
        n += 1.0;
        x += atX;
        y += atY;
        xx += atX * atX;
        xy += atX * atY;
        yy += atY * atY;
    }
};

}  // namespace

std::optional<Seconds> Trend::Line::timeTo(double limit) const
{
    const double minutes = (limit - now) / perMinute;
    if (!std::isfinite(minutes) || minutes < 0.0) {
        return std::nullopt;
    }
    return Seconds(60.0 * minutes);
}

void Trend::add(SteadyTime at, double value)
{
    if (!m_points.empty() && at - m_points.back().at > kTrendGap) {
        *this = Trend();
    }
    if (m_count == 0) {
        m_sum.at = at;
    }
    m_sum.value += value;
    ++m_count;
    if (at - m_sum.at < kMeanOver) {
        return;
    }
    m_points.push_back({at, m_sum.value / m_count});
    m_sum = {};
    m_count = 0;
    while (at - m_points.front().at > kWindow) {
        m_points.pop_front();
    }
}

std::optional<Trend::Line> Trend::line() const
{
    if (m_points.empty() || m_points.back().at - m_points.front().at < kEnough) {
        return std::nullopt;
    }
    Moments sum;
    for (const Point& point : m_points) {
        sum.add(Seconds(point.at - m_points.back().at).count() / 60.0, point.value);
    }
    const double covariance = sum.xy - sum.x * sum.y / sum.n;
    const double varianceX = sum.xx - sum.x * sum.x / sum.n;
    const double varianceY = sum.yy - sum.y * sum.y / sum.n;
    if (covariance * covariance <= kStraight * varianceX * varianceY) {
        return std::nullopt;
    }
    const double slope = covariance / varianceX;
    if (std::abs(slope) < kResolution) {
        return std::nullopt;
    }
    return Line{.now = (sum.y - slope * sum.x) / sum.n, .perMinute = slope};
}

}  // namespace boresight::supervision
