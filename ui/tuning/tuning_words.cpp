// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/tuning_words.h"

#include "ui/kit/axes.h"
#include "ui/kit/format.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

struct TuningWords
{
    Q_DECLARE_TR_FUNCTIONS(TuningWords)
};

QString percent(double part)
{
    return QString::number(100.0 * part, 'f', 1) + QStringLiteral(" %");
}

QString torqueText(double torque)
{
    return QString::number(torque, 'f', 1) + QStringLiteral(" Nm");
}

void addCommon(std::vector<Figure>& figures, const response::ErrorFigures& error,
               const std::optional<response::TorqueFigures>& torque)
{
    figures.push_back({TuningWords::tr("Error rms"), angleText(error.rms, 4)});
    figures.push_back({TuningWords::tr("Error peak"), angleText(error.peak, 4)});
    figures.push_back({TuningWords::tr("Torque rms"), torque ? torqueText(torque->rms) : QString()});
    figures.push_back({TuningWords::tr("Torque peak"), torque ? torqueText(torque->peak) : QString()});
}

std::vector<Figure> stepFigures(const response::StepFigures& step)
{
    std::vector<Figure> figures{{TuningWords::tr("Overshoot"), percent(step.overshoot)},
                                {TuningWords::tr("Settling time"),
                                 step.settling ? QString::number(step.settling->count(), 'f', 2) + QStringLiteral(" s")
                                               : TuningWords::tr("never")},
                                {TuningWords::tr("Remaining"), signedAngleText(step.left, 4)}};
    addCommon(figures, step.error, step.torque);
    return figures;
}

std::vector<Figure> rampFigures(const response::RampFigures& ramp)
{
    std::vector<Figure> figures{{TuningWords::tr("Rate"), rateText(abs(ramp.rate))},
                                {TuningWords::tr("Lag"), signedAngleText(ramp.lag, 4)},
                                {TuningWords::tr("Error at start"), angleText(ramp.error.peak, 4)}};
    addCommon(figures, ramp.steady, ramp.torque);
    return figures;
}

std::vector<Figure> sweepFigures(const std::vector<response::SweepPoint>& sweep)
{
    std::vector<Figure> figures;
    for (const response::SweepPoint& point : sweep) {
        figures.push_back(
            {TuningWords::tr("At %1 Hz").arg(point.hertz, 0, 'f', 1),
             QStringLiteral("%1×, %2").arg(QString::number(point.gain, 'f', 2), signedAngleText(point.phase, 0))});
    }
    return figures;
}

std::vector<Figure> backlashFigures(const response::BacklashFigures& found)
{
    return {{TuningWords::tr("Backlash"), angleText(found.gap, 3)},
            {TuningWords::tr("Uncertainty"), QStringLiteral("± ") + angleText(found.uncertainty, 3)},
            {TuningWords::tr("Torque in the gap"), torqueText(found.freeTorque)},
            {TuningWords::tr("Torque with the load"), torqueText(found.loadTorque)},
            {TuningWords::tr("Reversals"), QStringLiteral("%1/%2").arg(found.reversals).arg(found.tried)}};
}

bool isInForce(const TuningResult& result, const DriveGains& gains)
{
    return std::ranges::equal(
        result.gains, gains.lines,
        [](const std::optional<double>& one, const std::optional<double>& now) { return isSameGain(one, now); }, {},
        &GainLine::value);
}

}  // namespace

QString runName(TuningRun run)
{
    switch (run) {
        case TuningRun::Step:
            return TuningWords::tr("Step");
        case TuningRun::Ramp:
            return TuningWords::tr("Ramp");
        case TuningRun::Sweep:
            return TuningWords::tr("Swings");
        case TuningRun::Backlash:
            break;
    }
    return TuningWords::tr("Backlash");
}

QString gainName(Gain gain)
{
    switch (gain) {
        case Gain::Stiffness:
            return TuningWords::tr("Stiffness kp");
        case Gain::Integral:
            return TuningWords::tr("Integral ki");
        case Gain::Damping:
            return TuningWords::tr("Damping kd");
        case Gain::IntegralLimit:
            return TuningWords::tr("Limit of the integral");
        case Gain::InertiaFeedforward:
            return TuningWords::tr("Inertia feed-forward");
        case Gain::EncoderFilter:
        case Gain::Count:
            break;
    }
    return TuningWords::tr("Encoder filter");
}

QString gainText(double value)
{
    return std::abs(value) >= 1e5 ? QString::number(value, 'f', 0) : QString::number(value, 'g', 6);
}

std::vector<Figure> figuresOf(const TuningResult& result)
{
    if (result.step) {
        return stepFigures(*result.step);
    }
    if (result.ramp) {
        return rampFigures(*result.ramp);
    }
    return result.backlash ? backlashFigures(*result.backlash) : sweepFigures(result.sweep);
}

BeforeAndAfter resultsOf(const TuningStatus& tuning, Axis axis, TuningRun run)
{
    BeforeAndAfter both;
    for (const TuningResult& one : tuning.results) {
        if (one.axis == axis && one.run == run) {
            (one.asFound ? both.before : both.after) = &one;
        }
    }
    return both;
}

const TuningResult* resultInForce(const StationStatus& status, Axis axis, TuningRun run)
{
    const DriveGains& gains = driveOf(status, axis).gains;
    const TuningResult* newest = nullptr;
    for (const TuningResult& one : status.tuning->results) {
        const bool counts = one.axis == axis && one.run == run && (!gains.read || isInForce(one, gains));
        if (counts && (newest == nullptr || one.when >= newest->when)) {
            newest = &one;
        }
    }
    return newest;
}

FirstTuning firstTuning(const StationStatus& status, Axis axis)
{
    if (!driveOf(status, axis).gains.read) {
        return {.text = TuningWords::tr("First tuning, 1 of 5: read the gains of the drive."), .reads = true};
    }
    int step = 2;
    QStringList wrong;
    for (const TuningRun run : {TuningRun::Step, TuningRun::Ramp, TuningRun::Sweep}) {
        const TuningResult* const result = resultInForce(status, axis, run);
        if (result == nullptr) {
            return {
                .text = TuningWords::tr("First tuning, %1 of 5: measure the run \"%2\".").arg(step).arg(runName(run)),
                .run = run};
        }
        if (!result->good) {
            wrong << runName(run);
        }
        ++step;
    }
    return {.text = wrong.isEmpty()
                        ? TuningWords::tr("First tuning, 5 of 5: the %1 is well tuned. Nothing needs to be changed.")
                              .arg(name(axis))
                        : TuningWords::tr("First tuning, 5 of 5: change a gain as \"%1\" advises, and measure again.")
                              .arg(wrong.join(QStringLiteral("\", \"")))};
}

}  // namespace boresight::ui
