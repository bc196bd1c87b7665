// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_store.h"

#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/small_file.h"
#include "tests/fakes/text_of.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::profile;

namespace {

Profile named(const std::string& name)
{
    Profile profile;
    profile.mount.name = name;
    return profile;
}

class ProfileStoreTest : public testing::Test
{
protected:
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

    [[nodiscard]] QString added(const std::string& name) const
    {
        const auto path = store.add(named(name));
        EXPECT_TRUE(path) << textOf(path.error());
        return path.value_or(QString());
    }

    [[nodiscard]] std::string nameIn(const QString& file) const
    {
        const auto profile = loadProfile(file);
        return profile ? profile->mount.name : textOf(profile.error());
    }

    // The path of the current profile, or the reason why there is none.
    [[nodiscard]] QString current() const
    {
        const auto found = store.findCurrent();
        return found ? found->value_or(QStringLiteral("none")) : found.error().text;
    }

    // The list as "one, two (current)".
    [[nodiscard]] std::string listed() const
    {
        std::string text;
        for (const StoredProfile& stored : store.list()) {
            text += (text.empty() ? "" : ", ") + stored.mountName.toStdString() +
                    (stored.isCurrent ? " (current)" : "") + (stored.problem.isEmpty() ? "" : " (broken)");
        }
        return text;
    }

private:
    QTemporaryDir m_folder;

protected:
    const ProfileStore store{m_folder.path()};
};

}  // namespace

// REQ-PROFILE-12 (ProfileStoreTest.*): Several mounts are listed, duplicated, removed without loss, imported and
// exported as the same file. One of them is the current one. No two have the same name.
TEST_F(ProfileStoreTest, IsEmptyAtFirst)
{
    EXPECT_EQ(listed(), "");
    EXPECT_EQ(current(), QStringLiteral("none"));
}

TEST_F(ProfileStoreTest, KeepsEachMountInAFileOfItsName)
{
    EXPECT_EQ(added("West_2"), path("profiles/West_2.toml"));
    const QString odd = added("../8\" Höhe");
    EXPECT_EQ(QFileInfo(odd).absolutePath(), path("profiles"));
    EXPECT_TRUE(QFileInfo(odd).fileName().startsWith(QLatin1String("___8__H_he-"))) << odd.toStdString();
    EXPECT_EQ(nameIn(odd), "../8\" Höhe");
    const auto again = store.add(named("West_2"));
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().code, ErrorCode::Refused);
    EXPECT_FALSE(store.add(named("two\nlines")));
    EXPECT_EQ(listed(), "../8\" Höhe, West_2");
}

TEST_F(ProfileStoreTest, OneIsCurrent)
{
    const QString one = added("one");
    EXPECT_EQ(current(), one) << "the only one";
    const QString two = added("two");
    EXPECT_TRUE(current().contains(QLatin1String("Choose one with --profile"))) << current().toStdString();
    ASSERT_TRUE(store.setCurrent(two));
    EXPECT_EQ(listed(), "one, two (current)");
    EXPECT_EQ(current(), two);
    EXPECT_FALSE(store.setCurrent(path("profiles/three.toml")));
    EXPECT_FALSE(store.setCurrent(path("profiles/current")));
    EXPECT_EQ(current(), two);
}

TEST_F(ProfileStoreTest, ABrokenFileIsListedWithItsReason)
{
    (void)added("one");
    ASSERT_TRUE(writeFile(path("profiles/bad.toml"), "version = 7\n"));
    EXPECT_EQ(listed(), "bad (broken), one");
    EXPECT_TRUE(store.list().front().problem.contains(QLatin1String("bad.toml:1: version: ")));
}

// REQ-PROFILE-09
TEST_F(ProfileStoreTest, TheLastChangeCanBeUndoneAndThatToo)
{
    const QString file = added("one");
    EXPECT_FALSE(hasPrevious(file));
    EXPECT_FALSE(store.undo(file));
    Profile changed = named("one");
    changed.jog.slow = 1_deg_s;
    ASSERT_TRUE(store.save(changed, file));
    ASSERT_TRUE(store.save(changed, file)) << "nothing new: there is still something to undo";
    EXPECT_EQ(loadProfile(file), changed);
    EXPECT_TRUE(hasPrevious(file));
    EXPECT_EQ(store.undo(file), named("one"));
    EXPECT_EQ(loadProfile(file), named("one"));
    EXPECT_EQ(store.undo(file), changed);
    EXPECT_EQ(loadProfile(file), changed);
}

