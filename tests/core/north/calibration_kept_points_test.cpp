// SPDX-License-Identifier: GPL-3.0-or-later
// Calibration points that are kept after a disconnect: which mount they belong to, and when they count again.
#include "core/alarms/catalogue.h"
#include "tests/core/north/calibration_sun.h"

#include <QTemporaryDir>

#include <cmath>

namespace boresight {
namespace {

using namespace boresight::literals;

// REQ-NORTH-37 (CalibrationPoints.*): The Sun or the Moon is tracked like the stream of a client and trimmed by nudges.
// After a swing and three centred Suns the beam is right to 0.15°, after six to 0.05°.
// REQ-NORTH-38h: The points survive a Reconnect and a restart of the program until they are dropped. The worker of the
// history also writes STATE_DIR/NAME.points.toml. If Boresight asked for the wrap of an axis since then, the proposal
// warns.
TEST(CalibrationPoints, ThePointsOutliveTheConnection)
{
    QTemporaryDir folder;
    std::vector<PointStatus> taken;
    {
        CalibrationRig rig({}, calibratedProfile(), folder.path());
        rig.goTo(200.0, 30.0);
        ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = {.azimuth = 10_deg, .elevation = 30_deg}, .label = {}}));
        rig.goTo(250.0, 30.0);
        ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = {.azimuth = 60_deg, .elevation = 30_deg}, .label = {}}));
        rig.run(Seconds(0.5));
        taken = rig.status().points;
    }
    {
        CalibrationRig again({}, calibratedProfile(), folder.path());
        ASSERT_EQ(2U, again.status().points.size());
        EXPECT_EQ(taken[1].when, again.status().points[1].when);
        EXPECT_NEAR(taken[1].axes.azimuth.degrees(), again.status().points[1].axes.azimuth.degrees(), 1e-8);
        ASSERT_TRUE(again.status().proposal);
        const std::vector<QString> warnings = again.status().proposal->warnings;
        for (const QString& warning : warnings) {
            EXPECT_FALSE(warning.contains(QStringLiteral("entered the cable wrap again")))
                << "the turns were known all the time";
        }
        ASSERT_TRUE(again.ask(request::DropAllPoints{}));
    }
    CalibrationRig dropped({}, calibratedProfile(), folder.path());
    EXPECT_TRUE(dropped.status().points.empty());
}

// The board of the azimuth drive is replaced by another one, which counts from wherever it woke up.
void replaceDrive(CalibrationRig& rig)
{
    rig.azimuth.silent = true;
    rig.run(Seconds(0.5));
    rig.mount.learn(Axis::Azimuth, std::nullopt);
    rig.run(Seconds(1.0));
    rig.azimuth.home = moteus::HomeState::Rotor;
    rig.azimuth.position = std::remainder(rig.azimuth.position, 0.01);
    rig.azimuth.mode = moteus::Mode::Stopped;
    rig.azimuth.silent = false;
    drive_check::DriveFacts other = rig.factsOf(Axis::Azimuth);
    other.uuid = QStringLiteral("a0000000-0000-0000-0000-000000000009");
    other.bootedAt = rig.clock.now();
    rig.learn(Axis::Azimuth, other);
    rig.run(Seconds(2.0));
}

// Stored points of a mast that was moved or of a drive that was replaced meanwhile.
// REQ-NORTH-38i: Stored points are in the list at once. They count when both drives have been read, even a drive that
// reports no UUID. Until then the page Model says what they wait for. Points of another drive, or of a site more than a
// kilometre away, are left out with an alarm until the operator uses them again. Missing information (no site, a silent
// drive) does not make the points foreign. A calibration that was undone before another was applied stays in the file.
TEST(CalibrationPoints, ThoseOfAnotherDriveOrSiteAreLeftOut)
{
    QTemporaryDir folder;
    const auto used = [](CalibrationRig& rig) {
        return std::ranges::count(rig.status().points, true, &PointStatus::isUsed);
    };
    const auto warned = [](CalibrationRig& rig) {
        return rig.control.alarms().active(alarmEntry("points.other-drive"));
    };
    {
        CalibrationRig rig({}, calibratedProfile(), folder.path());
        rig.goTo(200.0, 30.0);
        ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = {.azimuth = 10_deg, .elevation = 30_deg}, .label = {}}));
    }
    {
        CalibrationRig same({}, calibratedProfile(), folder.path());
        EXPECT_EQ(1, used(same));
        EXPECT_FALSE(warned(same));
        ASSERT_TRUE(same.status().proposal);
        replaceDrive(same);
        ASSERT_TRUE(same.control.isTurnAsked(Axis::Azimuth)) << "the journal does not know it before that is answered";
        EXPECT_EQ(0, used(same));
        EXPECT_EQ(1U, same.status().points.size()) << "they are not lost";
        EXPECT_FALSE(same.status().proposal);
        EXPECT_TRUE(warned(same));
        ASSERT_TRUE(same.ask(request::UsePoint{.index = 0, .used = true}));
        same.run(Seconds(0.5));
        EXPECT_EQ(1, used(same)) << "the operator knows better";
        EXPECT_FALSE(warned(same));
    }
    profile::Profile elsewhere = calibratedProfile();
    elsewhere.site.latitude = 47_deg;
    CalibrationRig moved({}, elsewhere, folder.path());
    EXPECT_EQ(0, used(moved));
    EXPECT_TRUE(warned(moved));
    EXPECT_FALSE(moved.status().proposal);
}

