// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/profile_page.h"

#include "core/profile/commissioning.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/profile_store.h"
#include "tests/ui/window_fixture.h"
#include "ui/kit/command_button.h"
#include "ui/profile/setting_tree.h"

#include <QAbstractItemModel>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPointer>
#include <QTemporaryDir>
#include <QTreeView>

namespace boresight::ui {
namespace {

using profile::Profile;

// Two mounts are kept, "Roof" is in force.
struct StoreFolder
{
    StoreFolder()
    {
        roof.mount.name = "Roof";
        roof.bus = "fdcanusb:/dev/roof";
        field.mount.name = "Field";
        field.bus = "fdcanusb:/dev/field";
        field.azimuth.limits.speed = 7_deg_s;
        roofFile = *store.add(roof);
        fieldFile = *store.add(field);
    }

    QTemporaryDir folder;
    profile::ProfileStore store{folder.path()};
    Profile roof;
    Profile field;
    QString roofFile;
    QString fieldFile;
};

WindowSettings with(const StoreFolder& folder)
{
    WindowSettings settings;
    settings.configDir = folder.folder.path();
    return settings;
}

class ProfilePageTest : public StoreFolder, public WindowFixture
{
protected:
    ProfilePageTest() : WindowFixture(with(*this))
    {
        put(roof);
        openPanel('8');
        EXPECT_TRUE(QTest::qWaitFor([this] { return mounts()->count() == 2; }));
    }

    static StationStatus withProfile(const Profile& profile, StationStatus status = samples::idle())
    {
        status.profile = std::make_shared<const Profile>(profile);
        status.simulated = profile::namesNoBus(profile);
        return status;
    }
    void put(const Profile& profile) { give(samples::update(withProfile(profile))); }

    QComboBox* mounts() { return named<QComboBox>("Mounts that are kept"); }
    QTreeView* tree() { return named<QTreeView>("Settings of the mount"); }
    QLineEdit* search() { return named<QLineEdit>("Search the settings"); }

