// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/stored_mounts.h"

#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "tests/ui/profile/profile_fixture.h"

#include <QFile>

#include <algorithm>

namespace boresight::ui {
namespace {

using profile::Profile;

TEST_F(ProfilePageTest, AMountIsDuplicatedAsItIsApplied)
{
    Profile applied = roof;
    applied.jog.slow = 0.3_deg_s;  // not in the file yet
    put(applied);
    fromMenu("Duplicate …");
    ASSERT_TRUE(asks());
    type("Name of the new mount", "Garden");
    ASSERT_TRUE(says("The mount \"Garden\" is stored."));
    ASSERT_TRUE(comesTrue([this] { return mounts()->count() == 3; }));
    EXPECT_GE(mounts()->findText(QStringLiteral("Garden")), 0);
    const auto kept = store.list();
    ASSERT_EQ(kept.size(), 3u);
    EXPECT_EQ(profile::loadProfile(kept[1].path)->jog.slow, 0.3_deg_s);
    fromMenu("Duplicate …");
    type("Name of the new mount", "Field");
    EXPECT_TRUE(says("A mount \"Field\" already exists"));
    EXPECT_TRUE(requests.empty());
}

TEST_F(ProfilePageTest, AnotherMountIsRenamedInItsFileThisOneByAnEdit)
{
    choose("Field");
    fromMenu("Rename …");
    type("New name of the mount", "Meadow");
    ASSERT_TRUE(says("now called \"Meadow\""));
    EXPECT_EQ(profile::loadProfile(fieldFile)->mount.name, "Meadow");
    ASSERT_TRUE(comesTrue([this] { return mounts()->findText(QStringLiteral("Meadow")) >= 0; }));
    choose("Roof");
    fromMenu("Rename …");
    type("New name of the mount", "Tower");
    press("Apply");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    EXPECT_EQ(asked<request::ApplyProfile>().front().profile.mount.name, "Tower");
}

TEST_F(ProfilePageTest, OnlyAMountThatIsNotInForceIsRemovedAndItsFileIsKept)
{
    fromMenu("Remove …");
    EXPECT_TRUE(says("This mount is in use"));
    EXPECT_FALSE(page().isAsking());
    ASSERT_TRUE(store.setCurrent(roofFile));
    choose("Field");
    fromMenu("Remove …");
    ASSERT_TRUE(asks());
    press("Remove");
    ASSERT_TRUE(says("\"Field\" is removed"));
    EXPECT_TRUE(comesTrue([this] { return mounts()->count() == 1; }));
    EXPECT_TRUE(QFile::exists(fieldFile + QStringLiteral(".removed")));
}

TEST_F(ProfilePageTest, ANewMountIsImportedAndAnExportedOneIsTheSameFile)
{
    const QString file = folder.filePath(QStringLiteral("elsewhere.toml"));
    choose("Field");
    fromMenu("Export …");
    chooseFile(file);
    ASSERT_TRUE(says("File written: "));
    EXPECT_EQ(*profile::loadProfile(file), field);
    Profile garden = *profile::loadProfile(file);
    garden.mount.name = "Garden";
    ASSERT_TRUE(profile::saveProfile(garden, file));
    fromMenu("Import …");
    chooseFile(file);
    ASSERT_TRUE(asks());
    EXPECT_TRUE(question().contains(QStringLiteral("Name of the mount (Mount): \"Roof\" → \"Garden\"")));
    press("Import");
    ASSERT_TRUE(says("The mount \"Garden\" is stored."));
    EXPECT_EQ(store.list().size(), 3u);
    EXPECT_TRUE(requests.empty());
}

TEST_F(ProfilePageTest, AnImportIntoTheMountInForceComesAsEdits)
{
    Profile changed = roof;
    changed.park.azimuth = 77_deg;
    const QString file = folder.filePath(QStringLiteral("roof.toml"));
    ASSERT_TRUE(profile::saveProfile(changed, file));
    fromMenu("Import …");
    chooseFile(file);
    ASSERT_TRUE(asks());
    EXPECT_TRUE(question().contains(QStringLiteral("park azimuth: 0.0 ° → 77.0 °"))) << question().toStdString();
    press("Copy values");
    EXPECT_TRUE(requests.empty());
    EXPECT_EQ(*profile::loadProfile(roofFile), roof);
    press("Apply");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    EXPECT_EQ(asked<request::ApplyProfile>().front().profile, changed);
}

// REQ-PROFILE-17b
TEST_F(ProfilePageTest, ARealMountsProfileImportedIntoTheSimulationIsTriedThere)
{
    Profile tried = roof;
    tried.bus = "simulated";
    tried.pointing.azimuthOffset = 12_deg;
    put(tried);
    Profile real = roof;
    real.park.azimuth = 77_deg;
    const QString file = folder.filePath(QStringLiteral("roof.toml"));
    ASSERT_TRUE(profile::saveProfile(real, file));
    fromMenu("Import …");
    chooseFile(file);
    ASSERT_TRUE(asks());
    press("Copy values");
    press("Apply");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    real.bus = "simulated";
    EXPECT_EQ(asked<request::ApplyProfile>().front().profile, real);
}

// REQ-PROFILE-17a
TEST_F(ProfilePageTest, AFileOfTheSimulatedMountDoesNotReplaceARealOnes)
{
    Profile tried = field;
    tried.bus = "simulated";
    tried.pointing.azimuthOffset = 12_deg;
    const QString file = folder.filePath(QStringLiteral("tried.toml"));
    ASSERT_TRUE(profile::saveProfile(tried, file));
    fromMenu("Import …");
    chooseFile(file);
    EXPECT_TRUE(says("is a profile of the simulated mount"));
    EXPECT_FALSE(page().isAsking());
    EXPECT_EQ(*profile::loadProfile(fieldFile), field);
}

// An export with the name of a bus could be imported over the file of the real mount, with all calibrations from the
// simulation.
// REQ-PROFILE-17a
TEST_F(ProfilePageTest, AnExportFromASimulationNamesNoBus)
{
    Profile tried = roof;
    tried.pointing.azimuthOffset = 12_deg;
    StationStatus status = withProfile(tried);
    status.simulated = true;
    give(samples::update(status));
    const QString file = folder.filePath(QStringLiteral("exported.toml"));
    fromMenu("Export …");
    chooseFile(file);
    ASSERT_TRUE(says("File written: "));
    tried.bus = "simulated";
    EXPECT_EQ(*profile::loadProfile(file), tried);
}

// REQ-PROFILE-17a
TEST_F(ProfilePageTest, ADuplicateMadeInTheSimulationIsOfTheMountItself)
{
    Profile tried = roof;
    tried.pointing.azimuthOffset = 12_deg;
    StationStatus status = withProfile(tried);
    status.simulated = true;
    give(samples::update(status));
    fromMenu("Duplicate …");
    ASSERT_TRUE(asks());
    press("Duplicate");
    ASSERT_TRUE(says("is stored."));
    const auto mounts = store.list();
    const auto copy = std::ranges::find(mounts, QStringLiteral("Roof copy"), &profile::StoredProfile::mountName);
    ASSERT_NE(copy, mounts.end());
    Profile wanted = roof;
    wanted.mount.name = "Roof copy";
    EXPECT_EQ(*profile::loadProfile(copy->path), wanted);
}

// REQ-UI-31: An action that overwrites a profile shows the differences first, and the previous version is kept. An
// invalid file is refused with line and reason. Settings overridden by the command line are not reverted.
TEST_F(ProfilePageTest, AnImportOverAnotherMountShowsWhatItWouldChangeAndKeepsTheVersionBefore)
{
    Profile changed = field;
    changed.park.azimuth = 77_deg;
    const QString file = folder.filePath(QStringLiteral("field.toml"));
    ASSERT_TRUE(profile::saveProfile(changed, file));
    fromMenu("Import …");
    chooseFile(file);
    ASSERT_TRUE(asks());
    EXPECT_TRUE(question().contains(QStringLiteral("Different: 1\npark azimuth")));
    EXPECT_EQ(*profile::loadProfile(fieldFile), field) << "asked, not done";
    press("Overwrite");
    ASSERT_TRUE(says("\"Field\" is overwritten"));
    EXPECT_EQ(*profile::loadProfile(fieldFile), changed);
    EXPECT_EQ(*profile::loadProfile(profile::previousOf(fieldFile)), field);
}

// REQ-UI-31
TEST_F(ProfilePageTest, AWrongFileIsRefusedWithItsLineAndReason)
{
    const QString path = folder.filePath(QStringLiteral("wrong.toml"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("version = 1\n[azimuth]\nmax_speed_deg_s = \"fast\"\n");
    file.close();
    fromMenu("Import …");
    chooseFile(path);
    ASSERT_TRUE(says("wrong.toml:3: azimuth.max_speed_deg_s: a number is expected"));
    EXPECT_FALSE(page().isAsking());
}

// REQ-UI-31
TEST_F(ProfilePageTest, TheLastSavedChangeIsTakenBackKeyByKey)
{
    Profile changed = roof;
    changed.park.azimuth = 77_deg;
    ASSERT_TRUE(store.save(changed, roofFile));
    Profile applied = changed;
    applied.bus = "socketcan:can7";  // the command line sets this, so it is not reverted
    put(applied);
    fromMenu("Undo the last saved change …");
    ASSERT_TRUE(asks());
    EXPECT_TRUE(question().contains(QStringLiteral("park azimuth: 77.0 ° → 0.0 °")));
    press("Undo change");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    Profile expected = applied;
    expected.park.azimuth = 0_deg;
    EXPECT_EQ(asked<request::ApplyProfile>().front().profile, expected);

    Profile other = field;
    other.park.azimuth = 12_deg;
    ASSERT_TRUE(store.save(other, fieldFile));
    choose("Field");
    fromMenu("Undo the last saved change …");
    ASSERT_TRUE(asks());
    press("Undo change");
    ASSERT_TRUE(says("The last change of \"Field\" is undone"));
    EXPECT_EQ(*profile::loadProfile(fieldFile), field);
}

}  // namespace
}  // namespace boresight::ui
