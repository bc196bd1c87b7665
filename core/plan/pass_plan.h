// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <QString>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

// A whole pass, planned before it begins: the motion of both axes, the pointing error to expect, and the other ways
// that were compared. Plain values, any thread.
namespace boresight::plan {

// How the axes follow the target through a pass.
enum class PlanWay
{
    Direct,            // elevations up to 90°
    OverTheTop,        // elevations above 90° during the whole pass
    ThroughTheZenith,  // changes between both at the highest point
    OtherWayRound,     // at the highest point the azimuth goes round through the other side
    WaitsAtTheEnd,     // the cable ends, and the mount waits there while the target is beyond
    Unwraps            // the cable ends, so the mount turns back by 360° during the pass
};

struct PlannedMoment
{
    UtcTime utc{};
    SkyPointing target{};
    AxisPosition axes{};
    AxisRates rates{};
    Angle error{};          // between beam and target
    bool isHidden = false;  // the limits of the mount hide the target

    bool operator==(const PlannedMoment&) const = default;
};

struct PlanSpan
{
    UtcTime from{};
    UtcTime to{};

    bool operator==(const PlanSpan&) const = default;
};

// The pointing error while the target is not hidden.
struct Forecast
{
    Angle peak{};
    Angle rms{};
    Seconds beyond{};                  // time with an error above the bound of the plan
    Seconds hidden{};                  // this part of the pass is not in the other numbers
    std::optional<double> peakLoss{};  // dB; empty beyond the main lobe

    bool operator==(const Forecast&) const = default;
};

struct PlanVariant
{
    PlanWay way = PlanWay::Direct;
    std::vector<PlannedMoment> moments;  // in the order of time
    Forecast forecast;
    std::optional<PlanSpan> ramp;    // the azimuth is not with the target, because it is too slow
    std::optional<PlanSpan> unwrap;  // the mount turns back by 360°
    Angle unwrapsTo{};               // azimuth of the axis on the new wrap
    Seconds toStart{};               // from the present position of the axes to the start
    Angle margin{};                  // of the cable, at the nearer end

    [[nodiscard]] AxisPosition start() const { return moments.front().axes; }
    [[nodiscard]] AxisPosition end() const { return moments.back().axes; }
    // No cable ends during the pass.
    [[nodiscard]] bool isWhole() const { return way != PlanWay::WaitsAtTheEnd && way != PlanWay::Unwraps; }
    // Where the axes are. Before the pass at its start, after the pass at its end.
    [[nodiscard]] AxisPosition placeAt(UtcTime utc) const;

    bool operator==(const PlanVariant&) const = default;
};

// Never changed, so threads share it.
using SharedVariant = std::shared_ptr<const PlanVariant>;

// One variant of a plan, as an operator chooses it. The wrap is the one of the azimuth at the start.
struct ChosenWay
{
    PlanWay way = PlanWay::Direct;
    Angle startAzimuth{};

    bool operator==(const ChosenWay&) const = default;
};

struct PassPlan
{
    Angle bound;                        // of the error
    std::vector<PlanVariant> variants;  // empty: the orbit has no answer
    std::size_t chosen = 0;

    [[nodiscard]] const PlanVariant& best() const { return variants[chosen]; }
    bool operator==(const PassPlan&) const = default;
};

[[nodiscard]] ChosenWay choiceFor(const PlanVariant& variant);

// The index of the variant that this choice means, among those of a plan that may have been made some time later.
// Empty: the plan has no such way.
[[nodiscard]] std::optional<std::size_t> indexOf(const PassPlan& plan, const ChosenWay& choice);

// As other programs read it: "direct", "over-the-top", "through-the-zenith", "other-way-round", "waits", "unwraps".
[[nodiscard]] QString keyOf(PlanWay way);

// The forecast for moments whose errors and hidden parts are known.
[[nodiscard]] Forecast forecastOf(const std::vector<PlannedMoment>& moments, Angle bound, Angle beamWidth);

// When a plan begins.
enum class Begins
{
    Later,  // the mount waits at the start
    Now     // the way to the start is time without the target
};

// The index of the best variant: the shortest time beyond the bound, then the smallest peak error, then the order of
// PlanWay, then the shortest way to the start, then the larger margin of the cable. Differences that cost less than
// 0.1 dB, 0.05° or 0.5 s do not count. At least one variant is required.
[[nodiscard]] std::size_t choiceOf(const std::vector<PlanVariant>& variants, Angle beamWidth, Begins begins);

}  // namespace boresight::plan