    void choose(const char* mount)
    {
        mounts()->setFocus();
        QTest::keyClicks(mounts(), QLatin1String(mount));
        ASSERT_TRUE(mounts()->currentText().startsWith(QLatin1String(mount))) << mounts()->currentText().toStdString();
    }
    void fromMenu(const char* entry)
    {
        auto* const button = named<QPushButton>("Duplicate, rename, import, export the chosen mount");
        for (QAction* const action : button->menu()->actions()) {
            if (action->text() == QString::fromUtf8(entry)) {
                action->trigger();
                return;
            }
        }
        FAIL() << "the menu has no " << entry;
    }
    ProfilePage& page() { return *window.findChild<ProfilePage*>(); }
    bool asks()
    {
        return QTest::qWaitFor([this] { return page().isAsking(); });
    }
    QString question() { return page().findChild<QPlainTextEdit*>()->toPlainText(); }
    void press(const char* button)
    {
        for (QPushButton* const one : page().findChildren<QPushButton*>()) {
            if (one->isVisible() && one->text() == QString::fromUtf8(button)) {
                QTest::mouseClick(one, Qt::LeftButton);
                return;
            }
        }
        FAIL() << "no button " << button;
    }
    // In the field of the open question.
    void type(const char* name, const char* words)
    {
        auto* const typed = named<QLineEdit>(name);
        ASSERT_TRUE(typed->hasFocus());
        QTest::keyClicks(typed, QLatin1String(words));
        QTest::keyClick(typed, Qt::Key_Return);
    }
    bool says(const char* words) { return ui::says(page(), words); }
    // As an operator does it: search, select the line, Enter, type, Enter.
    void edit(const char* key, const char* value)
    {
        QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier);
        ASSERT_TRUE(search()->hasFocus());
        search()->selectAll();
        QTest::keyClicks(search(), QLatin1String(key));
        tree()->setFocus();
        QTest::keyClick(tree(), Qt::Key_Home);
        QTest::keyClick(tree(), Qt::Key_Down);
        QTest::keyClick(tree(), Qt::Key_Return);
        const QPointer<QLineEdit> editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
        ASSERT_TRUE(editor);
        editor->selectAll();
        QTest::keyClicks(editor, QLatin1String(value));
        QTest::keyClick(editor, Qt::Key_Return);
        ASSERT_TRUE(QTest::qWaitFor([&editor] { return !editor; })) << "the editor stays open";
    }
    // Of the first line that is shown.
    QString firstCell(int column)
    {
        const QModelIndex group = tree()->model()->index(0, 0);
        return tree()->model()->index(0, column, group).data().toString();
    }
};

// REQ-UI-29: The profile is shown whole: each setting once, with unit, range and when it applies. A setting is found
// by words of its name or meaning, and edited by keyboard. What is no value is refused with the reason. What clashes
// is marked and not applied. A bus that leaves the simulation shows what goes to the real mount.
TEST_F(ProfilePageTest, EverySettingIsThereOnceWithItsUnitRangeAndWhenItApplies)
{
    const QAbstractItemModel& model = *tree()->model();
    std::size_t lines = 0;
    for (int group = 0; group < model.rowCount(); ++group) {
        const QModelIndex parent = model.index(group, 0);
        EXPECT_FALSE(parent.data().toString().isEmpty());
        lines += static_cast<std::size_t>(model.rowCount(parent));
    }
    EXPECT_EQ(lines, profile::settings().size() + 3) << "horizon, keep-outs and presets are one line each";
    QTest::keyClicks(search(), QStringLiteral("azimuth.max_speed"));
    EXPECT_EQ(firstCell(SettingTree::Name), QStringLiteral("max_speed_deg_s"));
    EXPECT_EQ(firstCell(SettingTree::Value), QStringLiteral("10.0 °/s"));
    EXPECT_EQ(firstCell(SettingTree::Range), QStringLiteral("0.01 … 360 °/s"));
    EXPECT_EQ(firstCell(SettingTree::AppliesWhen), QStringLiteral("at once"));
}

// REQ-UI-29
TEST_F(ProfilePageTest, TheSearchLooksThroughNamesAndMeanings)
{
    QTest::keyClicks(search(), QStringLiteral("watchdog"));
    ASSERT_GT(tree()->model()->rowCount(), 0);
    QTest::keyClicks(search(), QStringLiteral(" nowhere"));
    EXPECT_EQ(tree()->model()->rowCount(), 0);
    search()->clear();
    QTest::keyClicks(search(), QStringLiteral("rotctld server"));
    EXPECT_EQ(tree()->model()->rowCount(), 1) << "the title of a group finds all of it";
    EXPECT_GT(tree()->model()->rowCount(tree()->model()->index(0, 0)), 5);
}

// REQ-UI-29
TEST_F(ProfilePageTest, AValueIsEditedByKeyboardAppliedAndReverted)
{
    edit("azimuth.max_speed", "8");
    EXPECT_TRUE(requests.empty()) << "an edit is no order";
    EXPECT_EQ(firstCell(SettingTree::Value), QStringLiteral("8.0 °/s (was 10.0 °/s)"));
    press("Apply");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    Profile applied = asked<request::ApplyProfile>().front().profile;
    EXPECT_EQ(applied.azimuth.limits.speed, 8_deg_s);
    give(samples::acceptance(withProfile(applied), requests.back().id));
    EXPECT_EQ(firstCell(SettingTree::Value), QStringLiteral("8.0 °/s"));
    edit("azimuth.max_speed", "9");
    press("Revert");
    EXPECT_EQ(firstCell(SettingTree::Value), QStringLiteral("8.0 °/s"));
}

// REQ-UI-29
TEST_F(ProfilePageTest, WhatIsNoValueIsRefusedAndWhatClashesIsMarked)
{
    edit("azimuth.max_speed", "fast");
    EXPECT_TRUE(says("azimuth.max_speed_deg_s: \"fast\" is not a number"));
    EXPECT_EQ(firstCell(SettingTree::Value), QStringLiteral("10.0 °/s"));
    edit("park.elevation", "95");
    EXPECT_TRUE(firstCell(SettingTree::Value).startsWith(QStringLiteral("▲ 95.0 °")))
        << firstCell(SettingTree::Name).toStdString() << ' ' << firstCell(SettingTree::Value).toStdString();
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled());
}

