// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/commissioning.h"
#include "core/profile/profile_store.h"
#include "tests/ui/window_fixture.h"
#include "ui/profile/profile_page.h"

#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTreeView>

// The page of the profile in the window, with a store of two mounts.
namespace boresight::ui {

// Two stored mounts. "Roof" is in effect.
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
    profile::Profile roof;
    profile::Profile field;
    QString roofFile;
    QString fieldFile;
};

class ProfilePageTest : public StoreFolder, public WindowFixture
{
protected:
    ProfilePageTest() : WindowFixture(with(*this))
    {
        put(roof);
        openPanel('8');
        EXPECT_TRUE(comesTrue([this] { return mounts()->count() == 2; }));
    }

    static WindowSettings with(const StoreFolder& folder)
    {
        WindowSettings settings;
        settings.configDir = folder.folder.path();
        return settings;
    }
    static StationStatus withProfile(const profile::Profile& profile, StationStatus status = samples::idle())
    {
        status.profile = std::make_shared<const profile::Profile>(profile);
        status.simulated = profile::namesNoBus(profile);
        return status;
    }
    void put(const profile::Profile& profile) { give(samples::update(withProfile(profile))); }

    QComboBox* mounts() { return named<QComboBox>("Stored mounts"); }
    QTreeView* tree() { return named<QTreeView>("Settings of the mount"); }
    QLineEdit* search() { return named<QLineEdit>("Search the settings"); }

    void choose(const char* mount)
    {
        mounts()->setFocus();
        // As one event, because slow key presses would each start another search.
        mounts()->view()->keyboardSearch({});
        QKeyEvent word(QEvent::KeyPress, Qt::Key_unknown, Qt::NoModifier, QLatin1String(mount));
        QApplication::sendEvent(mounts(), &word);
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
        return comesTrue([this] { return page().isAsking(); });
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
    // Types into the field of the open question.
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
        ASSERT_TRUE(comesTrue([&editor] { return !editor; })) << "the editor stays open";
    }
    // From the first visible line.
    QString firstCell(int column)
    {
        const QModelIndex group = tree()->model()->index(0, 0);
        return tree()->model()->index(0, column, group).data().toString();
    }
};

}  // namespace boresight::ui
