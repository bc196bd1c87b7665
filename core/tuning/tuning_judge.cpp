// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tuning/tuning_judge.h"

#include "core/base/text.h"
#include "core/units/degrees_text.h"

#include <algorithm>

namespace boresight {
namespace {

// Below these values tuning is not worth it: a beam is some degrees wide, and a pass moves at 1°/s.
constexpr double kSmallOvershoot = 0.05;
constexpr Seconds kQuick{0.5};
constexpr Angle kSettled = Angle::fromDegrees(0.04);  // 2 % of the step
constexpr Angle kSmallLeft = Angle::fromDegrees(0.02);
constexpr Angle kSmallError = Angle::fromDegrees(0.05);
constexpr double kResonance = 1.3;
constexpr double kFollows = 0.7;

// For the curves. More samples are not visible, and the screen gets them again and again.
constexpr std::size_t kMostSamples = 1200;

using Parts = std::vector<std::vector<response::Sample>>;

QString percent(double part)
{
    return QString::number(100.0 * part, 'f', 1) + QStringLiteral(" %");
}

std::optional<response::TorqueFigures> worse(const std::optional<response::TorqueFigures>& one,
                                             const std::optional<response::TorqueFigures>& other)
{
    if (!one || !other) {
        return one ? one : other;
    }
    return response::TorqueFigures{.rms = std::max(one->rms, other->rms), .peak = std::max(one->peak, other->peak)};
}

response::ErrorFigures worse(const response::ErrorFigures& one, const response::ErrorFigures& other)
{
    return {.rms = std::max(one.rms, other.rms), .peak = std::max(one.peak, other.peak)};
}

std::vector<response::Sample> thinned(const std::vector<response::Sample>& samples)
{
    const std::size_t every = samples.size() / kMostSamples + 1;
    std::vector<response::Sample> kept;
    for (std::size_t i = 0; i < samples.size(); i += every) {
        kept.push_back(samples[i]);
    }
    return kept;
}

Result<response::StepFigures> stepOf(const Parts& parts)
{
    const auto out = response::stepFigures(parts.at(0), kSettled);
    const auto back = response::stepFigures(parts.at(1), kSettled);
    if (!out || !back) {
        return out ? back : out;
    }
    response::StepFigures both = *out;
    both.overshoot = std::max(out->overshoot, back->overshoot);
    both.settling =
        out->settling && back->settling ? std::optional(std::max(*out->settling, *back->settling)) : std::nullopt;
    both.left = abs(out->left) > abs(back->left) ? out->left : back->left;
    both.error = worse(out->error, back->error);
    both.torque = worse(out->torque, back->torque);
    return both;
}

Result<response::RampFigures> rampOf(const Parts& parts)
{
    const auto out = response::rampFigures(parts.at(0));
    const auto back = response::rampFigures(parts.at(1));
    if (!out || !back) {
        return out ? back : out;
    }
    response::RampFigures both = *out;
    both.lag = abs(out->lag) > abs(back->lag) ? out->lag : back->lag;
    both.steady = worse(out->steady, back->steady);
    both.error = worse(out->error, back->error);
    both.torque = worse(out->torque, back->torque);
    return both;
}

Result<std::vector<response::SweepPoint>> sweepOf(const Parts& parts)
{
    std::vector<response::SweepPoint> points;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        // The limits of motion may remove a fast swing completely.
        if (const auto point = response::sweepPoint(parts[i], kSweepHertz.at(i))) {
            points.push_back(*point);
        }
    }
    return points.empty() ? Result<std::vector<response::SweepPoint>>(failure(
                                ErrorCode::Refused, Text::tr("The limits of motion are too low for any swing.")))
                          : points;
}

void say(TuningResult& result, bool good, const QString& sentence)
{
    result.good = result.good && good;
    result.verdict.push_back(sentence);
}

void judgeStep(TuningResult& result, const response::StepFigures& step)
{
    const bool small = step.overshoot <= kSmallOvershoot;
    say(result, small,
        small ? Text::tr("Overshoot %1: small.").arg(percent(step.overshoot))
              : Text::tr("Overshoot %1: the axis moves past its target. Raise kd, or lower ki.")
                    .arg(percent(step.overshoot)));
    const bool quick = step.settling && *step.settling <= kQuick;
    say(result, quick,
        !step.settling ? Text::tr("The axis does not settle within %1. Lower kp and ki, or raise kd.")
                             .arg(degreesText(step.band, 2))
        : quick ? Text::tr("Settled %1 s after the set-point: quick.").arg(step.settling->count(), 0, 'f', 2)
                : Text::tr("Settled %1 s after the set-point: slow. Raise kp and kd together.")
                      .arg(step.settling->count(), 0, 'f', 2));
    if (abs(step.left) > kSmallLeft) {
        say(result, false,
            Text::tr("An error of %1 remains. Friction or weight holds the axis. Raise ki or its limit.")
                .arg(degreesText(abs(step.left), 3)));
    }
}

void judgeRamp(TuningResult& result, const response::RampFigures& ramp)
{
    const bool small = ramp.steady.peak <= kSmallError;
    say(result, small,
        small ? Text::tr("The axis tracks %1°/s within %2: good for every pass.")
                    .arg(abs(ramp.rate).degrees(), 0, 'f', 1)
                    .arg(degreesText(ramp.steady.peak, 3))
              : Text::tr("The error is up to %1 at %2°/s. Raise kp, then ki.")
                    .arg(degreesText(ramp.steady.peak, 3))
                    .arg(abs(ramp.rate).degrees(), 0, 'f', 1));
    if (ramp.error.peak > 2.0 * ramp.steady.peak && ramp.error.peak > kSmallError) {
        say(result, false,
            Text::tr("The error at start and stop is %1. Raise the inertia feed-forward.")
                .arg(degreesText(ramp.error.peak, 3)));
    }
}

void judgeSweep(TuningResult& result, const std::vector<response::SweepPoint>& points)
{
    const auto highest = std::ranges::max_element(points, {}, &response::SweepPoint::gain);
    if (highest->gain > kResonance) {
        say(result, false,
            Text::tr("At %1 Hz the axis swings %2 times as far as commanded. Raise kd, or lower kp.")
                .arg(highest->hertz, 0, 'f', 1)
                .arg(highest->gain, 0, 'f', 2));
    }
    const auto lost = std::ranges::find_if(
        points, [](const auto& one) { return one.gain < kFollows || one.phase < Angle::fromDegrees(-90.0); });
    say(result, lost == points.end() || lost != points.begin(),
        lost == points.end()     ? Text::tr("The axis follows all swings to %1 Hz.").arg(points.back().hertz, 0, 'f', 1)
        : lost == points.begin() ? Text::tr("The axis does not follow a swing at %1 Hz. Raise kp and kd together.")
                                       .arg(points.front().hertz, 0, 'f', 1)
                                 : Text::tr("The axis follows swings up to %1 Hz.").arg((lost - 1)->hertz, 0, 'f', 1));
}

void judgeBacklash(TuningResult& result, const response::BacklashFigures& found)
{
    say(result, true,
        Text::tr("Backlash %1 ± %2, seen at %3 of %4 reversals.")
            .arg(degreesText(found.gap, 3), degreesText(found.uncertainty, 3))
            .arg(found.reversals)
            .arg(found.tried));
    say(result, true,
        Text::tr("The motor needs %1 Nm in the gap and %2 Nm with the load.")
            .arg(found.freeTorque, 0, 'f', 1)
            .arg(found.loadTorque, 0, 'f', 1));
}

}  // namespace

Result<TuningResult> resultOf(const TuningRunState& run)
{
    TuningResult result{.axis = run.axis(), .run = run.run(), .good = true, .samples = thinned(run.all())};
    const auto keep = [&result](auto& place, const auto& figures, auto judge) -> Result<TuningResult> {
        return figures.map([&](const auto& found) {
            place = found;
            judge(result, found);
            return result;
        });
    };
    switch (run.run()) {
        case TuningRun::Step:
            return keep(result.step, stepOf(run.parts()), judgeStep);
        case TuningRun::Ramp:
            return keep(result.ramp, rampOf(run.parts()), judgeRamp);
        case TuningRun::Sweep:
            return keep(result.sweep, sweepOf(run.parts()), judgeSweep);
        case TuningRun::Backlash:
            break;
    }
    return keep(result.backlash, response::backlashFigures(run.parts().at(0)), judgeBacklash);
}

}  // namespace boresight
