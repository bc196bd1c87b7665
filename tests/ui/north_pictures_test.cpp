// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_calibration.h"
#include "tests/ui/window_fixture.h"
#include "ui/calibration_panel.h"
#include "ui/choice_button.h"
#include "ui/language.h"

#include <QDir>
#include <QImage>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>

// Pictures of the North panel in every theme at both sizes, for the eye; and what a program can judge of them.
namespace boresight::ui {
namespace {

struct NorthScene
{
    const char* name;
    StationStatus (*status)();
    CalibrationStep step;
    int choice = -1;  // of the page's own: Sun, Moon, Mark, Peak; Terms, Points, Type
};

constexpr NorthScene kScenes[] = {{"1-before", samples::beforeCalibration, CalibrationStep::Sensor},
                                  {"1-sensor", samples::heard, CalibrationStep::Sensor},
                                  {"2-before", samples::beforeCalibration, CalibrationStep::Swing},
                                  {"2-running", samples::swinging, CalibrationStep::Swing},
                                  {"2-swung", samples::swung, CalibrationStep::Swing},
                                  {"2-hopeless", samples::swungInVain, CalibrationStep::Swing},
                                  {"3-before", samples::beforeCalibration, CalibrationStep::Body, 0},
                                  {"3-sun", samples::followingSun, CalibrationStep::Body, 0},
                                  {"3-moon", samples::sixPoints, CalibrationStep::Body, 1},
                                  {"3-mark", samples::sixPoints, CalibrationStep::Body, 2},
                                  {"3-peak", samples::scanning, CalibrationStep::Body, 3},
                                  {"4-terms", samples::sixPoints, CalibrationStep::Model, 0},
                                  {"4-points", samples::sixPoints, CalibrationStep::Model, 1},
                                  {"4-type", samples::sixPoints, CalibrationStep::Model, 2},
                                  {"5-history", samples::sixPoints, CalibrationStep::History}};

class NorthPicturesTest : public WindowFixture
{
protected:
    void show(const NorthScene& scene)
    {
        give(samples::update(scene.status()));
        openPanel('9');
        auto* const panel = window.findChild<CalibrationPanel*>();
        panel->go(scene.step);
        if (scene.choice >= 0) {
            const QWidget* const page = panel->findChild<QTabWidget*>()->currentWidget();
            QTest::mouseClick(page->findChildren<ChoiceButton*>().at(scene.choice), Qt::LeftButton);
        }
        QTest::qWait(1);
    }

    void save(const QString& file)
    {
        const QDir folder(QDir::current().filePath(QStringLiteral("pictures")));
        ASSERT_TRUE(QDir().mkpath(folder.path()));
        QImage image(window.size(), QImage::Format_RGB32);
        window.render(&image);
        EXPECT_TRUE(image.save(folder.filePath(file), "PNG", 80));
    }

    void expectFits(QSize size, const NorthScene& scene)
    {
        EXPECT_EQ(window.width(), size.width()) << scene.name;
        EXPECT_EQ(window.height(), size.height()) << scene.name;
    }

    // What the panel says without being cut off; its long sentences have a tooltip with the whole.
    void expectReadable(const NorthScene& scene)
    {
        for (const QTabBar* const tabs : window.findChildren<QTabBar*>()) {
            for (const QToolButton* const arrow : tabs->findChildren<QToolButton*>()) {
                EXPECT_FALSE(arrow->isVisible()) << "tabs hide behind arrows in " << scene.name;
            }
        }
        for (const ValueLabel* const label : window.findChild<CalibrationPanel*>()->findChildren<ValueLabel*>()) {
            if (label->isVisible() && label->sizePolicy().horizontalPolicy() == QSizePolicy::Fixed) {
                EXPECT_FALSE(label->isElided()) << label->accessibleName().toStdString() << " in " << scene.name;
            }
        }
    }
};

TEST_F(NorthPicturesTest, AreWrittenForEveryThemeAndSize)
{
    for (const ThemeKind kind : {ThemeKind::Day, ThemeKind::Night, ThemeKind::Red}) {
        applyTheme(kind);
        for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
            window.resize(size);
            for (const NorthScene& scene : kScenes) {
                show(scene);
                expectFits(size, scene);
                expectReadable(scene);
                save(QStringLiteral("north-%1-%2-%3.png")
                         .arg(QLatin1String(scene.name), name(kind).toLower())
                         .arg(size.width()));
            }
        }
    }
    applyTheme(ThemeKind::Day);
}

// The warning of eyes and feed is the one sentence that nobody may have to look for in a tooltip.
TEST_F(NorthPicturesTest, TheWarningOfTheSunIsNeverCutOff)
{
    for (const auto status : {samples::beforeCalibration, samples::followingSun}) {
        show({"sun", status, CalibrationStep::Body, 0});
        EXPECT_FALSE(named<ValueLabel>("Eyes and feed")->isElided());
    }
}

struct InPortuguese
{
    Translation translation{QStringLiteral("pt")};  // before the window
};

class PortugueseNorthPicturesTest : private InPortuguese, public NorthPicturesTest
{};

TEST_F(PortugueseNorthPicturesTest, AreWrittenAndNothingIsCutOff)
{
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
        window.resize(size);
        for (const NorthScene& scene : kScenes) {
            applyTheme(size.width() == 1024 ? ThemeKind::Day : ThemeKind::Night);
            show(scene);
            expectFits(size, scene);
            expectReadable(scene);
            const ValueLabel& warning = *named<ValueLabel>("Olhos e alimentador");
            EXPECT_FALSE(warning.isVisible() && warning.isElided()) << warning.text().toStdString();
            save(QStringLiteral("pt-north-%1-%2.png").arg(QLatin1String(scene.name)).arg(size.width()));
        }
    }
    applyTheme(ThemeKind::Day);
}

}  // namespace
}  // namespace boresight::ui
