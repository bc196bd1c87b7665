// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/picture_book.h"
#include "tests/ui/sample_calibration.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/page_room.h"
#include "ui/north/body_page.h"
#include "ui/north/calibration_panel.h"

#include <QTabWidget>

// Every step of finding north: before, during and after.
namespace boresight::ui {
namespace {

struct NorthScene
{
    const char* name;
    StationStatus (*status)();
    CalibrationStep step;
    int choice = -1;  // of the page itself: Sun, Moon, Mark, Peak; Terms, Points, Type
};

constexpr NorthScene kScenes[] = {{"1-before", samples::beforeCalibration, CalibrationStep::Sensor},
                                  {"1-sensor", samples::heard, CalibrationStep::Sensor},
                                  {"2-before", samples::beforeCalibration, CalibrationStep::Swing},
                                  {"2-running", samples::swinging, CalibrationStep::Swing},
                                  {"2-swung", samples::swung, CalibrationStep::Swing},
                                  {"2-hopeless", samples::swungInVain, CalibrationStep::Swing},
                                  {"3-before", samples::beforeCalibration, CalibrationStep::Body, 0},
                                  {"3-sun", samples::followingSun, CalibrationStep::Body, 0},
                                  {"3-over-the-top", samples::followingOverTheTop, CalibrationStep::Body, 0},
                                  {"3-moon", samples::sixPoints, CalibrationStep::Body, 1},
                                  {"3-mark", samples::sixPoints, CalibrationStep::Body, 2},
                                  {"3-peak", samples::scanning, CalibrationStep::Body, 3},
                                  {"3-peak-found", samples::scanned, CalibrationStep::Body, 3},
                                  {"4-terms", samples::sixPoints, CalibrationStep::Model, 0},
                                  {"4-points", samples::sixPoints, CalibrationStep::Model, 1},
                                  {"4-type", samples::sixPoints, CalibrationStep::Model, 2},
                                  {"5-history", samples::sixPoints, CalibrationStep::History}};

class NorthPictures : public PictureBook
{
protected:
    // Long sentences of the panel have a tooltip with the complete text. But the warning about eyes and feed must be
    // readable without a tooltip.
    NorthPictures()
    {
        const QString warning = BodyPage::tr("Eyes and feed");
        for (const ValueLabel* const label : window.findChild<CalibrationPanel*>()->findChildren<ValueLabel*>()) {
            if (label->accessibleName() == warning) {
                sunWarning = label;
            }
            if (label->sizePolicy().horizontalPolicy() == QSizePolicy::Fixed || label == sunWarning) {
                mustBeWhole << label;
            }
        }
    }

    void open(const NorthScene& scene)
    {
        give(samples::update(scene.status()));
        openPanel('9');
        auto* const panel = window.findChild<CalibrationPanel*>();
        panel->go(scene.step);
        if (scene.choice >= 0) {
            const QWidget* const page = shownPage(*panel->findChild<QTabWidget*>());
            QTest::mouseClick(page->findChildren<ChoiceButton*>().at(scene.choice), Qt::LeftButton);
        }
    }

    const ValueLabel* sunWarning = nullptr;
};

// REQ-UI-41 (NorthPictures.*)
TEST_P(NorthPictures, AreTakenOfEveryStep)
{
    for (const NorthScene& scene : kScenes) {
        open(scene);
        if (qstrcmp(scene.name, "3-sun") == 0) {
            ASSERT_NE(nullptr, sunWarning);
            EXPECT_TRUE(sunWarning->isVisible() && !sunWarning->text().isEmpty()) << "else nobody has judged it";
        }
        take(QStringLiteral("north-") + QLatin1String(scene.name));
    }
}

INSTANTIATE_TEST_SUITE_P(All, NorthPictures, kThemesAndPortuguese, editionName);

}  // namespace
}  // namespace boresight::ui
