// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/calibration_proposal.h"

#include "core/base/text.h"
#include "core/profile/setting.h"
#include "core/station/sensor_curve.h"

#include <QStringList>

#include <algorithm>

namespace boresight {
namespace {

using calibration::indexOf;
using calibration::Term;
using calibration::valueOf;

// A tilt within this many of its sigmas is as good as none.
constexpr double kSignificant = 2.0;
// A north found less exactly than this is worth a warning: Gpredict's satellites need it to a few degrees.
constexpr Angle kPoorNorth = Angle::fromDegrees(3.0);

// A north that moves by less leaves a compass where it is.
constexpr Angle kSameNorth = Angle::fromDegrees(0.01);

constexpr std::array kTermTexts = {
    QT_TRANSLATE_NOOP("Text", "azimuth offset"), QT_TRANSLATE_NOOP("Text", "elevation offset"),
    QT_TRANSLATE_NOOP("Text", "tilt north"),     QT_TRANSLATE_NOOP("Text", "tilt east"),
    QT_TRANSLATE_NOOP("Text", "collimation"),    QT_TRANSLATE_NOOP("Text", "non-perpendicularity"),
    QT_TRANSLATE_NOOP("Text", "elevation sag")};
static_assert(kTermTexts.size() == calibration::kTerms);

QString degreesText(Angle angle, int decimals = 2)
{
    return QString::number(angle.degrees(), 'f', decimals) + QStringLiteral("°");
}

QString northText(const calibration::Estimate& north)
{
    return Text::tr("the azimuth axis shows 0° at a true azimuth of %1 ± %2")
        .arg(degreesText(north.value), degreesText(north.sigma, 1));
}

// The offset of the azimuth may be any turn of it; the one that is nearest to today's moves no other number.
Angle nearestOffset(Angle north, const profile::Profile& profile)
{
    const Angle near = north.nearestTo(profile.pointing.azimuthOffset);
    return abs(near) < Angle::fromTurns(1.0) ? near : near.wrapped180();
}

void setNorth(Proposal& proposal, const calibration::Estimate& north, const profile::Profile& profile)
{
    proposal.terms = profile.pointing;
    proposal.terms.azimuthOffset = nearestOffset(north.value, profile);
    proposal.sigmas[indexOf(Term::AzimuthOffset)] = north.sigma;
    if (north.sigma > kPoorNorth) {
        proposal.warnings.push_back(
            Text::tr("north is known to %1 only: Sun or Moon will tell it better").arg(degreesText(north.sigma, 1)));
    }
}

void setTilt(Proposal& proposal, const calibration::AxisTilt& tilt)
{
    if (tilt.size < tilt.sizeSigma * kSignificant) {
        return;
    }
    proposal.terms.tiltNorth = tilt.north.value;
    proposal.terms.tiltEast = tilt.east.value;
    proposal.sigmas[indexOf(Term::TiltNorth)] = tilt.north.sigma;
    proposal.sigmas[indexOf(Term::TiltEast)] = tilt.east.sigma;
    proposal.text += Text::tr("; the azimuth axis leans by %1 ± %2 towards %3")
                         .arg(degreesText(tilt.size), degreesText(tilt.sizeSigma), degreesText(tilt.direction, 0));
}

// Told, not proposed: a box that lies askew on the boom says the same as an axis whose zero is wrong.
QString zeroText(const calibration::Estimate& zero)
{
    return Text::tr(
               "; where the elevation axis shows 0° the sensor says %1 ± %2 (not proposed: the box may lie askew on "
               "the boom; Sun or Moon tell the zero)")
        .arg(degreesText(zero.value), degreesText(zero.sigma, 1));
}

}  // namespace

Proposal proposalOf(const calibration::SensorOffset& offset, const profile::Profile& profile)
{
    Proposal proposal{.title = Text::tr("North from the sensor"),
                      .reason = Text::tr("still sensor"),
                      .text = northText(offset.offset)};
    setNorth(proposal, offset.offset, profile);
    return proposal;
}

Proposal proposalOf(const SwingOutcome& swing, const profile::Profile& profile)
{
    Proposal proposal{.title = Text::tr("North from the compass swing"),
                      .reason = Text::tr("compass swing"),
                      .text = northText(swing.fit.north)};
    setNorth(proposal, swing.fit.north, profile);
    if (swing.tilt) {
        setTilt(proposal, *swing.tilt);
        proposal.text += zeroText(swing.tilt->elevationOffset);
    }
    calibration::SensorMounting mounting = mountingOf(profile.sensor);
    mounting.sense = swing.fit.curve.sense;
    mounting.azimuthOffset = {};  // the box is along the boom, as far as a swing can tell
    mounting.curve = swing.fit.curve;
    mounting.curve->constant = {};
    proposal.sensor = mounting;
    for (const std::string& hint : swing.fit.hints) {
        proposal.warnings.push_back(toQString(hint));
    }
    return proposal;
}

Proposal proposalOf(const calibration::PointingFit& fit, std::span<const calibration::CalibrationPoint> points,
                    const profile::Profile& profile)
{
    const auto used = std::ranges::count_if(points, &calibration::CalibrationPoint::isUsed);
    Proposal proposal{.title = used == 1 ? Text::tr("Pointing model from 1 point")
                                         : Text::tr("Pointing model from %1 points").arg(used),
                      .reason = Text::tr("points"),
                      .text = changeText(profile.pointing, fit.terms),
                      .terms = fit.terms,
                      .points = {points.begin(), points.end()}};
    proposal.terms.azimuthOffset = nearestOffset(fit.terms.azimuthOffset, profile);
    for (const Term term : calibration::kAllTerms) {
        if (fit.of(term).state != calibration::TermState::Off) {
            proposal.sigmas[indexOf(term)] = fit.of(term).estimate.sigma;
        }
    }
    // The compass was swung against the north of then.
    const calibration::SensorMounting mounting = mountingOf(profile.sensor);
    if (mounting.curve) {
        proposal.sensor =
            withNorthMoved(mounting, (fit.terms.azimuthOffset - profile.pointing.azimuthOffset).wrapped180(),
                           fit.of(Term::AzimuthOffset).estimate.sigma);
    }
    for (const std::string& hint : fit.hints) {
        proposal.warnings.push_back(toQString(hint));
    }
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
        proposal.warnings.push_back(Text::tr("the sensor keeps the north of its swing: sensor and axes will then "
                                             "differ by about %1")
                                        .arg(degreesText(moved)));
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
            problems << QStringLiteral("%1: %2").arg(toQString(term.key), toQString(fits.error().text));
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
        warnings.push_back(Text::tr("the text is of another mount: \"%1\"").arg(toQString(sheet.mountName)));
    }
    const auto otherDrive = [](const std::string& then, const std::string& now) {
        return difference({.azimuthDrive = then}, {.azimuthDrive = now}) == MountDifference::OtherDrive;
    };
    if (otherDrive(sheet.mount.azimuthDrive, today.mount.azimuthDrive)) {
        warnings.push_back(Text::tr("the text is of another azimuth drive: where its axis shows 0° may differ"));
    }
    if (otherDrive(sheet.mount.elevationDrive, today.mount.elevationDrive)) {
        warnings.push_back(Text::tr("the text is of another elevation drive: where its axis shows 0° may differ"));
    }
    if (difference({.site = sheet.mount.site}, {.site = today.mount.site}) == MountDifference::OtherSite) {
        warnings.push_back(Text::tr("the text is of another site: north and tilt may differ"));
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

QString changeText(const pointing::PointingTerms& before, const pointing::PointingTerms& after)
{
    QStringList changes;
    for (const Term term : calibration::kAllTerms) {
        const Angle was = valueOf(before, term);
        const Angle is = valueOf(after, term);
        if (was != is) {
            changes << QStringLiteral("%1 %2 → %3")
                           .arg(Text::of(kTermTexts[indexOf(term)]), degreesText(was), degreesText(is));
        }
    }
    return changes.isEmpty() ? Text::tr("nothing changes") : changes.join(QStringLiteral(", "));
}

}  // namespace boresight
