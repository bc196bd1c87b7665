// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/calibration_words.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "ui/kit/format.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

class CalibrationWords
{
    Q_DECLARE_TR_FUNCTIONS(CalibrationWords)
};

QString hourText(UtcTime utc)
{
    return clockText(utc).left(5) + QLatin1Char('Z');
}

QString northLine(const SwingOutcome& swing)
{
    const calibration::CompassSwing& fit = swing.fit;
    QString text =
        CalibrationWords::tr("North %1. The readings cause %2 of the uncertainty. A swing cannot measure the other %3.")
            .arg(offsetText(fit.north), angleText(fit.statistical), angleText(fit.systematic));
    if (fit.harmonics != calibration::Harmonics::None) {
        text += QLatin1Char(' ') + CalibrationWords::tr("Hard iron %1, soft iron %2, readings scatter by %3.")
                                       .arg(angleText(fit.curve.firstAmplitude(), 1),
                                            angleText(fit.curve.secondAmplitude(), 1), angleText(fit.curve.scatter, 1));
    }
    return text;
}

QString tiltLine(const SwingOutcome& swing)
{
    if (!swing.tilt) {
        return swing.noTilt.isEmpty() ? QString() : CalibrationWords::tr("No tilt: %1").arg(swing.noTilt);
    }
    const calibration::AxisTilt& tilt = *swing.tilt;
    return CalibrationWords::tr(
               "The azimuth axis leans by %1 ± %2 towards %3. At 0° of the elevation axis the sensor reports %4.")
        .arg(angleText(tilt.size), angleText(tilt.sizeSigma), azimuthText(tilt.direction, 0),
             estimateText(tilt.elevationOffset));
}

// A proposal from the fit has exactly the terms of the fit. Nobody types terms with this accuracy.
constexpr Angle kSame = Angle::fromDegrees(1e-6);

std::optional<Angle> leftOutRms(const std::vector<PointStatus>& points)
{
    double sum = 0.0;
    int count = 0;
    for (const PointStatus& point : points) {
        if (point.leftOut) {
            sum += point.leftOut->degrees() * point.leftOut->degrees();
            ++count;
        }
    }
    return count > 0 ? std::optional(Angle::fromDegrees(std::sqrt(sum / count))) : std::nullopt;
}

// A fit that is far better than its sigmas is as remarkable as one that is worse, so the text is never "0.0".
QString twoDigits(double value)
{
    const double magnitude = value > 0.0 ? std::floor(std::log10(value)) : 0.0;
    return QString::number(value, 'f', std::clamp(1 - static_cast<int>(magnitude), 0, 6));
}

QString pointsText(const std::vector<PointStatus>& points)
{
    const auto used = static_cast<std::size_t>(std::ranges::count_if(points, &PointStatus::isUsed));
    if (used < points.size()) {
        return CalibrationWords::tr("%1 of %2 points").arg(used).arg(points.size());
    }
    return used == 1 ? CalibrationWords::tr("1 point") : CalibrationWords::tr("%1 points").arg(used);
}

QString termsText(const std::vector<TermStatus>& terms)
{
    const auto on = std::ranges::count_if(terms, &TermStatus::isOn);
    return on == 1 ? CalibrationWords::tr("1 term") : CalibrationWords::tr("%1 terms").arg(on);
}

QString noFitText(const CalibrationStatus& calibration)
{
    if (calibration.points.empty()) {
        return CalibrationWords::tr("No points yet. Take them in step 3");
    }
    return calibration.noFit.isEmpty() ? CalibrationWords::tr("No fit for these points")
                                       : CalibrationWords::tr("No fit: %1").arg(calibration.noFit);
}

}  // namespace

const BodyNow* bodyNow(const StationStatus& status, ephemeris::Body body)
{
    const auto& bodies = calibrationOf(status).bodies;
    const auto found = std::ranges::find(bodies, body, &BodyNow::body);
    return found == bodies.end() ? nullptr : &*found;
}

const CalibrationStatus& calibrationOf(const StationStatus& status)
{
    static const CalibrationStatus nothing;
    return status.calibration ? *status.calibration : nothing;
}

QString estimateText(const calibration::Estimate& estimate)
{
    return QStringLiteral("%1 ± %2").arg(angleText(estimate.value), angleText(estimate.sigma));
}

QString offsetText(const calibration::Estimate& estimate)
{
    return QStringLiteral("%1 ± %2").arg(signedAngleText(estimate.value.wrapped180()), angleText(estimate.sigma));
}

QString termName(const std::string& key)
{
    static const std::pair<const char*, const char*> names[] = {
        {"pointing.azimuth_offset_deg", QT_TRANSLATE_NOOP("CalibrationWords", "azimuth offset")},
        {"pointing.elevation_offset_deg", QT_TRANSLATE_NOOP("CalibrationWords", "elevation offset")},
        {"pointing.tilt_north_deg", QT_TRANSLATE_NOOP("CalibrationWords", "tilt to the north")},
        {"pointing.tilt_east_deg", QT_TRANSLATE_NOOP("CalibrationWords", "tilt to the east")},
        {"pointing.collimation_deg", QT_TRANSLATE_NOOP("CalibrationWords", "collimation")},
        {"pointing.non_perpendicularity_deg", QT_TRANSLATE_NOOP("CalibrationWords", "axes not square")},
        {"pointing.elevation_sag_deg", QT_TRANSLATE_NOOP("CalibrationWords", "gravity sag")}};
    for (const auto& [known, text] : names) {
        if (key == known) {
            return CalibrationWords::tr(text);
        }
    }
    return QString::fromStdString(key);
}