TEST_F(ProfilePageTest, APasswordIsNotSeenOverTheShoulder)
{
    QTest::keyClicks(search(), QStringLiteral("mqtt.password"));
    tree()->setCurrentIndex(tree()->model()->index(0, SettingTree::Value, tree()->model()->index(0, 0)));
    tree()->setFocus();
    QTest::keyClick(tree(), Qt::Key_F2);
    const QPointer<QLineEdit> editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_TRUE(editor);
    QTest::keyClicks(editor, QStringLiteral("s3cret"));
    EXPECT_EQ(editor->text(), QStringLiteral("s3cret"));
    EXPECT_FALSE(editor->displayText().contains(QStringLiteral("s3cret")));
    QTest::keyClick(editor, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&editor] { return !editor; })) << "the editor stays open";
    EXPECT_EQ(firstCell(SettingTree::Value), QStringLiteral("(hidden) (was not given)"));
    edit("mqtt.user", "mount");
    press("Apply");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    EXPECT_EQ(asked<request::ApplyProfile>().front().profile.mqtt.password, "s3cret");
}

TEST_F(ProfilePageTest, AChoiceOpensItsList)
{
    QTest::keyClicks(search(), QStringLiteral("on_exit"));
    tree()->setCurrentIndex(tree()->model()->index(0, SettingTree::Value, tree()->model()->index(0, 0)));
    tree()->setFocus();
    QTest::keyClick(tree(), Qt::Key_F2);
    auto* const list = qobject_cast<QComboBox*>(QApplication::focusWidget());
    ASSERT_NE(list, nullptr);
    EXPECT_EQ(list->currentText(), QStringLiteral("hold"));
    QTest::keyClick(list, Qt::Key_Down);
    tree()->setFocus();
    EXPECT_EQ(firstCell(SettingTree::Value), QStringLiteral("brake (was hold)"));
}

TEST_F(ProfilePageTest, WhatWaitsForAReconnectIsMarkedAndShownAlone)
{
    StationStatus status = withProfile(roof);
    status.waitingKeys = {"control.tick_hz"};
    give(samples::update(status));
    auto* const shown = named<QComboBox>("Which settings are shown");
    shown->setFocus();
    QTest::keyClick(shown, Qt::Key_Down);
    ASSERT_EQ(tree()->model()->rowCount(), 1);
    EXPECT_EQ(firstCell(SettingTree::Name), QStringLiteral("tick_hz"));
    EXPECT_EQ(firstCell(SettingTree::AppliesWhen), QStringLiteral("● waits"));
    EXPECT_TRUE(says("Waits for a reconnect: tick_hz (Control)"));
}

// REQ-UI-30: Choosing a mount does nothing. Switching asks with the differences, is one Reconnect, and is offered
// neither in motion nor over edits.
TEST_F(ProfilePageTest, SwitchingAsksWithTheDifferencesAndIsOneRequest)
{
    EXPECT_FALSE(named<CommandButton>("Switch …")->isEnabled()) << "Roof is in force";
    choose("Field");
    EXPECT_TRUE(requests.empty()) << "choosing does nothing";
    press("Switch …");
    ASSERT_TRUE(asks());
    EXPECT_TRUE(question().contains(QStringLiteral("Bus: fdcanusb:/dev/field"))) << question().toStdString();
    EXPECT_TRUE(question().contains(QStringLiteral("azimuth.max_speed_deg_s: 10.0 °/s → 7.0 °/s")));
    EXPECT_TRUE(requests.empty());
    press("Switch");
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(asked<request::Reconnect>().front().profile, field);
    give(samples::acceptance(withProfile(roof), requests.back().id));
    EXPECT_FALSE(page().isAsking());
    put(field);
    EXPECT_TRUE(QTest::qWaitFor([this] { return mounts()->currentText() == QLatin1String("Field (in force)"); }));
}