// Until a drive has reported its identity, it may be a different drive from the one of the stored points.
// REQ-NORTH-38i
TEST(CalibrationPoints, ThoseThatWereKeptWaitUntilTheDrivesAreKnown)
{
    CalibrationRig rig;
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = {.azimuth = 10_deg, .elevation = 30_deg}, .label = {}}));
    rig.mount.learn(Axis::Azimuth, std::nullopt);
    CalibrationDesk again(rig.control, rig.inForce, *rig.file, rig.clock, rig.log);
    again.tick();
    ASSERT_EQ(1U, again.status()->points.size());
    EXPECT_FALSE(again.status()->proposal);
    profile::Profile typed = rig.profile;
    typed.pointing.collimation = 0.5_deg;
    const auto before = rig.inForce.shared();
    rig.inForce.apply(typed);
    again.profileChanged(*before, *rig.inForce);
    again.tick();
    EXPECT_FALSE(again.status()->proposal);
    EXPECT_FALSE(again.status()->fit);
    rig.mount.learn(Axis::Azimuth, rig.factsOf(Axis::Azimuth));
    again.tick();
    EXPECT_TRUE(again.status()->proposal);
    EXPECT_TRUE(again.status()->points.front().isUsed);
}

// Story: with a drive whose firmware reports no UUID, the stored points waited for ever, and new points with them.
// REQ-NORTH-38i
TEST(CalibrationPoints, ThoseThatWereKeptCountWithADriveThatTellsNoUuid)
{
    CalibrationRig rig;
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = {.azimuth = 10_deg, .elevation = 30_deg}, .label = {}}));
    rig.mount.learn(Axis::Azimuth, std::nullopt);
    profile::Profile nearly = rig.profile;
    nearly.pointing.azimuthOffset = 169_deg;
    const profile::InForce nearlyInForce(nearly);
    CalibrationDesk again(rig.control, nearlyInForce, *rig.file, rig.clock, rig.log);
    again.tick();
    EXPECT_FALSE(again.status()->fit);
    EXPECT_TRUE(again.status()->noFit.contains(QStringLiteral("wait"))) << again.status()->noFit.toStdString();
    EXPECT_LT(abs(again.status()->points.front().before.across), 1_deg) << "By the model in force";
    drive_check::DriveFacts nameless = rig.factsOf(Axis::Azimuth);
    nameless.uuid.clear();
    rig.mount.learn(Axis::Azimuth, nameless);
    again.tick();
    EXPECT_TRUE(again.status()->fit);
    EXPECT_TRUE(again.status()->noFit.isEmpty());
    EXPECT_TRUE(again.status()->proposal);
    EXPECT_TRUE(again.status()->points.front().isUsed);
}

// Points that are taken after dropping the stored ones belong to the present mount.
// REQ-NORTH-38i
TEST(CalibrationPoints, WithThoseThatWaitedTheWaitingGoes)
{
    const calibration::CalibrationPoint point{.axes = {.azimuth = 200_deg, .elevation = 30_deg},
                                              .truth = {.azimuth = 10_deg, .elevation = 30_deg}};
    const auto isFitted = [&point](PointBook& book) {
        book.add(point);
        book.fit({}, calibration::TermKnowledge::usual());
        return book.fitted().has_value();
    };
    PointBook book;
    book.setWaiting(true);
    EXPECT_FALSE(isFitted(book));
    EXPECT_FALSE(book.problem().isEmpty());
    book.clear();
    EXPECT_TRUE(isFitted(book));
    EXPECT_TRUE(book.problem().isEmpty());
    book.setWaiting(true);
    ASSERT_TRUE(book.drop(0));
    EXPECT_TRUE(isFitted(book)) << "the last of them";
}

// Story: a point was dropped while the site was not known. From then on the other points belonged to no mount.
// REQ-NORTH-38i
TEST(CalibrationPoints, AreNotTornFromTheirSiteWhileNoneIsKnown)
{
    CalibrationRig rig;
    for (const double azimuth : {200.0, 250.0}) {
        rig.goTo(azimuth, 30.0);
        ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = rig.beam(), .label = {}}));
    }
    profile::Profile settings = rig.profile;
    settings.site.known = false;
    rig.setProfile(settings);
    ASSERT_TRUE(rig.ask(request::DropPoint{.index = 0}));
    settings.site.known = true;
    settings.site.latitude = 47_deg;
    rig.setProfile(settings);
    rig.run(Seconds(0.5));
    ASSERT_EQ(1U, rig.status().points.size());
    EXPECT_FALSE(rig.status().points.front().isUsed);
    EXPECT_TRUE(rig.control.alarms().active(alarmEntry("points.other-drive")));
    // New points belong to this place.
    ASSERT_TRUE(rig.ask(request::DropAllPoints{}));
    ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = rig.beam(), .label = {}}));
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.status().points.front().isUsed);
}

}  // namespace
}  // namespace boresight
