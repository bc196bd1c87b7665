// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_menu.h"

#include "core/recording/record_writer.h"
#include "tests/core/recording/recorded_pass.h"
#include "tests/ui/window_fixture.h"
#include "ui/guide/guide_page.h"
#include "ui/replay/replay_window.h"
#include "ui/window/about_page.h"
#include "ui/window/help_page.h"
#include "ui/window/stop_button.h"

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QToolButton>

namespace boresight::ui {
namespace {

class MainMenuTest : public WindowFixture
{
protected:
    ~MainMenuTest() override { applyTheme(ThemeKind::Day, Brightness::High); }

    MainMenu& menu() { return *window.findChild<MainMenu*>(); }
    QAction* line(const char* text, const QMenu* in = nullptr)
    {
        for (QAction* const action : (in == nullptr ? &menu() : in)->actions()) {
            if (action->text().section(QLatin1Char('\t'), 0, 0) == QString::fromUtf8(text)) {
                return action;
            }
        }
        return nullptr;
    }
    void choose(const char* text)
    {
        QAction* const action = line(text);
        ASSERT_NE(action, nullptr) << text;
        action->trigger();
    }
    void open()
    {
        QTest::keyClick(&window, Qt::Key_F10);
        ASSERT_TRUE(menu().isVisible());
    }
};

// REQ-UI-903: The menu contains what belongs to no panel. A button, F10 and Alt open it. Each line with a key shows the
// key.
TEST_F(MainMenuTest, AButtonAndTwoKeysOpenIt)
{
    QTest::mouseClick(named<QToolButton>("Menu"), Qt::LeftButton);
    EXPECT_TRUE(menu().isVisible());
    menu().close();
    open();
    menu().close();
    QTest::keyPress(&window, Qt::Key_Alt, Qt::AltModifier);
    EXPECT_FALSE(menu().isVisible());
    QTest::keyRelease(&window, Qt::Key_Alt);
    EXPECT_TRUE(menu().isVisible());
}

TEST_F(MainMenuTest, AltWithAnotherKeyDoesNotOpenIt)
{
    QTest::keyPress(&window, Qt::Key_Alt, Qt::AltModifier);
    QTest::keyClick(&window, Qt::Key_Left, Qt::AltModifier);
    QTest::keyRelease(&window, Qt::Key_Alt);
    EXPECT_FALSE(menu().isVisible());
}

// Story: Alt+Right turned the page of the guide, Alt was released first, and the menu covered the page.
// REQ-UI-903
TEST_F(MainMenuTest, AltWithAShortcutDoesNotOpenIt)
{
    QTest::keyClick(&window, Qt::Key_F3);
    ASSERT_TRUE(window.findChild<GuidePage*>()->isVisible());
    for (const Qt::Key key : {Qt::Key_Right, Qt::Key_Left}) {
        QTest::keyPress(&window, Qt::Key_Alt, Qt::AltModifier);
        QTest::keyPress(&window, key, Qt::AltModifier);
        QTest::keyRelease(&window, Qt::Key_Alt);
        QTest::keyRelease(&window, key);
        EXPECT_FALSE(menu().isVisible());
    }
}

TEST_F(MainMenuTest, EachLineShowsItsKey)
{
    open();
    const std::pair<const char*, const char*> keys[] = {{"Full screen", "F11"},     {"Commissioning guide", "F3"},
                                                        {"Open profile", "Ctrl+8"}, {"Show keys", "Shift+F1"},
                                                        {"Read the manual", "F1"},  {"Save diagnostics …", "Ctrl+B"},
                                                        {"Night", "Ctrl+D"}};
    for (const auto& [text, key] : keys) {
        ASSERT_NE(line(text), nullptr) << text;
        EXPECT_EQ(line(text)->text().section(QLatin1Char('\t'), 1), QLatin1String(key)) << text;
    }
}

// REQ-UI-904: STOP stays in reach of the hand and of the keys while the menu is open.
TEST_F(MainMenuTest, ItNeverCoversStop)
{
    open();
    const auto* const stop = window.findChild<StopButton*>();
    const QRect button(stop->mapToGlobal(QPoint()), stop->size());
    EXPECT_FALSE(menu().frameGeometry().intersects(button));
    QTest::keyClick(&menu(), Qt::Key_F12);
    EXPECT_EQ(asked<request::Stop>().size(), 1u);
}

// REQ-UI-905: Theme and brightness are chosen in the menu, and the choice is kept.
TEST_F(MainMenuTest, ThemeAndBrightnessAreChosenAndKept)
{
    QSignalSpy kept(&window, &MainWindow::themeChanged);
    open();
    EXPECT_TRUE(line("Day")->isChecked());
    EXPECT_FALSE(line("Brightness")->isEnabled()) << "the day theme has no steps";
    choose("Red");
    EXPECT_EQ(currentTheme().kind, ThemeKind::Red);
    menu().close();
    open();
    EXPECT_TRUE(line("Brightness")->isEnabled());
    line("Low", line("Brightness")->menu())->trigger();
    EXPECT_EQ(currentBrightness(), Brightness::Low);
    ASSERT_EQ(kept.size(), 2);
    EXPECT_EQ(kept.back().at(0).value<ThemeKind>(), ThemeKind::Red);
    EXPECT_EQ(kept.back().at(1).value<Brightness>(), Brightness::Low);
    menu().close();
    QTest::keyClick(&window, Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(currentTheme().kind, ThemeKind::Day);
    EXPECT_EQ(currentBrightness(), Brightness::Low) << "for the next night";
}

// REQ-REPLAY-09: The menu opens a recording. F12 stops the mount from the replay, too. Nothing else in it reaches the
// station. The replay closes with the window of the station.
TEST_F(MainMenuTest, ARecordingOpensInAWindowOfItsOwn)
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("pass.recording")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(recording::fileStart(recording::recordedHeader()) +
               recording::tickBlock(recording::RecordedPass().ticks(100)) + recording::fileEnd());
    file.close();
    choose("Open recording …");
    chooseFile(file.fileName());
    QPointer<ReplayWindow> replay;
    ASSERT_TRUE(comesTrue([&replay] {
        for (QWidget* const one : QApplication::topLevelWidgets()) {
            replay = replay ? replay.data() : qobject_cast<ReplayWindow*>(one);
        }
        return replay && replay->isVisible();
    }));
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Left, Qt::Key_Right, Qt::Key_Home, Qt::Key_End}) {
        QTest::keyClick(replay, key);
    }
    EXPECT_TRUE(requests.empty());
    QTest::keyClick(replay, Qt::Key_F12);
    EXPECT_EQ(asked<request::Stop>().size(), 1u);
    window.closeNow();
    settle();
    EXPECT_EQ(replay, nullptr);
}

TEST_F(MainMenuTest, ThePagesOpenWithoutCoveringAnything)
{
    choose("Show keys");
    EXPECT_TRUE(window.findChild<HelpPage*>()->isVisible());
    window.findChild<HelpPage*>()->close();
    choose("About Boresight");
    const auto* const about = window.findChild<AboutPage*>();
    ASSERT_TRUE(about->isVisible());
    EXPECT_FALSE(about->isModal());
    const auto labels = about->findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(
        labels, [](const QLabel* label) { return label->text().contains(QLatin1String("General Public License")); }));
    choose("Open profile");
    EXPECT_TRUE(named<QWidget>("Settings of the mount")->isVisible());
}

// REQ-UI-907: Each tab has a picture beside its word.
TEST_F(MainMenuTest, EachTabHasAPicture)
{
    window.resize(1280, 800);  // a narrower window shows the words alone
    settle();
    const auto* const tabs = window.findChild<QTabWidget*>();
    for (int tab = 0; tab < tabs->count(); ++tab) {
        EXPECT_TRUE(!tabs->isTabVisible(tab) || !tabs->tabIcon(tab).isNull()) << tabs->tabText(tab).toStdString();
    }
}

}  // namespace
}  // namespace boresight::ui
