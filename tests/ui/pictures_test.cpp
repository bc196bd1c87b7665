// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/axis_readout.h"
#include "ui/choice_button.h"
#include "ui/command_button.h"
#include "ui/header_bar.h"
#include "ui/language.h"
#include "ui/polar_plot.h"
#include "ui/step_button.h"
#include "ui/stop_button.h"

#include <QDir>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>
#include <QTreeView>

// Pictures of every scene in every theme at both scales, for the eye; and what a program can judge of them.
namespace boresight::ui {
namespace {

struct Scene
{
    const char* name;
    StationStatus (*status)();
    char panel;  // digit of its key
};

StationStatus midPass()
{
    return samples::tracking(330);
}

StationStatus late()
{
    return samples::withAge(samples::tracking(330), std::chrono::milliseconds(900));
}

StationStatus threePlaces()
{
    return samples::asking(Axis::Azimuth, 3, 180_deg, true);
}

StationStatus manyPlaces()
{
    return samples::asking(Axis::Azimuth, 150, 3.6_deg, false);
}

StationStatus elevationPlaces()
{
    return samples::asking(Axis::Elevation, 7, 12_deg, false);
}

constexpr Scene kScenes[] = {{"track", midPass, '1'},
                             {"log", midPass, '5'},
                             {"clients", samples::fighting, '4'},
                             {"no-clients", samples::disconnected, '4'},
                             {"charts", midPass, '2'},
                             {"charts-turn", threePlaces, '2'},
                             {"late", late, '1'},
                             {"stopped", samples::stopped, '1'},
                             {"fault", samples::faulted, '1'},
                             {"disconnected", samples::disconnected, '1'},
                             {"limited", samples::limited, '1'},
                             {"cable", samples::cableEnding, '1'},
                             {"operator", samples::operatorMoving, '1'},
                             {"limits", samples::bounded, '3'},
                             {"routed", samples::routed, '1'},
                             {"drives", samples::idle, '6'},
                             {"protection", samples::idle, '7'},
                             {"profile", samples::bounded, '8'},
                             {"factory-drives", samples::factoryDrives, '6'},
                             {"factory-protection", samples::factoryDrives, '7'},
                             {"factory-jog", samples::factoryDrives, '1'},
                             {"reading", samples::reading, '7'},
                             {"released", samples::released, '6'},
                             {"proof", samples::proving, '6'},
                             {"turn", threePlaces, '9'},
                             {"turn-jog", threePlaces, '1'},
                             {"turns", manyPlaces, '9'},
                             {"turn-elevation", elevationPlaces, '9'}};

class PicturesTest : public WindowFixture
{
protected:
    void show(const Scene& scene)
    {
        for (int second = 0; second < 330; second += 2) {
            give(samples::update(samples::tracking(second)));  // the past path
        }
        StationUpdate update = samples::update(scene.status());
        update.samples = samples::ticks(clock.now(), 400.0);
        clock.advance(Seconds(400.0));
        for (std::uint64_t number = 1; number < 12; ++number) {
            update.log.push_back(samples::logEntry(
                number, number % 5 == 0 ? Severity::Warning : Severity::Advisory,
                number % 4 == 0 ? QStringLiteral("operator") : QStringLiteral("rotctld 127.0.0.1:51234"),
                QStringLiteral("P 339.50 57.00: accepted")));
        }
        give(update);
        openPanel(scene.panel);
        QTest::qWait(1);
    }