TEST_F(ProfilePageTest, TheSettingsHaveTheRoomThatNothingElseNeeds)
{
    const auto rows = [this] {
        QTest::qWait(1);
        const QModelIndex first = tree()->model()->index(0, 0);
        return tree()->viewport()->height() / tree()->visualRect(first).height();
    };
    EXPECT_GE(rows(), 9) << "at 1024x700";
    edit("azimuth.max_speed_deg_s", "4.5");
    EXPECT_TRUE(named<CommandButton>("Apply")->isEnabled());
    EXPECT_GE(rows(), 4) << "with what the line means, what is not applied, and the buttons for it";
    const QRect current = tree()->visualRect(tree()->currentIndex());
    EXPECT_TRUE(tree()->viewport()->rect().contains(current.center())) << "what was changed stays in sight";
}

// REQ-UI-30
TEST_F(ProfilePageTest, NothingIsSwitchedInMotionNorOverEdits)
{
    choose("Field");
    give(samples::update(withProfile(roof, samples::tracking(10))));
    EXPECT_TRUE(named<CommandButton>("Switch …")->toolTip().contains(QStringLiteral("The mount moves")));
    put(roof);
    EXPECT_TRUE(named<CommandButton>("Switch …")->isEnabled());
    edit("azimuth.max_speed", "8");
    EXPECT_TRUE(named<CommandButton>("Switch …")->toolTip().contains(QStringLiteral("apply or revert")));
    press("Revert");
    press("Switch …");
    ASSERT_TRUE(asks());
    give(samples::update(withProfile(roof, samples::tracking(10))));
    EXPECT_FALSE(named<CommandButton>("Switch")->isEnabled()) << "it began to move while the question was open";
}

TEST_F(ProfilePageTest, AMountIsDuplicatedAsItIsApplied)
{
    Profile applied = roof;
    applied.jog.slow = 0.3_deg_s;  // not in the file yet
    put(applied);
    fromMenu("Duplicate …");
    ASSERT_TRUE(asks());
    type("Name of the new mount", "Garden");
    ASSERT_TRUE(says("\"Garden\" is kept"));
    ASSERT_TRUE(QTest::qWaitFor([this] { return mounts()->count() == 3; }));
    EXPECT_GE(mounts()->findText(QStringLiteral("Garden")), 0);
    const auto kept = store.list();
    ASSERT_EQ(kept.size(), 3u);
    EXPECT_EQ(profile::loadProfile(kept[1].path)->jog.slow, 0.3_deg_s);
    fromMenu("Duplicate …");
    type("Name of the new mount", "Field");
    EXPECT_TRUE(says("there is a mount \"Field\" already"));
    EXPECT_TRUE(requests.empty());
}

TEST_F(ProfilePageTest, AnotherMountIsRenamedInItsFileThisOneByAnEdit)
{
    choose("Field");
    fromMenu("Rename …");
    type("New name of the mount", "Meadow");
    ASSERT_TRUE(says("called \"Meadow\" now"));
    EXPECT_EQ(profile::loadProfile(fieldFile)->mount.name, "Meadow");
    ASSERT_TRUE(QTest::qWaitFor([this] { return mounts()->findText(QStringLiteral("Meadow")) >= 0; }));
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
    EXPECT_TRUE(says("This mount is in force"));
    EXPECT_FALSE(page().isAsking());
    ASSERT_TRUE(store.setCurrent(roofFile));
    choose("Field");
    fromMenu("Remove …");
    ASSERT_TRUE(asks());
    press("Remove");
    ASSERT_TRUE(says("\"Field\" is removed"));
    EXPECT_TRUE(QTest::qWaitFor([this] { return mounts()->count() == 1; }));
    EXPECT_TRUE(QFile::exists(fieldFile + QStringLiteral(".removed")));
}

TEST_F(ProfilePageTest, ANewMountIsImportedAndAnExportedOneIsTheSameFile)
{
    const QString file = folder.filePath(QStringLiteral("elsewhere.toml"));
    choose("Field");
    fromMenu("Export …");
    chooseFile(file);
    ASSERT_TRUE(says("Written: "));
    EXPECT_EQ(*profile::loadProfile(file), field);
    Profile garden = *profile::loadProfile(file);
    garden.mount.name = "Garden";
    ASSERT_TRUE(profile::saveProfile(garden, file));
    fromMenu("Import …");
    chooseFile(file);
    ASSERT_TRUE(asks());
    EXPECT_TRUE(question().contains(QStringLiteral("mount.name: \"Roof\" → \"Garden\"")));
    press("Import");
    ASSERT_TRUE(says("\"Garden\" is kept"));
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
    EXPECT_TRUE(question().contains(QStringLiteral("park.azimuth_deg: 0.0 ° → 77.0 °"))) << question().toStdString();
    press("Take over");
    EXPECT_TRUE(requests.empty());
    EXPECT_EQ(*profile::loadProfile(roofFile), roof);
    press("Apply");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    EXPECT_EQ(asked<request::ApplyProfile>().front().profile, changed);
}

