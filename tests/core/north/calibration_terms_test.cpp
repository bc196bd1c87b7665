// SPDX-License-Identifier: GPL-3.0-or-later
// Terms that are typed or read from a text, the exported text of the terms in effect, and the warnings about another
// drive or site.
#include "core/alarms/catalogue.h"
#include "tests/core/north/calibration_rig.h"
#include "tests/fakes/text_of.h"

#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

using ::testing::HasSubstr;

pointing::PointingTerms typed()
{
    return {.azimuthOffset = Angle::fromDegrees(37.4),
            .elevationOffset = Angle::fromDegrees(-0.25),
            .tiltNorth = Angle::fromDegrees(0.5),
            .tiltEast = Angle::fromDegrees(-0.4),
            .collimation = Angle::fromDegrees(0.3),
            .nonPerpendicularity = {},
            .elevationSag = Angle::fromDegrees(0.05)};
}

std::string textOf(const CalibrationStatus& status)
{
    return calibration::toText(status.sheet);
}

// Points over the whole sky, which determine most of the terms.
void takeLandmarks(CalibrationRig& rig)
{
    for (const double azimuth : {20.0, 80.0, 140.0, 200.0, 260.0, 320.0}) {
        for (const double elevation : {20.0, 60.0}) {
            rig.goTo(azimuth, elevation);
            ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = rig.beam(), .label = {}}));
        }
    }
    rig.tick();
}

bool isWarned(CalibrationRig& rig)
{
    return rig.control.alarms().active(alarmEntry("calibration.other-mount"));
}

// REQ-NORTH-38a (CalibrationTerms.*): Terms may be typed, or read from a text. They become a proposal like any other,
// with the residuals of the points before and after. Terms out of range are refused by name with the range. Terms of
// another mount, drive or site give a warning. A term that was not changed keeps its value and its sigma exactly. The
// terms in effect are shown with their sigmas and can be exported.
TEST(CalibrationTerms, WhatIsTypedIsProposedAppliedAndTakenBack)
{
    CalibrationRig rig;
    const profile::Profile before = rig.profile;
    ASSERT_TRUE(rig.ask(request::ProposeTerms{typed()}));
    rig.tick();
    ASSERT_TRUE(rig.status().proposal);
    EXPECT_EQ(QStringLiteral("typed"), rig.status().proposal->reason);
    EXPECT_EQ(QStringLiteral("Typed terms"), rig.status().proposal->title);
    EXPECT_TRUE(rig.status().proposal->text.contains(QStringLiteral("azimuth offset 0.00° → 37.40°")));
    EXPECT_FALSE(rig.status().proposal->residuals);
    EXPECT_FALSE(rig.status().proposal->changesSensor);
    EXPECT_EQ(before, rig.profile);  // nothing changes without Apply
    ASSERT_TRUE(rig.apply());
    EXPECT_NEAR(37.4, rig.terms().azimuthOffset.degrees(), 1e-12);
    EXPECT_NEAR(0.05, rig.terms().elevationSag.degrees(), 1e-12);
    rig.tick();
    ASSERT_EQ(1U, rig.status().history.size());
    EXPECT_EQ(QStringLiteral("Typed terms"), rig.status().history.front().title);
    const profile::Profile after = rig.profile;
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    EXPECT_EQ(before, rig.profile);
    ASSERT_TRUE(rig.ask(request::RedoCalibration{}));
    EXPECT_EQ(after, rig.profile);
}

// Story: a fit has more decimals than a profile keeps. One term was typed, and five counted as entered: "38.11° →
// 38.11°".
TEST(CalibrationTerms, WhatWasNotTypedKeepsItsValueAndItsSigma)
{
    CalibrationRig rig;
    takeLandmarks(rig);
    ASSERT_TRUE(rig.apply());
    rig.tick();
    const pointing::PointingTerms found = rig.terms();
    const auto sigma = rig.status().sheet.sigmas.at(0);
    ASSERT_TRUE(sigma);
    pointing::PointingTerms wanted = found;
    wanted.elevationSag = 0.3_deg;
    ASSERT_TRUE(rig.ask(request::ProposeTerms{wanted}));
    rig.tick();
    const auto proposal = rig.status().proposal;
    ASSERT_TRUE(proposal);
    EXPECT_EQ(1, std::ranges::count_if(proposal->terms, &TermStatus::isOn));
    EXPECT_TRUE(proposal->terms.at(6).isOn);
    EXPECT_FALSE(proposal->terms.at(6).sigma);
    EXPECT_EQ(sigma, proposal->terms.at(0).sigma);
    EXPECT_EQ(found.azimuthOffset, proposal->terms.at(0).proposed);
    ASSERT_TRUE(rig.apply());
    rig.tick();
    EXPECT_EQ(found.azimuthOffset, rig.terms().azimuthOffset);
    EXPECT_THAT(rig.status().history.front().change.toStdString(), ::testing::StartsWith("elevation sag "));
    EXPECT_EQ(sigma, rig.status().sheet.sigmas.at(0));
    EXPECT_FALSE(rig.status().sheet.sigmas.at(6));
}

