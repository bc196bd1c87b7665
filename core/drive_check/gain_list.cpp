// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/gain_list.h"

#include "core/base/text.h"

#include <algorithm>
#include <numbers>

namespace boresight::drive_check {
namespace {

struct Bounds
{
    double least = 0.0;
    double most = 0.0;
    QString why;
};

// One step of tuning is a factor of two at most. A larger change is probably a typing error, and can shake a mast.
constexpr double kFactor = 4.0;
constexpr double kFastestIntegral = 10.0;       // 1/s: kp is built up again within a tenth of a second
constexpr double kIntegralError = 0.1 / 360.0;  // turns: the integral may hold the torque of this error
constexpr double kFiltersAbove = 10.0;          // times the bandwidth of the position control
constexpr double kLowestFilter = 10.0;          // Hz
constexpr double kHighestFilter = 1000.0;       // Hz; factory default: 400

double of(const GainValues& values, Gain gain)
{
    return values[indexOf(gain)].value_or(0.0);
}

Bounds around(double stored)
{
    return {.least = stored / kFactor,
            .most = stored * kFactor,
            .why = Text::tr("A quarter to four times the stored value. A larger change is probably a typing error.")};
}

// The inertia for which this stiffness and damping are critically damped.
double inertiaFor(double stiffness, double damping)
{
    return stiffness > 0.0 ? damping * damping / (8.0 * std::numbers::pi * stiffness) : 0.0;
}

Bounds filterBounds(double stored, double stiffness, double damping)
{
    const double bandwidth = damping > 0.0 ? 2.0 * stiffness / damping / (2.0 * std::numbers::pi) : 0.0;  // Hz
    const double least = std::clamp(kFiltersAbove * bandwidth, kLowestFilter, kHighestFilter);
    return {.least = stored > 0.0 ? std::min(least, stored) : least,
            .most = std::max(kHighestFilter, stored),
            .why = Text::tr("Set at least ten times the bandwidth of the position control. With less, the measured "
                            "speed lags too much for the damping.")};
}

Bounds boundsOf(Gain gain, const GainValues& stored)
{
    const double own = of(stored, gain);
    const double stiffness = of(stored, Gain::Stiffness);
    switch (gain) {
        case Gain::Stiffness:
        case Gain::Damping:
            return around(own);
        case Gain::Integral:
            return {.most = std::max(kFactor * own, kFastestIntegral * stiffness),
                    .why = Text::tr("At most ten times kp, or four times the stored value. A faster integral makes the "
                                    "axis oscillate.")};
        case Gain::IntegralLimit:
            return {.most = std::max(kFactor * own, kIntegralError * stiffness),
                    .why = Text::tr("At most the torque of kp at an error of 0.1°, or four times the stored value.")};
        case Gain::InertiaFeedforward:
            return {
                .most = std::max(kFactor * own, kFactor * inertiaFor(stiffness, of(stored, Gain::Damping))),
                .why = Text::tr("At most four times the inertia that fits kp and kd, or four times the stored value.")};
        case Gain::EncoderFilter:
        case Gain::Count:
            break;
    }
    return filterBounds(own, stiffness, of(stored, Gain::Damping));
}

QString unitOf(Gain gain)
{
    switch (gain) {
        case Gain::Stiffness:
            return Text::tr("Nm/turn");
        case Gain::Integral:
            return Text::tr("Nm/s/turn");
        case Gain::Damping:
            return Text::tr("Nm/(turn/s)");
        case Gain::IntegralLimit:
            return QStringLiteral("Nm");
        case Gain::InertiaFeedforward:
            return QStringLiteral("kg·m²");
        case Gain::EncoderFilter:
        case Gain::Count:
            break;
    }
    return QStringLiteral("Hz");
}

}  // namespace

const std::string& gainKey(Gain gain)
{
    static const std::array<std::string, kGainCount> kKeys{
        "servo.pid_position.kp",     "servo.pid_position.ki",     "servo.pid_position.kd",
        "servo.pid_position.ilimit", "servo.inertia_feedforward", "motor_position.sources.0.pll_filter_hz"};
    return kKeys[indexOf(gain)];
}

std::vector<GainLine> gainLines(const GainValues& stored)
{
    std::vector<GainLine> lines;
    for (std::size_t i = 0; i < kGainCount; ++i) {
        const auto gain = static_cast<Gain>(i);
        const Bounds bounds = boundsOf(gain, stored);
        lines.push_back({.key = QString::fromStdString(gainKey(gain)),
                         .unit = unitOf(gain),
                         .stored = stored[i],
                         .least = bounds.least,
                         .most = bounds.most,
                         .bounds = bounds.why,
                         .needsOff = gain == Gain::EncoderFilter});
    }
    return lines;
}

}  // namespace boresight::drive_check