// REQ-UI-29
TEST_F(ProfilePageTest, ABusThatLeavesTheSimulationSaysWhatGoesToTheRealMount)
{
    roof.bus = "simulated";
    roof.pointing.azimuthOffset = 37.4_deg;
    put(roof);
    edit("bus.name", "socketcan:can0");
    EXPECT_TRUE(says("Apply leaves the simulation. Only these go to the real mount: "));
    press("Apply");
    EXPECT_TRUE(asked<request::ApplyProfile>().empty());
    ASSERT_EQ(asked<request::Reconnect>().size(), 1u);
    EXPECT_EQ(asked<request::Reconnect>().front().profile.bus, "socketcan:can0");
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
    press("Take over");
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

// Else it could be imported over the file of the real mount, with all that was found in the simulation.
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
    ASSERT_TRUE(says("Written: "));
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
    ASSERT_TRUE(says("is kept as a mount of its own"));
    const auto mounts = store.list();
    const auto copy = std::ranges::find(mounts, QStringLiteral("Roof copy"), &profile::StoredProfile::mountName);
    ASSERT_NE(copy, mounts.end());
    Profile wanted = roof;
    wanted.mount.name = "Roof copy";
    EXPECT_EQ(*profile::loadProfile(copy->path), wanted);
}

// REQ-UI-31: What overwrites a profile shows the differences first and keeps the version before. A wrong file is
// refused with line and reason. What the command line overrides is not taken back.
TEST_F(ProfilePageTest, AnImportOverAnotherMountShowsWhatItWouldChangeAndKeepsTheVersionBefore)
{
    Profile changed = field;
    changed.park.azimuth = 77_deg;
    const QString file = folder.filePath(QStringLiteral("field.toml"));
    ASSERT_TRUE(profile::saveProfile(changed, file));
    fromMenu("Import …");
    chooseFile(file);
    ASSERT_TRUE(asks());
    EXPECT_TRUE(question().contains(QStringLiteral("Different: 1\npark.azimuth_deg")));
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
    applied.bus = "socketcan:can7";  // what the command line says is nobody's to take back
    put(applied);
    fromMenu("Take back the last saved change …");
    ASSERT_TRUE(asks());
    EXPECT_TRUE(question().contains(QStringLiteral("park.azimuth_deg: 77.0 ° → 0.0 °")));
    press("Take back");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    Profile expected = applied;
    expected.park.azimuth = 0_deg;
    EXPECT_EQ(asked<request::ApplyProfile>().front().profile, expected);

    Profile other = field;
    other.park.azimuth = 12_deg;
    ASSERT_TRUE(store.save(other, fieldFile));
    choose("Field");
    fromMenu("Take back the last saved change …");
    ASSERT_TRUE(asks());
    press("Take back");
    ASSERT_TRUE(says("The last change of \"Field\" is taken back"));
    EXPECT_EQ(*profile::loadProfile(fieldFile), field);
}

TEST_F(ProfilePageTest, AnUnreadableMountSaysWhyAndIsNotOffered)
{
    QFile file(fieldFile);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("version = 1\n[park]\nazimuth = 5\n");
    file.close();
    openPanel('1');
    openPanel('8');
    ASSERT_TRUE(QTest::qWaitFor([this] { return mounts()->findText(QStringLiteral("▲ Field")) >= 0; }));
    mounts()->setCurrentText(QStringLiteral("▲ Field"));
    EXPECT_TRUE(says("Field.toml:3: park.azimuth"));
    EXPECT_FALSE(named<CommandButton>("Switch …")->isEnabled());
}

}  // namespace
}  // namespace boresight::ui