QString bodyName(ephemeris::Body body)
{
    return body == ephemeris::Body::Sun ? CalibrationWords::tr("Sun") : CalibrationWords::tr("Moon");
}

QString placeText(const BodyNow& body)
{
    QString next;
    if (body.isUp && body.nextSet) {
        next = CalibrationWords::tr("sets %1").arg(hourText(*body.nextSet));
    } else if (!body.isUp) {
        next = body.nextRise ? CalibrationWords::tr("below the horizon, rises %1").arg(hourText(*body.nextRise))
                             : CalibrationWords::tr("below the horizon");
    }
    const QString where = directionText(body.direction);
    return next.isEmpty() ? where : where + QStringLiteral(", ") + next;
}

bool keepsNorth(const CalibrationProposal& proposal)
{
    return proposal.changesSensor && !proposal.terms.empty() &&
           proposal.terms.front().proposed == proposal.terms.front().present;
}

QString changeText(const CalibrationProposal& proposal)
{
    QStringList changes;
    for (const TermStatus& term : proposal.terms) {
        const QString before = angleText(term.present);
        const QString after = angleText(term.proposed);
        if (before != after) {
            changes << QStringLiteral("%1 %2 → %3").arg(termName(term.key), before, after);
        }
    }
    if (keepsNorth(proposal)) {
        changes << CalibrationWords::tr("north stays");
    }
    if (proposal.changesSensor) {
        changes << CalibrationWords::tr("curve of the sensor");
    }
    return changes.isEmpty() ? CalibrationWords::tr("no term changes by 0.01°") : changes.join(QStringLiteral(", "));
}

QStringList warningsOf(const CalibrationProposal& proposal)
{
    return QStringList(proposal.doubts.begin(), proposal.doubts.end()) +
           QStringList(proposal.warnings.begin(), proposal.warnings.end());
}

Sentence proposalSentence(const CalibrationStatus& calibration)
{
    if (!calibration.proposal) {
        return {CalibrationWords::tr("Nothing proposed yet")};
    }
    CalibrationProposal proposal = *calibration.proposal;
    if (proposal.residuals) {
        proposal.title += CalibrationWords::tr(", points: rms %1 → %2")
                              .arg(angleText(proposal.residuals->before, 3), angleText(proposal.residuals->after, 3));
    }
    return warningsOf(proposal).isEmpty() ? Sentence{proposal.title, Tone::Normal}
                                          : Sentence{proposal.title, Tone::Warning, Symbol::Warning};
}

QString swingText(const SwingOutcome& swing)
{
    QStringList lines;
    for (const QString& reason : swing.fit.hopeless) {
        lines << QStringLiteral("▲ ") + reason;
    }
    lines << northLine(swing);
    if (const QString tilt = tiltLine(swing); !tilt.isEmpty()) {
        lines << tilt;
    }
    if (swing.fit.hysteresis) {
        lines << CalibrationWords::tr("Turning clockwise, the sensor reads %1 more than turning back.")
                     .arg(estimateText(*swing.fit.hysteresis));
    }
    for (const QString& hint : swing.fit.hints) {
        lines << hint;
    }
    return lines.join(QLatin1Char('\n'));
}

QString trueAzimuthText(const SensorStatus& sensor)
{
    if (!sensor.direction) {
        return noValue();
    }
    const QString azimuth = azimuthText(sensor.direction->azimuth, 1);
    return sensor.azimuthSigma ? QStringLiteral("%1 ± %2").arg(azimuth, angleText(*sensor.azimuthSigma, 1)) : azimuth;
}

bool proposesFit(const CalibrationStatus& calibration)
{
    if (!calibration.proposal || !calibration.fit) {
        return false;
    }
    return std::ranges::equal(calibration.proposal->terms, calibration.fit->terms,
                              [](const auto& one, const auto& fit) {
                                  return one.key == fit.key && abs((one.proposed - fit.proposed).wrapped180()) <= kSame;
                              });
}

// Contains the rms before and after the proposal. If the proposal is not the fit of the points, the text also contains
// the rms of the fit.
QString fitText(const CalibrationStatus& calibration)
{
    if (!calibration.fit) {
        return noFitText(calibration);
    }
    const PointFitStatus& fit = *calibration.fit;
    const QString points = pointsText(calibration.points);
    const QString terms = termsText(fit.terms);
    const QString before = angleText(fit.before, 3);
    const QString after = angleText(fit.after, 3);
    QString text;
    if (proposesFit(calibration)) {
        text = QStringLiteral("%1, %2: ").arg(points, terms) + CalibrationWords::tr("rms %1 → %2").arg(before, after);
    } else if (calibration.proposal && calibration.proposal->residuals) {
        text = CalibrationWords::tr("%1: rms now %2, with the proposal %3, with the best fit of these points %5 (%4)")
                   .arg(points, before, angleText(calibration.proposal->residuals->after, 3), terms, after);
    } else {
        text = CalibrationWords::tr("%1: rms now %2, with the best fit of these points %4 (%3)")
                   .arg(points, before, terms, after);
    }
    if (const auto leftOut = leftOutRms(calibration.points)) {
        text += CalibrationWords::tr(", each point predicted from the others %1").arg(angleText(*leftOut, 3));
    }
    if (fit.reducedChiSquare) {
        text += CalibrationWords::tr(", χ² %1").arg(twoDigits(*fit.reducedChiSquare));
    }
    return text;
}

double onSky(const PointResidual& residual)
{
    return std::hypot(residual.across.degrees(), residual.elevation.degrees());
}

QString sunWarning()
{
    return CalibrationWords::tr(
        "Never look into the Sun or along a sight tube. The Sun can burn the feed of a dish. Use the shadow and be "
        "quick.");
}

}  // namespace boresight::ui