TEST_F(ProfileStoreTest, WhatCanNotBeSavedLeavesTheVersionBefore)
{
    const QString file = added("one");
    Profile changed = named("one");
    changed.jog.slow = 1_deg_s;
    ASSERT_TRUE(store.save(changed, file));
    Profile wrong = changed;
    wrong.azimuth.id = wrong.elevation.id;
    EXPECT_FALSE(store.save(wrong, file));
    EXPECT_EQ(loadProfile(file), changed);
    EXPECT_EQ(loadProfile(previousOf(file)), named("one"));
}

TEST_F(ProfileStoreTest, ABrokenPreviousVersionIsNotBroughtBack)
{
    const QString file = added("one");
    ASSERT_TRUE(writeFile(previousOf(file), "version = 7\n"));
    EXPECT_FALSE(store.undo(file));
    EXPECT_EQ(nameIn(file), "one");
}

// The data of a mount is stored under its name, so two mounts with one name would share it.
TEST_F(ProfileStoreTest, NoWayLeadsToTwoMountsOfOneName)
{
    const QString one = added("one");
    const QString two = added("two");
    EXPECT_FALSE(store.save(named("one"), two));
    EXPECT_FALSE(store.duplicate(two, QStringLiteral("one")));
    EXPECT_FALSE(store.importFile(one));
    ASSERT_TRUE(store.save(named("three"), one));
    EXPECT_EQ(added("one"), path("profiles/one-2.toml")) << "the file one.toml is that of three";
    EXPECT_FALSE(store.undo(one)) << "three was one, and there is another one now";
    EXPECT_EQ(listed(), "one, three, two");
}

TEST_F(ProfileStoreTest, DuplicatesUnderANewName)
{
    Profile profile = named("one");
    profile.presets = {{"north", {}}};
    const auto one = store.add(profile);
    ASSERT_TRUE(one);
    const auto copy = store.duplicate(*one, QStringLiteral("copy of one"));
    ASSERT_TRUE(copy) << textOf(copy.error());
    profile.mount.name = "copy of one";
    EXPECT_EQ(loadProfile(*copy), profile);
    EXPECT_FALSE(store.duplicate(*one, QString()));
}

TEST_F(ProfileStoreTest, WhatIsRemovedIsNotLost)
{
    const QString one = added("one");
    const QString two = added("two");
    ASSERT_TRUE(store.setCurrent(one));
    const auto refused = store.remove(one);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    Profile changed = named("two");
    changed.jog.slow = 1_deg_s;
    ASSERT_TRUE(store.save(changed, two));
    ASSERT_TRUE(store.remove(two));
    EXPECT_EQ(listed(), "one (current)");
    EXPECT_EQ(loadProfile(path("profiles/two.toml.removed")), changed);
    EXPECT_EQ(added("two"), two);
    EXPECT_FALSE(hasPrevious(two)) << "another mount's version before";
    ASSERT_TRUE(store.remove(two));
    EXPECT_EQ(loadProfile(path("profiles/two.toml.removed")), changed);
    EXPECT_EQ(loadProfile(path("profiles/two.toml.removed2")), named("two"));
    EXPECT_FALSE(store.remove(path("profiles/two.toml"))) << "it is gone";
    EXPECT_FALSE(store.remove(path("profiles/current")));
}

TEST_F(ProfileStoreTest, ExportsAndImportsTheSameFile)
{
    const QString one = added("one");
    const QString target = path("export.toml");
    ASSERT_TRUE(store.exportFile(one, target));
    EXPECT_EQ(readFile(target), readFile(one));
    EXPECT_FALSE(store.exportFile(one, path("absent/export.toml")));
    EXPECT_FALSE(store.exportFile(path("profiles/absent.toml"), target));

    const ProfileStore other(path("elsewhere"));
    const auto imported = other.importFile(target);
    ASSERT_TRUE(imported) << textOf(imported.error());
    EXPECT_EQ(readFile(*imported), readFile(one));
    ASSERT_TRUE(writeFile(target, "version = 1\ncolour = 1\n"));
    const auto bad = other.importFile(target);
    ASSERT_FALSE(bad);
    EXPECT_NE(textOf(bad.error()).find("export.toml:2: colour: unknown key"), std::string::npos);
}