    QImage picture(double scale)
    {
        QImage image(window.size() * scale, QImage::Format_RGB32);
        image.setDevicePixelRatio(scale);
        window.render(&image);
        return image;
    }
};

class PicturesOfATheme : public PicturesTest, public ::testing::WithParamInterface<ThemeKind>
{};

TEST_P(PicturesOfATheme, AreWrittenForEverySizeAndScale)
{
    const QDir folder(QDir::current().filePath(QStringLiteral("pictures")));
    ASSERT_TRUE(QDir().mkpath(folder.path()));
    applyTheme(GetParam());
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
        window.resize(size);
        for (const Scene& scene : kScenes) {
            show(scene);
            ASSERT_EQ(window.size(), size) << scene.name;
            for (const int scale : size.width() == 1024 ? std::vector{1, 2} : std::vector{1}) {
                const QImage image = picture(scale);
                EXPECT_EQ(image.pixelColor(1, 1), currentTheme().window);
                const QString file = QStringLiteral("%1-%2-%3-%4.png")
                                         .arg(QLatin1String(scene.name), name(GetParam()).toLower())
                                         .arg(size.width())
                                         .arg(scale * 100);
                EXPECT_TRUE(image.save(folder.filePath(file), "PNG", 80));
            }
        }
    }
    applyTheme(ThemeKind::Day);
}

INSTANTIATE_TEST_SUITE_P(All, PicturesOfATheme, ::testing::Values(ThemeKind::Day, ThemeKind::Night, ThemeKind::Red));

// The questions that stand before an act, opened by their buttons.
TEST_F(PicturesTest, AreWrittenForTheQuestions)
{
    const QDir folder(QDir::current().filePath(QStringLiteral("pictures")));
    ASSERT_TRUE(QDir().mkpath(folder.path()));
    const std::tuple<const char*, StationStatus (*)(), char, const char*> questions[] = {
        {"question-fix", samples::factoryDrives, '7', "Fix …"},
        {"question-off", samples::idle, '7', "Switch drives off …"},
        {"question-proof", samples::idle, '6', "Run (both axes) …"}};
    for (const ThemeKind kind : {ThemeKind::Day, ThemeKind::Night}) {
        applyTheme(kind);
        for (const auto& [title, status, panel, button] : questions) {
            show({title, status, panel});
            QTest::mouseClick(named<QPushButton>(button), Qt::LeftButton);
            QTest::qWait(1);
            const QString file = QStringLiteral("%1-%2.png").arg(QLatin1String(title), name(kind).toLower());
            EXPECT_TRUE(picture(1).save(folder.filePath(file), "PNG", 80));
            ASSERT_EQ(window.size(), QSize(1024, 700)) << title;
            show({"away", samples::idle, '1'});
        }
    }
    applyTheme(ThemeKind::Day);
}

// The views of the log: alarms with a past, and who moved the mount.
TEST_F(PicturesTest, AreWrittenForTheViewsOfTheLog)
{
    const QDir folder(QDir::current().filePath(QStringLiteral("pictures")));
    ASSERT_TRUE(QDir().mkpath(folder.path()));
    LogEntry motion = samples::logEntry(12, Severity::Advisory, QStringLiteral("rotctld 127.0.0.1:51234"),
                                        QStringLiteral("moves the mount from 10.00° 20.00°: P 339.50° 57.00°"));
    motion.kind = LogKind::MotionStart;
    for (const ThemeKind kind : {ThemeKind::Day, ThemeKind::Night, ThemeKind::Red}) {
        applyTheme(kind);
        show({"past", samples::disconnected, '5'});
        show({"alarms", samples::faulted, '5'});
        StationUpdate update = samples::update(samples::faulted());
        update.log.push_back(motion);
        give(update);
        for (const auto& [title, choice] : {std::pair("log-alarms", "Alarms of now and since the start of the window"),
                                            std::pair("log-motions", "Who moved the mount, and why")}) {
            QTest::mouseClick(named<ChoiceButton>(choice), Qt::LeftButton);
            QTest::qWait(1);
            const QString file = QStringLiteral("%1-%2.png").arg(QLatin1String(title), name(kind).toLower());
            EXPECT_TRUE(picture(1).save(folder.filePath(file), "PNG", 80));
            ASSERT_EQ(window.size(), QSize(1024, 700)) << title;
        }
    }
    applyTheme(ThemeKind::Day);
}

// The page of the profile with edits that are not applied, and what it asks before a mount gets a new name.
TEST_F(PicturesTest, AreWrittenForTheProfile)
{
    const QDir folder(QDir::current().filePath(QStringLiteral("pictures")));
    ASSERT_TRUE(QDir().mkpath(folder.path()));
    for (const ThemeKind kind : {ThemeKind::Day, ThemeKind::Night, ThemeKind::Red}) {
        applyTheme(kind);
        for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
            window.resize(size);
            show({"profile", samples::bounded, '8'});
            auto* const search = named<QLineEdit>("Search the settings");
            QTest::keyClicks(search, QStringLiteral("azimuth speed"));
            auto* const tree = named<QTreeView>("Settings of the mount");
            const QModelIndex group = tree->model()->index(0, 0);
            EXPECT_TRUE(tree->model()->setData(tree->model()->index(0, 1, group), QStringLiteral("4.5")));
            search->setText(QStringLiteral("a"));
            tree->setCurrentIndex(tree->model()->index(3, 1, tree->model()->index(2, 0)));
            const auto save = [&](const char* title) {
                QTest::qWait(1);
                const QString file =
                    QStringLiteral("%1-%2-%3.png").arg(QLatin1String(title), name(kind).toLower()).arg(size.width());
                EXPECT_TRUE(picture(1).save(folder.filePath(file), "PNG", 80));
                ASSERT_EQ(window.size(), size) << title;
            };
            save("profile-edited");
            auto* const menu = named<QPushButton>("Duplicate, rename, import, export the chosen mount")->menu();
            menu->actions().at(1)->trigger();
            save("profile-rename");
            search->clear();
            QTest::mouseClick(named<CommandButton>("Revert"), Qt::LeftButton);
            show({"away", samples::idle, '1'});
        }
    }
    applyTheme(ThemeKind::Day);
}