// Story: five points were fitted, and a typed term was applied and undone. The fit could not be applied any more.
// REQ-NORTH-38f
TEST(CalibrationTerms, AfterUndoThePointsAreProposedAgainIfTheySayOtherwise)
{
    CalibrationRig rig;
    takeLandmarks(rig);
    ASSERT_TRUE(rig.ask(request::ProposeTerms{typed()}));
    rig.tick();
    ASSERT_TRUE(rig.apply());
    rig.tick();
    EXPECT_FALSE(rig.status().proposal) << "it is what the operator wants now";
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    rig.tick();
    ASSERT_TRUE(rig.status().proposal);
    EXPECT_EQ(QStringLiteral("points"), rig.status().proposal->reason);
    ASSERT_TRUE(rig.apply());
    EXPECT_NEAR(rig.truth.terms.azimuthOffset.degrees(), rig.terms().azimuthOffset.degrees(), 0.1);
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    rig.tick();
    EXPECT_TRUE(rig.status().proposal) << "what the points say is not in force";
    ASSERT_TRUE(rig.ask(request::RedoCalibration{}));
    rig.tick();
    EXPECT_FALSE(rig.status().proposal) << "it is";
}

// Story: north was set by hand in the guide, and the history still showed the earlier north as in effect.
// REQ-NORTH-38f
TEST(CalibrationTerms, WhatWasChangedByHandSinceIsTold)
{
    CalibrationRig rig;
    ASSERT_TRUE(rig.ask(request::ProposeTerms{typed()}));
    rig.tick();
    ASSERT_TRUE(rig.apply());
    rig.tick();
    EXPECT_EQ(QStringLiteral("Typed terms"), rig.status().history.front().title);
    profile::Profile changed = rig.profile;
    changed.pointing.azimuthOffset = 338.7_deg;
    rig.setProfile(changed);
    rig.tick();
    EXPECT_EQ(QStringLiteral("Typed terms, changed by hand since"), rig.status().history.front().title);
    EXPECT_THAT(rig.status().history.front().change.toStdString(),
                HasSubstr("Changed by hand after that: azimuth offset 37.40° → 338.70°"));
    EXPECT_TRUE(rig.status().history.front().inForce);
}

// Story: earlier knowledge of a term had the same weight as the points, and the page called the term found.
TEST(CalibrationTerms, WhatIsOnlyHeldIsNotCalledFound)
{
    CalibrationRig rig;
    for (const double azimuth : {40.0, 75.0, 110.0}) {
        rig.goTo(azimuth, 30.0 + azimuth / 10.0);
        ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = rig.beam(), .label = {}}));
    }
    rig.tick();
    const auto proposal = rig.status().proposal;
    ASSERT_TRUE(proposal);
    const auto held = [](const TermStatus& term) { return !term.isOn && term.sigma && term.proposed != term.present; };
    EXPECT_TRUE(proposal->terms.at(0).isOn);
    EXPECT_GT(std::ranges::count_if(proposal->terms, held), 0) << "three points determine not all that they move";
    EXPECT_EQ(std::ranges::count_if(proposal->terms, &TermStatus::isOn),
              std::ranges::count_if(rig.status().fit->terms, &TermStatus::isOn));
}

