// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_calibration.h"
#include "tests/ui/step_button_of.h"
#include "tests/ui/window_fixture.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/language.h"
#include "ui/kit/page_room.h"
#include "ui/north/calibration_panel.h"
#include "ui/window/axis_readout.h"

#include <QApplication>
#include <QFontInfo>
#include <QTabWidget>

#include <ostream>
#include <string>

// The window fits into 1024×700 with the fonts of every desktop. ctest runs these tests once for each font family.
namespace boresight::ui {
namespace {

struct Desktop
{
    int points;
    const char* language;
};

void PrintTo(const Desktop& desktop, std::ostream* out)
{
    *out << desktop.points << " pt, " << desktop.language;
}

// Applied before the window is made.
class OnADesktop : public ::testing::WithParamInterface<Desktop>
{
protected:
    OnADesktop() : m_before(QApplication::font()), m_translation(QLatin1String(GetParam().language))
    {
        QFont font = m_before;
        font.setPointSize(GetParam().points);
        QApplication::setFont(font);
    }
    ~OnADesktop() { QApplication::setFont(m_before); }

private:
    QFont m_before;
    Translation m_translation;
};

class FontsTest : public OnADesktop, public WindowFixture
{
protected:
    void SetUp() override
    {
        const QString fixed = qEnvironmentVariable("BORESIGHT_TEST_FIXED_FONT", QStringLiteral("DejaVu Sans Mono"));
        for (const QString& family : {QApplication::font().family(), fixed}) {
            if (QFontInfo(QFont(family)).family() != family) {
                GTEST_SKIP() << "the font " << family.toStdString() << " is not installed";
            }
        }
    }

    void expectRoom(const std::string& where)
    {
        settle();  // laid out
        const QSize least = window.minimumSizeHint();
        EXPECT_LE(least.width(), 1024) << where;
        EXPECT_LE(least.height(), 700) << where;
        EXPECT_EQ(window.size(), QSize(1024, 700)) << where;
    }
};

TEST_P(FontsTest, EveryPanelHasRoomInEveryState)
{
    using Make = StationStatus (*)();
    constexpr std::pair<const char*, Make> kStates[] = {
        {"idle", samples::idle},         {"cable ending", samples::cableEnding},
        {"fault", samples::faulted},     {"factory drives", samples::factoryDrives},
        {"clients", samples::fighting},  {"disconnected", samples::disconnected},
        {"released", samples::released}, {"proof", samples::proving},
        {"region", samples::bounded}};
    for (const auto& [name, make] : kStates) {
        give(samples::update(make()));
        for (const char panel : kPanels) {
            openPanel(panel);
            expectRoom(std::string(name) + ", panel " + panel);
        }
    }
    for (const StationStatus& asking :
         {samples::asking(Axis::Azimuth, 3, 180_deg, true), samples::asking(Axis::Azimuth, 150, 3.6_deg, false),
          samples::asking(Axis::Elevation, 7, 12_deg, false)}) {
        give(samples::update(asking));
        openPanel('9');
        expectRoom("the question about a wrap");
    }
}

TEST_P(FontsTest, EveryStepOfFindingNorthHasRoom)
{
    openPanel('9');
    auto* const panel = window.findChild<CalibrationPanel*>();
    for (const auto& make : {samples::beforeCalibration, samples::heard, samples::swinging, samples::swungInVain,
                             samples::followingOverTheTop, samples::scanned, samples::sixPoints}) {
        give(samples::update(make()));
        for (int step = 0; step < 5; ++step) {
            panel->go(static_cast<CalibrationStep>(step));
            expectRoom("step " + std::to_string(step + 1));
            const QWidget* const page = shownPage(*panel->findChild<QTabWidget*>());
            for (ChoiceButton* const choice : page->findChildren<ChoiceButton*>()) {
                QTest::mouseClick(choice, Qt::LeftButton);
                expectRoom("step " + std::to_string(step + 1) + ", " + choice->text().toStdString());
            }
        }
    }
}

TEST_P(FontsTest, EveryStepOfTheGuideHasRoom)
{
    QTest::keyClick(&window, Qt::Key_F3);
    for (const GuideStep step : kGuideSteps) {
        give(samples::update(step == GuideStep::Protection ? samples::factoryDrives() : samples::freshMount()));
        QTest::mouseClick(&stepButtonOf(window, step), Qt::LeftButton);
        expectRoom(title(step).toStdString());
    }
}

// The part by which a line is shortened never contains a part of a digit.
TEST_P(FontsTest, LargeNumbersAreDrawnWhole)
{
    give(samples::update(samples::tracking(330)));
    settle();
    for (const ValueLabel* const label : window.findChild<AxisReadout*>()->findChildren<ValueLabel*>()) {
        const QRect digits = label->fontMetrics().tightBoundingRect(QStringLiteral("0123456789"));
        const double baseLine = (label->height() - label->fontMetrics().height()) / 2.0 + label->fontMetrics().ascent();
        EXPECT_GE(baseLine + digits.top(), 0.0) << label->accessibleName().toStdString();
        EXPECT_LE(baseLine + digits.bottom(), label->height()) << label->accessibleName().toStdString();
    }
}

// Story: with Noto Sans the descenders of letters were cut off in the header and in the alarm.
TEST_P(FontsTest, WordsAreDrawnWhole)
{
    give(samples::update(samples::faulted()));
    settle();
    int words = 0;
    for (const ValueLabel* const label : window.findChildren<ValueLabel*>()) {
        if (label->isVisible() && !fonts::isOfNumbers(label->font())) {
            EXPECT_GE(label->height(), label->fontMetrics().height()) << label->accessibleName().toStdString();
            ++words;
        }
    }
    EXPECT_GT(words, 5);
}

INSTANTIATE_TEST_SUITE_P(All, FontsTest,
                         ::testing::Values(Desktop{9, "en"}, Desktop{10, "en"}, Desktop{11, "en"}, Desktop{12, "en"},
                                           Desktop{10, "pt"}, Desktop{12, "pt"}));

}  // namespace
}  // namespace boresight::ui