// This also holds for the previous version of a file that once had a password, and for an exported copy.
// REQ-PROFILE-19
TEST_F(ProfileStoreTest, OnlyTheOwnerReadsAFileWithAPassword)
{
    const auto mine = [](const QString& file) { return readersOf(file) == Readers::OnlyOwner; };
    const QString file = added("Roof");
    EXPECT_FALSE(mine(file));
    Profile profile = named("Roof");
    profile.mqtt.user = "mount";
    profile.mqtt.password = "s3cret";
    ASSERT_TRUE(store.save(profile, file));
    EXPECT_TRUE(mine(file));
    EXPECT_FALSE(mine(previousOf(file)));
    profile.mqtt.password.clear();
    ASSERT_TRUE(store.save(profile, file));
    EXPECT_TRUE(mine(previousOf(file)));
    ASSERT_TRUE(store.undo(file));
    EXPECT_TRUE(mine(file));
    const QString exported = path("exported.toml");
    ASSERT_TRUE(store.exportFile(file, exported));
    EXPECT_TRUE(mine(exported));
}

// REQ-PROFILE-13: The single `profile.toml` of earlier versions still works.
TEST_F(ProfileStoreTest, TakesInTheSingleProfileWithItsComments)
{
    const QByteArray text = "# by hand\nversion = 1\nmount.name = \"old\"\n";
    ASSERT_TRUE(writeFile(path("profile.toml"), text));
    EXPECT_EQ(current(), path("profiles/old.toml"));
    EXPECT_EQ(readFile(path("profiles/old.toml")), text);
    EXPECT_FALSE(QFileInfo::exists(path("profile.toml")));
    (void)added("another");
    EXPECT_EQ(listed(), "another, old (current)");

    // The operator copies a new version of profile.toml there, as with an earlier version of the program.
    ASSERT_TRUE(writeFile(path("profile.toml"), text + "park.azimuth_deg = 90\n"));
    EXPECT_EQ(current(), path("profiles/old.toml"));
    EXPECT_EQ(loadProfile(path("profiles/old.toml"))->park.azimuth, 90_deg);
    EXPECT_EQ(readFile(path("profiles/old.toml~")), text);
}

TEST_F(ProfileStoreTest, ABrokenSingleProfileIsToldAndLeftAlone)
{
    ASSERT_TRUE(writeFile(path("profile.toml"), "version = 1\ncolour = 1\n"));
    EXPECT_TRUE(current().contains(QLatin1String("profile.toml:2: colour"))) << current().toStdString();
    EXPECT_TRUE(QFileInfo::exists(path("profile.toml")));
}

// REQ-PROFILE-13
TEST_F(ProfileStoreTest, ASingleProfileThatCannotBeMovedIsUsedWhereItIs)
{
    ASSERT_TRUE(writeFile(path("profile.toml"), "version = 1\nmount.name = \"old\"\n"));
    ASSERT_TRUE(writeFile(path("profiles"), "in the way"));  // root ignores the permissions of a folder
    EXPECT_EQ(current(), path("profile.toml"));
    EXPECT_EQ(nameIn(path("profile.toml")), "old");
}

// REQ-PROFILE-08
TEST_F(ProfileStoreTest, WritesNothingThatCannotBeReadAgain)
{
    const QString file = added("one");
    Profile bad = named("one");
    bad.limits.horizon = {{10_deg, -5_deg}, {10_deg, -5_deg}};
    bad.jog.slow = AngularRate::fromDegrees(-1.0);
    const auto saved = store.save(bad, file);
    ASSERT_FALSE(saved);
    EXPECT_EQ(textOf(saved.error()),
              "jog.slow_deg_s: -1 is outside 0.001…360\n"
              "limits.horizon[2]: Azimuth 10.00° does not follow 10.00°. The azimuths must ascend, each once.");
    EXPECT_EQ(loadProfile(file), named("one"));
}