TEST(CalibrationTerms, TheyAreShownBesideThePoints)
{
    CalibrationRig rig;
    rig.goTo(100.0, 30.0);
    ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = rig.beam(), .label = {}}));
    rig.goTo(220.0, 50.0);
    ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = rig.beam(), .label = {}}));
    ASSERT_TRUE(rig.ask(request::ProposeTerms{rig.truth.terms}));
    rig.tick();
    ASSERT_TRUE(rig.status().proposal);
    ASSERT_TRUE(rig.status().proposal->residuals);
    EXPECT_EQ(2U, rig.status().proposal->residuals->points);
    EXPECT_GT(rig.status().proposal->residuals->before, 20_deg);
    EXPECT_LT(rig.status().proposal->residuals->after, 0.001_deg);
    // A point that is left out does not count. The typed terms stay proposed when all points are gone.
    ASSERT_TRUE(rig.ask(request::UsePoint{.index = 0, .used = false}));
    ASSERT_TRUE(rig.ask(request::ProposeTerms{rig.truth.terms}));
    rig.tick();
    EXPECT_EQ(1U, rig.status().proposal->residuals->points);
    ASSERT_TRUE(rig.ask(request::DropAllPoints{}));
    rig.tick();
    ASSERT_TRUE(rig.status().proposal);
    EXPECT_EQ(QStringLiteral("typed"), rig.status().proposal->reason);
    EXPECT_FALSE(rig.status().proposal->residuals);
}

