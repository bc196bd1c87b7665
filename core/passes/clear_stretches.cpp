// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/passes/clear_stretches.h"

#include <algorithm>

namespace boresight::passes {

namespace {

constexpr double kPathStep = 0.25 * 3.14159265358979 / 180.0;  // rad
constexpr double kShortestPathStep = 0.1;                      // s
constexpr double kLongestPathStep = 60.0;                      // s: a geostationary satellite hardly moves
constexpr double kEndWidth = 1e-3;                             // s

}  // namespace

std::vector<Stretch> clearStretches(SkyTrack& track, double fromSeconds, double toSeconds,
                                    const std::function<bool(const SkyPointing&)>& isClear)
{
    const auto isClearAt = [&](double seconds) {
        const auto moment = track.at(seconds);
        return moment && isClear(track.direction(*moment));
    };
    const auto changeBetween = [&](double low, double high, bool before) {
        while (high - low > kEndWidth) {
            const double middle = 0.5 * (low + high);
            (isClearAt(middle) == before ? low : high) = middle;
        }
        return high;
    };
    std::vector<Stretch> found;
    bool wasClear = false;
    double begin = fromSeconds;
    double last = fromSeconds;
    for (double now = fromSeconds;;) {
        const auto moment = track.at(now);
        const bool isNowClear = moment && isClear(track.direction(*moment));
        if (isNowClear != wasClear) {
            const double change = now > last ? changeBetween(last, now, wasClear) : now;
            if (wasClear) {
                found.push_back({track.utc(begin), track.utc(change)});
            }
            begin = change;
            wasClear = isNowClear;
        }
        if (now >= toSeconds || !moment) {
            break;
        }
        last = now;
        now = std::min(toSeconds, now + std::clamp(kPathStep / moment->swing, kShortestPathStep, kLongestPathStep));
    }
    if (wasClear) {
        found.push_back({track.utc(begin), track.utc(toSeconds)});
    }
    return found;
}

}  // namespace boresight::passes