// The plot while its limits are edited, and magnified.
TEST_F(PicturesTest, AreWrittenForThePlotBeingEditedAndMagnified)
{
    const QDir folder(QDir::current().filePath(QStringLiteral("pictures")));
    ASSERT_TRUE(QDir().mkpath(folder.path()));
    auto& plot = *window.findChild<PolarPlot*>();
    for (const ThemeKind kind : {ThemeKind::Day, ThemeKind::Night, ThemeKind::Red}) {
        applyTheme(kind);
        for (const int scale : {1, 2}) {
            const auto save = [&](const char* title) {
                const QString file =
                    QStringLiteral("%1-%2-%3.png").arg(QLatin1String(title), name(kind).toLower()).arg(scale * 100);
                EXPECT_TRUE(picture(scale).save(folder.filePath(file), "PNG", 80));
                ASSERT_EQ(window.size(), QSize(1024, 700)) << title;
            };
            show({"edited", samples::bounded, '3'});
            plot.setEditing(true);
            QAbstractItemModel& keepOuts = *named<QTableView>("Keep-outs")->model();
            EXPECT_TRUE(keepOuts.setData(keepOuts.index(0, 4), QStringLiteral("60"), Qt::EditRole));
            QAbstractItemModel& horizon = *named<QTableView>("Horizon")->model();
            EXPECT_TRUE(horizon.setData(horizon.index(3, 1), QStringLiteral("45"), Qt::EditRole));
            named<QDoubleSpinBox>("Lowest elevation")->setValue(12.0);
            save("edited");
            QTest::mouseClick(named<CommandButton>("Revert"), Qt::LeftButton);
            plot.setEditing(false);
            show({"magnified", samples::routed, '3'});
            plot.toggleZoom();
            save("magnified");
            plot.toggleZoom();
        }
    }
    applyTheme(ThemeKind::Day);
}

// The guide's steps, on a mount that nobody has commissioned.
TEST_F(PicturesTest, AreWrittenForTheStepsOfTheGuide)
{
    const QDir folder(QDir::current().filePath(QStringLiteral("pictures")));
    ASSERT_TRUE(QDir().mkpath(folder.path()));
    QTest::keyClick(&window, Qt::Key_F3);
    Q_EMIT window.host().adaptersFound(
        adaptersOf({{.device = QStringLiteral("/dev/ttyACM0"),
                     .stableName = QStringLiteral("/dev/serial/by-id/usb-mjbots_fdcanusb"),
                     .manufacturer = QStringLiteral("mjbots"),
                     .description = QStringLiteral("fdcanusb"),
                     .serialNumber = QStringLiteral("1A2B3C4D"),
                     .vendor = 0x0483,
                     .product = 0x5740}},
                   {{QStringLiteral("can0"), false}}));
    for (const ThemeKind kind : {ThemeKind::Day, ThemeKind::Night, ThemeKind::Red}) {
        applyTheme(kind);
        for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
            window.resize(size);
            for (const GuideStep step : kGuideSteps) {
                give(samples::update(step == GuideStep::Protection ? samples::factoryDrives() : samples::freshMount()));
                const auto steps = window.findChildren<StepButton*>();
                QTest::mouseClick(steps.at(static_cast<int>(step)), Qt::LeftButton);
                QTest::qWait(1);
                const QString file = QStringLiteral("guide-%1-%2-%3.png")
                                         .arg(static_cast<int>(step) + 1)
                                         .arg(name(kind).toLower())
                                         .arg(size.width());
                EXPECT_TRUE(picture(1).save(folder.filePath(file), "PNG", 80));
                ASSERT_EQ(window.size(), size) << title(step).toStdString();
            }
        }
    }
    applyTheme(ThemeKind::Day);
}