TEST(CalibrationTerms, WhatIsOutOfRangeIsNamedWithTheRange)
{
    CalibrationRig rig;
    pointing::PointingTerms wild = typed();
    wild.azimuthOffset = 400_deg;
    wild.tiltEast = -12_deg;
    const auto refused = rig.ask(request::ProposeTerms{wild});
    ASSERT_FALSE(refused);
    EXPECT_EQ(ErrorCode::OutOfRange, refused.error().code);
    EXPECT_EQ("pointing.azimuth_offset_deg: 400 is outside -360…360; pointing.tilt_east_deg: -12 is outside -10…10",
              textOf(refused.error()));
    wild = typed();
    wild.collimation = Angle::fromDegrees(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(rig.ask(request::ProposeTerms{wild}));
    rig.tick();
    EXPECT_FALSE(rig.status().proposal);
}

TEST(CalibrationTerms, WhatIsInForceAlreadyIsNoProposal)
{
    CalibrationRig rig;
    EXPECT_FALSE(rig.ask(request::ProposeTerms{rig.terms()}));
}

TEST(CalibrationTerms, AProfileThatCouldNotBeLoadedIsRefused)
{
    profile::Profile profile = calibratedProfile();
    profile.limits.keepOuts.push_back(
        {.name = "mast", .azimuthFrom = 40_deg, .azimuthTo = 60_deg, .elevationMin = 0_deg, .elevationMax = 20_deg});
    CalibrationRig rig({}, profile);
    pointing::PointingTerms terms;
    terms.azimuthOffset = 50_deg;  // the park position would lie in the keep-out
    ASSERT_TRUE(rig.ask(request::ProposeTerms{terms}));
    rig.tick();
    const auto refused = rig.apply();
    ASSERT_FALSE(refused);
    EXPECT_THAT(textOf(refused.error()), HasSubstr("park position would then be forbidden"));
    EXPECT_THAT(textOf(refused.error()), HasSubstr("Set another one first"));
}

TEST(CalibrationTerms, TheSensorKeepsItsNorthAndThatIsSaid)
{
    profile::Profile profile = calibratedProfile();
    profile.sensor.deviation.a1 = 8_deg;
    CalibrationRig rig({}, profile);
    ASSERT_TRUE(rig.ask(request::ProposeTerms{typed()}));
    rig.tick();
    ASSERT_EQ(1U, rig.status().proposal->warnings.size());
    EXPECT_TRUE(rig.status().proposal->warnings.front().contains(QStringLiteral("37.40°")));
    ASSERT_TRUE(rig.apply());
    EXPECT_EQ(profile.sensor, rig.profile.sensor);
}

TEST(CalibrationTerms, AreExportedAndReadAgain)
{
    CalibrationRig rig;
    ASSERT_TRUE(rig.ask(request::ProposeTerms{typed()}));
    rig.tick();
    ASSERT_TRUE(rig.apply());
    rig.tick();
    const std::string text = textOf(rig.status());
    EXPECT_THAT(text, HasSubstr("# mount: Boresight mount\n"));
    EXPECT_THAT(text, HasSubstr("# azimuth drive: a0000000-0000-0000-0000-000000000001\n"));
    EXPECT_THAT(text, HasSubstr("# site: 48.2"));
    const pointing::PointingTerms exported = rig.terms();
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    ASSERT_TRUE(rig.ask(request::ImportTerms{.name = QStringLiteral("roof.terms"), .text = text}));
    rig.tick();
    EXPECT_EQ(QStringLiteral("Terms from roof.terms"), rig.status().proposal->title);
    EXPECT_TRUE(rig.status().proposal->warnings.empty());
    ASSERT_TRUE(rig.apply());
    EXPECT_EQ(exported, rig.terms());
}

TEST(CalibrationTerms, SigmasGoWithTheTermThatTheyBelongTo)
{
    CalibrationRig rig;
    std::string text = calibration::toText({.terms = typed()});
    const std::string tilt = "tilt_north            0.500000000    deg  ";
    ASSERT_THAT(text, HasSubstr(tilt + "-"));
    text.replace(text.find(tilt) + tilt.size(), 1, "0.02");
    ASSERT_TRUE(rig.ask(request::ImportTerms{.name = QStringLiteral("roof.terms"), .text = text}));
    rig.tick();
    ASSERT_TRUE(rig.status().proposal->terms.at(2).sigma);
    EXPECT_NEAR(0.02, rig.status().proposal->terms.at(2).sigma->degrees(), 1e-12);
    ASSERT_TRUE(rig.apply());
    pointing::PointingTerms other = rig.terms();
    other.azimuthOffset += 1_deg;
    ASSERT_TRUE(rig.ask(request::ProposeTerms{other}));
    rig.tick();
    ASSERT_TRUE(rig.apply());
    rig.tick();
    EXPECT_THAT(textOf(rig.status()), HasSubstr(tilt + "0.020000000"));
    other.tiltNorth += 1_deg;
    ASSERT_TRUE(rig.ask(request::ProposeTerms{other}));
    rig.tick();
    ASSERT_TRUE(rig.apply());
    rig.tick();
    EXPECT_THAT(textOf(rig.status()), HasSubstr("tilt_north            1.500000000    deg  -"));
}

TEST(CalibrationTerms, ATextOfAnotherMountWarns)
{
    CalibrationRig rig;
    rig.tick();
    calibration::TermSheet sheet{
        .mountName = "Barn",
        .when = {},
        .mount = {.azimuthDrive = "b0000000-0000-0000-0000-000000000001",
                  .elevationDrive = "b0000000-0000-0000-0000-000000000002",
                  .site = calibration::RecordSite{.latitude = 47_deg, .longitude = 16.37_deg, .heightMetres = 200.0}},
        .terms = typed(),
        .sigmas = {}};
    ASSERT_TRUE(
        rig.ask(request::ImportTerms{.name = QStringLiteral("barn.terms"), .text = calibration::toText(sheet)}));
    rig.tick();
    ASSERT_EQ(4U, rig.status().proposal->warnings.size());
    EXPECT_TRUE(rig.status().proposal->warnings.at(0).contains(QStringLiteral("\"Barn\"")));
    EXPECT_TRUE(rig.status().proposal->warnings.at(1).contains(QStringLiteral("azimuth drive")));
    EXPECT_TRUE(rig.status().proposal->warnings.at(2).contains(QStringLiteral("elevation drive")));
    EXPECT_TRUE(rig.status().proposal->warnings.at(3).contains(QStringLiteral("another site")));
    // Missing information in the text is no reason for a warning.
    sheet = {.terms = typed()};
    ASSERT_TRUE(
        rig.ask(request::ImportTerms{.name = QStringLiteral("bare.terms"), .text = calibration::toText(sheet)}));
    rig.tick();
    EXPECT_TRUE(rig.status().proposal->warnings.empty());
}

TEST(CalibrationTerms, ATextThatCannotBeReadIsRefusedWithTheLine)
{
    CalibrationRig rig;
    const auto refused =
        rig.ask(request::ImportTerms{.name = QStringLiteral("roof.terms"), .text = "azimuth_offset 37,4 deg\n"});
    ASSERT_FALSE(refused);
    EXPECT_THAT(textOf(refused.error()), HasSubstr("roof.terms:1: \"37,4\" is not a number."));
    rig.tick();
    EXPECT_FALSE(rig.status().proposal);
}

// The source of a typed tilt is unknown: it may come from these same points, so the fit must not use it as knowledge.
TEST(CalibrationTerms, AreNoKnowledgeForTheFit)
{
    CalibrationRig rig;
    calibration::TermSheet sheet{.terms = {.tiltNorth = 3_deg}};
    sheet.sigmas[calibration::indexOf(calibration::Term::TiltNorth)] = 0.001_deg;
    sheet.sigmas[calibration::indexOf(calibration::Term::TiltEast)] = 0.001_deg;
    ASSERT_TRUE(
        rig.ask(request::ImportTerms{.name = QStringLiteral("wrong.terms"), .text = calibration::toText(sheet)}));
    rig.tick();
    ASSERT_TRUE(rig.apply());
    takeLandmarks(rig);
    ASSERT_TRUE(rig.apply());
    EXPECT_NEAR(rig.truth.terms.tiltNorth.degrees(), rig.terms().tiltNorth.degrees(), 0.05);
}

// REQ-NORTH-38c: Terms in effect that were applied with another drive or at another site are amber until something is
// applied here.
TEST(CalibrationTerms, AnotherSiteWarnsUntilSomethingIsAppliedThere)
{
    CalibrationRig rig;
    ASSERT_TRUE(rig.ask(request::ProposeTerms{typed()}));
    rig.tick();
    ASSERT_TRUE(rig.apply());
    rig.run(Seconds(1.0));
    EXPECT_FALSE(isWarned(rig));
    EXPECT_FALSE(rig.status().history.front().otherMount);
    profile::Profile elsewhere = rig.profile;
    elsewhere.site.latitude = 47_deg;
    rig.setProfile(elsewhere);
    rig.run(Seconds(1.0));
    EXPECT_TRUE(isWarned(rig));
    EXPECT_TRUE(rig.status().otherMount.contains(QStringLiteral("\"Typed terms\"")));
    EXPECT_TRUE(rig.status().otherMount.endsWith(QStringLiteral("at another site")));
    EXPECT_TRUE(rig.status().history.front().otherMount);
    EXPECT_EQ(QStringLiteral("at another site"), rig.status().history.front().place);
    pointing::PointingTerms found = typed();
    found.azimuthOffset = 12_deg;
    ASSERT_TRUE(rig.ask(request::ProposeTerms{found}));
    rig.tick();
    ASSERT_TRUE(rig.apply());
    rig.run(Seconds(1.0));
    EXPECT_FALSE(isWarned(rig));
    EXPECT_TRUE(rig.status().otherMount.isEmpty());
}

// The program ends, a drive is replaced, and the program starts again.
// REQ-NORTH-38c
TEST(CalibrationTerms, AnotherDriveWarns)
{
    const QTemporaryDir folder;
    profile::Profile saved;
    {
        CalibrationRig rig({}, calibratedProfile(), folder.path());
        ASSERT_TRUE(rig.ask(request::ProposeTerms{typed()}));
        rig.tick();
        ASSERT_TRUE(rig.apply());
        saved = rig.profile;
    }
    CalibrationRig same({}, saved, folder.path());
    same.run(Seconds(1.0));
    EXPECT_FALSE(isWarned(same));
    drive_check::DriveFacts other = same.factsOf(Axis::Elevation);
    other.uuid = QStringLiteral("e0000000-0000-0000-0000-000000000009");
    same.learn(Axis::Elevation, other);
    same.run(Seconds(1.0));
    EXPECT_TRUE(isWarned(same));
    EXPECT_TRUE(same.status().otherMount.endsWith(QStringLiteral("with another drive")));
    EXPECT_EQ(QStringLiteral("with another drive"), same.status().history.front().place);
    // A change of the terms confirms the present mount.
    profile::Profile changed = same.profile;
    changed.pointing.azimuthOffset = 5_deg;
    same.setProfile(changed);
    same.run(Seconds(1.0));
    EXPECT_FALSE(isWarned(same));
}

// Story: a calibration with points of six hours of Sun was undone. When another was applied it disappeared from the
// file.
// REQ-NORTH-38i
TEST(CalibrationTerms, WhatWasTakenBackStaysToBeRead)
{
    CalibrationRig rig;
    const auto applies = [&rig](double north) {
        rig.run(Seconds(60.0));
        return rig.ask(request::ProposeTerms{{.azimuthOffset = Angle::fromDegrees(north)}}) && rig.apply();
    };
    ASSERT_TRUE(applies(10.0));
    ASSERT_TRUE(applies(20.0));
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    ASSERT_TRUE(applies(30.0));
    const auto history = rig.status().history;
    ASSERT_EQ(3U, history.size());
    EXPECT_TRUE(history[0].inForce);
    EXPECT_TRUE(history[1].superseded);
    EXPECT_FALSE(history[1].inForce);
    EXPECT_TRUE(history[1].change.contains(QStringLiteral("20.00°")));
    EXPECT_TRUE(history[2].inForce);
    EXPECT_FALSE(rig.status().canRedo);
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    EXPECT_NEAR(10.0, rig.terms().azimuthOffset.degrees(), 1e-9) << "not to what was taken back before";
}

}  // namespace
}  // namespace boresight
