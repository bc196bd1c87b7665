// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/degrees_text.h"
#include "core/units/sky.h"

#include <QString>

#include <chrono>
#include <optional>

// Numbers as text on the screen: fixed decimals, sign, unit, and the age at which a number is no longer shown. The
// azimuth of a direction uses azimuthText() of core/units: never "360.0°".
namespace boresight::ui {

// A number is live for half a second. Then it is dimmed and shows its age. After kNoDataAfter it is not shown any more.
enum class Freshness
{
    Live,
    Late,
    NoData
};

inline constexpr std::chrono::milliseconds kLateAfter{500};

[[nodiscard]] Freshness freshness(const std::optional<std::chrono::milliseconds>& age);

[[nodiscard]] QString noValue();                                       // "---.--°"
[[nodiscard]] QString angleText(Angle angle, int decimals = 2);        // "335.02°"
[[nodiscard]] QString signedAngleText(Angle angle, int decimals = 2);  // "+4.48°"
[[nodiscard]] QString rateText(AngularRate rate, int decimals = 1);    // "2.0°/s"
[[nodiscard]] QString directionText(const SkyPointing& direction);     // "az 113.0°  el 10.0°"
[[nodiscard]] QString axisText(const AxisPosition& position);          // the same, azimuth not wrapped
[[nodiscard]] QString ageText(std::chrono::milliseconds age);          // "0.7 s"
[[nodiscard]] QString waitText(Seconds time);                          // "40 s", "5 min", "2 h"
[[nodiscard]] QString clockText(UtcTime utc);                          // "17:05:59"
[[nodiscard]] QString minuteText(UtcTime utc);                         // "2026-11-21 17:05Z"
[[nodiscard]] QString dateText(UtcTime utc);                           // "2026-11-21 17:05:59.120Z"

}  // namespace boresight::ui