// Nothing that must always be read may be cut off at the smallest size: every value label shows its whole text.
TEST_F(PicturesTest, NothingThatMustBeReadIsCutOffAtTheSmallestSize)
{
    const char* const always[] = {"Station state",
                                  "CAN bus",
                                  "Azimuth drive",
                                  "Elevation drive",
                                  "rotctld clients",
                                  "Who may move the mount",
                                  "UTC",
                                  "Simulated mount",
                                  "Actual azimuth",
                                  "Target azimuth",
                                  "Error of azimuth",
                                  "State of azimuth",
                                  "Actual elevation",
                                  "Target elevation",
                                  "Error of elevation",
                                  "State of elevation"};
    for (const Scene& scene : kScenes) {
        show(scene);
        for (const char* const label : always) {
            EXPECT_FALSE(named<ValueLabel>(label)->isElided())
                << label << " in " << scene.name << ": " << text(label).toStdString();
        }
    }
}

struct InPortuguese
{
    Translation translation{QStringLiteral("pt")};  // before the window
};

class PortuguesePicturesTest : private InPortuguese, public PicturesTest
{
protected:
    // What the window always shows, but for the lines that may be cut off.
    [[nodiscard]] QList<ValueLabel*> neverElided() const
    {
        const auto header = [](const char* text) { return HeaderBar::tr(text); };
        QList<ValueLabel*> labels = window.findChild<HeaderBar*>()->findChildren<ValueLabel*>();
        labels += window.findChild<AxisReadout*>()->findChildren<ValueLabel*>();
        QStringList stretching{header("Reason of the state"), header("Target and who gave it")};
        for (const char* const axis : {"azimuth", "elevation"}) {
            stretching << AxisReadout::tr("Detail of %1").arg(QCoreApplication::translate("Axes", axis));
        }
        labels.removeIf([&](const ValueLabel* label) { return stretching.contains(label->accessibleName()); });
        return labels;
    }
};

TEST_F(PortuguesePicturesTest, NothingIsCutOffAtTheSmallestSize)
{
    const QDir folder(QDir::current().filePath(QStringLiteral("pictures")));
    ASSERT_TRUE(QDir().mkpath(folder.path()));
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
        window.resize(size);
        for (const Scene& scene : kScenes) {
            applyTheme(size.width() == 1024 ? ThemeKind::Day : ThemeKind::Night);
            show(scene);
            // Buttons and labels have the room they ask for, or the window would have had to grow.
            EXPECT_EQ(window.size(), size) << scene.name;
            for (const ValueLabel* const label : neverElided()) {
                EXPECT_FALSE(label->isElided()) << label->accessibleName().toStdString() << " in " << scene.name << ": "
                                                << label->text().toStdString();
            }
            for (const QTabBar* const tabs : window.findChildren<QTabBar*>()) {
                for (const QToolButton* const arrow : tabs->findChildren<QToolButton*>()) {
                    EXPECT_FALSE(arrow->isVisible()) << "tabs hide behind arrows in " << scene.name;
                }
            }
            const QString file = QStringLiteral("pt-%1-%2.png").arg(QLatin1String(scene.name)).arg(size.width());
            EXPECT_TRUE(picture(1).save(folder.filePath(file), "PNG", 80));
        }
    }
    applyTheme(ThemeKind::Day);
}

TEST_F(PortuguesePicturesTest, StopIsStopAndStateWordsAreTranslated)
{
    const auto* const stop = window.findChild<StopButton*>();
    ASSERT_NE(stop, nullptr);
    EXPECT_EQ(stop->accessibleName(), QStringLiteral("STOP"));
    give(samples::update(samples::tracking(330)));
    EXPECT_EQ(named<ValueLabel>("Estado da estação")->text(), QStringLiteral("RASTREIO"));
    EXPECT_EQ(named<ValueLabel>("Estado de azimute")->text(), QStringLiteral("MOVE-SE"));
}

}  // namespace
}  // namespace boresight::ui
