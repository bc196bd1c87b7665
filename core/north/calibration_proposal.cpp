// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_proposal.h"

#include "core/base/text.h"
#include "core/calibration/fit_words.h"
#include "core/cross_check/sensor_curve.h"
#include "core/profile/setting.h"
#include "core/units/degrees_text.h"

#include <QStringList>

#include <algorithm>

namespace boresight {
namespace {

using calibration::indexOf;
using calibration::Term;
using calibration::valueOf;

// A tilt within this many of its sigmas counts as none.
constexpr double kSignificant = 2.0;
// The largest correction of an axis zero that the profile permits.
constexpr Angle kMostZero = Angle::fromDegrees(10.0);
// A warning follows if north is known less exactly than this. Tracking satellites of Gpredict needs a few degrees.
constexpr Angle kPoorNorth = Angle::fromDegrees(3.0);

// If two values differ by more than this many of their joint sigmas, they contradict each other.
constexpr double kContradicts = 3.0;
// If north moves by less than this, the sensor's offset stays unchanged.
constexpr Angle kSameNorth = Angle::fromDegrees(0.01);

constexpr std::array kTermTexts = {
    QT_TRANSLATE_NOOP("Text", "azimuth offset"), QT_TRANSLATE_NOOP("Text", "elevation offset"),
    QT_TRANSLATE_NOOP("Text", "tilt north"),     QT_TRANSLATE_NOOP("Text", "tilt east"),
    QT_TRANSLATE_NOOP("Text", "collimation"),    QT_TRANSLATE_NOOP("Text", "non-perpendicularity"),
    QT_TRANSLATE_NOOP("Text", "elevation sag")};
static_assert(kTermTexts.size() == calibration::kTerms);

QString northText(const calibration::Estimate& north)
{
    return Text::tr("The azimuth axis shows 0° at a true azimuth of %1 ± %2")
        .arg(azimuthText(north.value, 2), degreesText(north.sigma, 1));
}

// The offset of azimuth may be on any turn. The turn nearest to the present value changes no other number.
Angle nearestOffset(Angle north, const profile::Profile& profile)
{
    const Angle near = north.nearestTo(profile.pointing.azimuthOffset);
    return abs(near) < Angle::fromTurns(1.0) ? near : near.wrapped180();
}

// How a term in force relates to the value that was found.
enum class Standing
{
    Replaced,
    Stays,        // points gave it more exactly
    Contradicted  // points gave it, but it cannot be true any more
};

Standing standingOf(const std::optional<Angle>& told, Angle sigma, Angle apart)
{
    if (!told || *told >= sigma) {
        return Standing::Replaced;
    }
    return apart > calibration::hypot(*told, sigma) * kContradicts ? Standing::Contradicted : Standing::Stays;
}

void setStays(Proposal& proposal, const QString& what)
{
    proposal.stays += proposal.stays.isEmpty() ? what : QLatin1Char(' ') + what;
}

void setNorth(Proposal& proposal, const calibration::Estimate& north, const profile::Profile& profile)
{
    proposal.terms.azimuthOffset = nearestOffset(north.value, profile);
    proposal.sigmas[indexOf(Term::AzimuthOffset)] = north.sigma;
    if (north.sigma > kPoorNorth) {
        proposal.warnings.push_back(Text::tr("North is known only to %1. Use the Sun or the Moon for a better value.")
                                        .arg(degreesText(north.sigma, 1)));
    }
}

// An operator who moved the mount needs the north that was found, and gets it. If iron came near the compass, the
// warning explains the difference.
void warnOfNorth(Proposal& proposal, Angle apart)
{
    proposal.warnings.push_back(
        Text::tr("The compass and the north in force differ by %1. Their errors do not explain this. If the mount was "
                 "moved or slipped, press Apply. If iron came near, remove it and measure again.")
            .arg(degreesText(apart, 1)));
}

// True: north stays. False: the north of the compass is proposed.
bool keepsNorth(Proposal& proposal, const calibration::Estimate& north, const profile::Profile& profile,
                const std::optional<Angle>& told)
{
    proposal.terms = profile.pointing;
    const Angle apart = abs((north.value - profile.pointing.azimuthOffset).wrapped180());
    const Standing standing = standingOf(told, north.sigma, apart);
    if (standing == Standing::Stays) {
        setStays(proposal, Text::tr("North stays unchanged. It is known to %1, by compass only to %2.")
                               .arg(degreesText(*told, 2), degreesText(north.sigma, 1)));
        return true;
    }
    setNorth(proposal, north, profile);
    if (standing == Standing::Contradicted) {
        warnOfNorth(proposal, apart);
    }
    return false;
}

// How well the two parts of the tilt are known. Empty unless both are.
std::optional<Angle> tiltTold(const TermSigmas& told)
{
    const auto& north = told[indexOf(Term::TiltNorth)];
    const auto& east = told[indexOf(Term::TiltEast)];
    return north && east ? std::optional(std::max(*north, *east)) : std::nullopt;
}

void setTilt(Proposal& proposal, const calibration::AxisTilt& tilt, const std::optional<Angle>& told)
{
    if (tilt.size < tilt.sizeSigma * kSignificant) {
        return;
    }
    const Angle apart =
        calibration::hypot(tilt.north.value - proposal.terms.tiltNorth, tilt.east.value - proposal.terms.tiltEast);
    // The sigma of the parts, not of the size: a roll of the box turns one part into the other and leaves the size
    // unchanged.
    const Angle sigma = std::max(tilt.north.sigma, tilt.east.sigma);
    const Standing standing = standingOf(told, sigma, apart);
    if (standing == Standing::Stays) {
        setStays(proposal, Text::tr("The tilt stays unchanged. It is known to %1, by a swing only to %2.")
                               .arg(degreesText(*told, 2), degreesText(sigma, 2)));
        return;
    }
    if (standing == Standing::Contradicted) {
        proposal.warnings.push_back(
            Text::tr("The tilt of the mast differs by %1 from the tilt in force. Check that the mast is firm.")
                .arg(degreesText(apart, 2)));
    }
    proposal.terms.tiltNorth = tilt.north.value;
    proposal.terms.tiltEast = tilt.east.value;
    proposal.sigmas[indexOf(Term::TiltNorth)] = tilt.north.sigma;
    proposal.sigmas[indexOf(Term::TiltEast)] = tilt.east.sigma;
    proposal.text +=
        Text::tr(". The azimuth axis leans by %1 ± %2 towards %3")
            .arg(degreesText(tilt.size, 2), degreesText(tilt.sizeSigma, 2), azimuthText(tilt.direction, 0));
}

// Decides whether a difference between the elevation of the sensor and that of the beam is an error of the sensor or of
// the axis. A sensor that is mounted at an angle explains a small difference. After the Sun or the Moon has given the
// zero of the axis, every difference is an error of the sensor. Otherwise a larger difference is an error of the axis
// (core/calibration/METHOD.md, Tilt).
void setZero(Proposal& proposal, calibration::SensorMounting& mounting, const calibration::Estimate& zero,
             const pointing::PointingTerms& present, const std::optional<Angle>& presentSigma)
{
    const Angle beam =
        zero.value + mounting.elevationOffset;  // the elevation at which the axis shows 0°, by the sensor
    const Angle off = abs(beam - present.elevationOffset);
    const bool isKnown = presentSigma && *presentSigma < zero.sigma;
    const bool isSensors = isKnown || off <= zero.sigma * kSignificant;
    QString verdict;
    if (off > kMostZero || (!isSensors && abs(beam) > kMostZero)) {
        verdict = Text::tr(
            "This is too much to correct. Check how the sensor sits on the boom and what the elevation axis shows.");
        proposal.warnings.push_back(Text::tr("Sensor and elevation axis differ by %1.").arg(degreesText(off, 1)));
    } else if (isSensors) {
        mounting.elevationOffset = present.elevationOffset - zero.value;
        verdict = Text::tr("Boresight treats this as a tilted sensor. The elevation of the beam stays unchanged.");
    } else {
        proposal.terms.elevationOffset = beam;
        proposal.sigmas[indexOf(Term::ElevationOffset)] = zero.sigma;
        verdict = Text::tr("This is more than a tilted sensor. The zero of the elevation axis is wrong.");
        proposal.warnings.push_back(
            Text::tr("The zero of elevation moves by %1. First check that the sensor lies along the boom.")
                .arg(degreesText(off, 1)));
    }
    proposal.text += Text::tr(". At 0° of the elevation axis the sensor reports %1 ± %2. %3")
                         .arg(degreesText(zero.value, 2), degreesText(zero.sigma, 1), verdict);
}

// Points check a zero that was set with a level. Once points gave the zero, it is no longer that of a level.
QString levelText(const calibration::FittedTerm& zero, Angle present, const std::optional<Angle>& told)
{
    if (told || zero.state != calibration::TermState::Fitted) {
        return {};
    }
    const Angle off = abs(zero.estimate.value - present);
    return off < zero.estimate.sigma * kSignificant
               ? Text::tr("Your level is right to %1.").arg(degreesText(zero.estimate.sigma, 2))
               : Text::tr("Your level is off by %1 ± %2.")
                     .arg(degreesText(off, 2), degreesText(zero.estimate.sigma, 2));
}

}  // namespace

Proposal proposalOf(const calibration::SensorOffset& offset, const profile::Profile& profile, const TermSigmas& told)
{
    Proposal proposal{.title = Text::tr("North from the sensor"),
                      .reason = Text::tr("still sensor"),
                      .text = northText(offset.offset)};
    if (keepsNorth(proposal, offset.offset, profile, told[indexOf(Term::AzimuthOffset)])) {
        proposal.title = Text::tr("Offset of the sensor");
        const Angle correction = (profile.pointing.azimuthOffset - offset.offset.value).wrapped180();
        proposal.sensor = withNorthMoved(mountingOf(profile.sensor), correction, offset.offset.sigma);
        if (proposal.sensor->curve) {
            proposal.warnings.push_back(
                Text::tr("The sensor will agree at this heading only. A new swing corrects all headings."));
        }
    }
    if (!offset.isReliableHere) {
        proposal.doubts.push_back(
            Text::tr("Steel disturbs the compass at this heading (result of the swing). Measure at another heading."));
    }
    return proposal;
}

Proposal proposalOf(const SwingOutcome& swing, const profile::Profile& profile, const TermSigmas& told)
{
    Proposal proposal{.title = Text::tr("North from the compass swing"),
                      .reason = Text::tr("compass swing"),
                      .text = northText(swing.fit.north)};
    const auto& northTold = told[indexOf(Term::AzimuthOffset)];
    const bool northStays = keepsNorth(proposal, swing.fit.north, profile, northTold);
    calibration::SensorMounting mounting = mountingOf(profile.sensor);
    if (swing.tilt) {
        setTilt(proposal, *swing.tilt, tiltTold(told));
        setZero(proposal, mounting, swing.tilt->elevationOffset, profile.pointing,
                told[indexOf(Term::ElevationOffset)]);
    }
    mounting.sense = swing.fit.curve.sense;
    mounting.azimuthOffset = {};  // a swing cannot measure an offset between box and boom
    mounting.curve = swing.fit.curve;
    mounting.curve->constant = {};
    proposal.sensor = mounting;
    if (northStays) {
        proposal.title = Text::tr("Curve of the compass");
        proposal.sensor =
            withNorthMoved(mounting, (profile.pointing.azimuthOffset - swing.fit.north.value).wrapped180(),
                           calibration::hypot(*northTold, swing.fit.statistical));
    }
    proposal.warnings.insert(proposal.warnings.end(), swing.fit.hints.begin(), swing.fit.hints.end());
    return proposal;
}

Proposal proposalOf(const calibration::PointingFit& fit, std::span<const calibration::CalibrationPoint> points,
                    const profile::Profile& profile, const TermSigmas& told)
{
    const auto used = std::ranges::count_if(points, &calibration::CalibrationPoint::isUsed);
    Proposal proposal{.title = used == 1 ? Text::tr("Pointing model from 1 point")
                                         : Text::tr("Pointing model from %1 points").arg(used),
                      .reason = Text::tr("points"),
                      .text = changeText(profile.pointing, fit.terms),
                      .remark = levelText(fit.of(Term::ElevationOffset), profile.pointing.elevationOffset,
                                          told[indexOf(Term::ElevationOffset)]),
                      .terms = fit.terms,
                      .points = {points.begin(), points.end()}};
    proposal.terms.azimuthOffset = nearestOffset(fit.terms.azimuthOffset, profile);
    for (const Term term : calibration::kAllTerms) {
        if (fit.of(term).state != calibration::TermState::Off) {
            proposal.sigmas[indexOf(term)] = fit.of(term).estimate.sigma;
        }
    }
    // The curve is about the north that was in force when the compass was swung.
    const calibration::SensorMounting mounting = mountingOf(profile.sensor);
    if (mounting.curve) {
        proposal.sensor =
            withNorthMoved(mounting, (fit.terms.azimuthOffset - profile.pointing.azimuthOffset).wrapped180(),
                           fit.of(Term::AzimuthOffset).estimate.sigma);
    }
    proposal.warnings.insert(proposal.warnings.end(), fit.hints.begin(), fit.hints.end());
    return proposal;
}

Proposal proposalOf(const GivenTerms& given, const profile::Profile& profile)
{
    Proposal proposal{.title = given.title,
                      .reason = given.reason,
                      .text = changeText(profile.pointing, given.terms),
                      .warnings = given.warnings,
                      .terms = given.terms,
                      .sigmas = given.sigmas};
    const Angle moved = abs((given.terms.azimuthOffset - profile.pointing.azimuthOffset).wrapped180());
    if (mountingOf(profile.sensor).curve && moved > kSameNorth) {
        proposal.warnings.push_back(
            Text::tr("The sensor keeps the north of its swing. Sensor and axes will then differ by %1.")
                .arg(degreesText(moved, 2)));
    }
    return proposal;
}

Result<pointing::PointingTerms> asSettings(const pointing::PointingTerms& terms)
{
    profile::Profile profile;
    QStringList problems;
    for (const TermStatus& term : termsBeside({}, terms)) {
        const profile::Setting& setting = *profile::findSetting(term.key);
        if (const Result<> fits = setting.set(profile, term.proposed.degrees()); !fits) {
            problems << QStringLiteral("%1: %2").arg(toQString(term.key), fits.error().text);
        }
    }
    if (!problems.isEmpty()) {
        return failure(ErrorCode::OutOfRange, problems.join(QStringLiteral("; ")));
    }
    return profile.pointing;
}

std::vector<QString> otherMountWarnings(const calibration::TermSheet& sheet, const calibration::TermSheet& today)
{
    using calibration::difference;
    using calibration::MountDifference;
    std::vector<QString> warnings;
    if (!sheet.mountName.empty() && sheet.mountName != today.mountName) {
        warnings.push_back(Text::tr("The text belongs to another mount: \"%1\".").arg(toQString(sheet.mountName)));
    }
    const auto otherDrive = [](const std::string& then, const std::string& now) {
        return difference({.azimuthDrive = then}, {.azimuthDrive = now}) == MountDifference::OtherDrive;
    };
    if (otherDrive(sheet.mount.azimuthDrive, today.mount.azimuthDrive)) {
        warnings.push_back(Text::tr("The text belongs to another azimuth drive. The zero of its axis may differ."));
    }
    if (otherDrive(sheet.mount.elevationDrive, today.mount.elevationDrive)) {
        warnings.push_back(Text::tr("The text belongs to another elevation drive. The zero of its axis may differ."));
    }
    if (difference({.site = sheet.mount.site}, {.site = today.mount.site}) == MountDifference::OtherSite) {
        warnings.push_back(Text::tr("The text belongs to another site. North and tilt may differ."));
    }
    return warnings;
}

std::vector<TermStatus> termsBeside(const pointing::PointingTerms& present, const pointing::PointingTerms& proposed)
{
    std::vector<TermStatus> list;
    for (const Term term : calibration::kAllTerms) {
        list.push_back({.key = "pointing." + std::string(calibration::nameOf(term)) + "_deg",
                        .present = valueOf(present, term),
                        .proposed = valueOf(proposed, term)});
    }
    return list;
}

QString changeText(const pointing::PointingTerms& before, const pointing::PointingTerms& after, bool changesSensor)
{
    QStringList changes;
    for (const Term term : calibration::kAllTerms) {
        const Angle was = valueOf(before, term);
        const Angle is = valueOf(after, term);
        if (was != is) {
            changes << QStringLiteral("%1 %2 → %3")
                           .arg(Text::of(kTermTexts[indexOf(term)]), degreesText(was, 2), degreesText(is, 2));
        }
    }
    if (changesSensor) {
        changes << Text::tr("mounting or curve of the sensor");
    }
    return changes.isEmpty() ? Text::tr("nothing changes") : changes.join(QStringLiteral(", "));
}

}  // namespace boresight
