// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "tests/ui/sample_calibration.h"
#include "tests/ui/window_fixture.h"
#include "ui/clients/client_model.h"
#include "ui/clients/control_prompt.h"
#include "ui/kit/asking_panel.h"
#include "ui/kit/language.h"
#include "ui/north/calibration_bar.h"
#include "ui/sky/polar_plot.h"
#include "ui/window/close_prompt.h"

#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTableView>

// A question must be readable before it is answered: no question, no banner and no text about a client is cut off at
// the smallest size, in any language.
namespace boresight::ui {
namespace {

struct InALanguage : public ::testing::WithParamInterface<const char*>
{
    Translation translation{QLatin1String(GetParam())};  // before the window
};

class CutTextTest : public InALanguage, public WindowFixture
{
protected:
    static bool isWhole(const QLabel& label)
    {
        return label.wordWrap() ? label.heightForWidth(label.width()) <= label.height()
                                : label.sizeHint().width() <= label.width();
    }

    void expectWhole(const QWidget& root)
    {
        settle();  // laid out
        ASSERT_TRUE(root.isVisible());
        int texts = 0;
        for (const ValueLabel* const label : root.findChildren<ValueLabel*>()) {
            EXPECT_FALSE(label->isVisible() && label->isElided()) << label->text().toStdString();
            texts += label->isVisible() && !label->text().isEmpty() ? 1 : 0;
        }
        for (const QLabel* const label : root.findChildren<QLabel*>()) {
            EXPECT_TRUE(!label->isVisible() || isWhole(*label)) << label->text().toStdString();
            texts += label->isVisible() ? 1 : 0;
        }
        for (const QPushButton* const button : root.findChildren<QPushButton*>()) {
            EXPECT_TRUE(!button->isVisible() || button->sizeHint().width() <= button->width())
                << button->text().toStdString();
        }
        EXPECT_GT(texts, 0);
        EXPECT_EQ(window.size(), QSize(1024, 700)) << "something needed more room than there is";
    }

    // Presses each button of the front panel that asks first, one after the other. Returns their number.
    int askAll()
    {
        int asked = 0;
        for (AskingPanel* const panel : window.findChildren<AskingPanel*>()) {
            for (QPushButton* const button : panel->findChildren<QPushButton*>()) {
                if (button->isVisible() && button->isEnabled() && button->text().endsWith(QChar(0x2026))) {
                    QTest::mouseClick(button, Qt::LeftButton);
                    asked += expectQuestion(*panel, button->text());
                }
                if (button->isVisible() && button->menu() != nullptr) {
                    for (const int action : {0, 1}) {  // the next actions ask for a file
                        button->menu()->actions().at(action)->trigger();
                        asked += expectQuestion(*panel, button->text());
                    }
                }
            }
        }
        return asked;
    }
    int expectQuestion(AskingPanel& panel, const QString& button)
    {
        SCOPED_TRACE(button.toStdString());
        EXPECT_TRUE(panel.isAsking());
        expectWhole(*panel.currentWidget());
        panel.cancel();
        return 1;
    }
};

// REQ-UI-36 (CutTextTest.*): Questions, banners and the permissions of a client are completely readable at 1024×700, in
// every language.
TEST_P(CutTextTest, TheQuestionBeforeClosingIsWhole)
{
    give(samples::update(samples::tracking(10)));
    window.close();
    const auto* const prompt = window.findChild<ClosePrompt*>();
    expectWhole(*prompt);
    QTest::mouseClick(prompt->findChildren<QPushButton*>().front(), Qt::LeftButton);
    expectWhole(*prompt);
}

TEST_P(CutTextTest, AClientThatWantsToDriveIsNamedWhole)
{
    StationStatus status = samples::fighting();
    for (const char* const address : {"192.168.100.100:51999", "127.0.0.1:51235"}) {
        status.clients.at(1).address = QLatin1String(address);
        give(samples::update(status));
        expectWhole(*window.findChild<ControlPrompt*>());
    }
}

TEST_P(CutTextTest, ThatTheMountTurnsBackIsWholeBelowTheState)
{
    StationStatus status = samples::cableEnding();
    status.state = StationState::Slew;
    status.stateReason = Text::tr("unwraps the cable by %1").arg(QStringLiteral("360°"));
    give(samples::update(status));
    const auto labels = window.findChildren<ValueLabel*>();
    const auto reason = std::ranges::find(labels, status.stateReason, &ValueLabel::text);
    ASSERT_NE(reason, labels.end());
    EXPECT_FALSE((*reason)->isElided()) << status.stateReason.toStdString();
}

TEST_P(CutTextTest, WhyADirectionIsForbiddenIsWhole)
{
    give(samples::update(samples::bounded()));
    judge = [](const SkyPointing&) {
        return DirectionVerdict{.whyNot = QStringLiteral("the keep-out \"neighbour's chimney\"")};
    };
    for (const double azimuth : {5.0, 95.0, 185.0, 275.0, 315.0}) {
        Q_EMIT window.findChild<PolarPlot*>()->clicked(SkyPointing{Angle::fromDegrees(azimuth), 1.5_deg});
        give(samples::update(samples::bounded()));
        for (const PromptBar* const prompt : window.findChildren<PromptBar*>()) {
            if (prompt->isVisible()) {
                expectWhole(*prompt);
            }
        }
    }
}

// REQ-UI-1412: The proposal of a calibration is completely readable at 1024×700: the title with its residuals, the
// warnings and every term that changes.
TEST_P(CutTextTest, AProposedCalibrationIsWhole)
{
    openPanel('9');
    for (StationStatus status : {samples::swung(), samples::swungInVain(), samples::sixPoints()}) {
        give(samples::update(status));
        expectWhole(*window.findChild<CalibrationBar*>());
        CalibrationStatus warned = *status.calibration;
        warned.proposal->warnings = {
            QStringLiteral("The text belongs to another mount and to another site. Compare both."),
            QStringLiteral("The sensor keeps the north of its swing. Sensor and axes will then differ by 12.3°.")};
        warned.proposal->residuals = ProposalResiduals{.before = 10.912_deg, .after = 10.512_deg, .points = 15};
        status.calibration = std::make_shared<const CalibrationStatus>(warned);
        give(samples::update(status));
        expectWhole(*window.findChild<CalibrationBar*>());
    }
}

TEST_P(CutTextTest, QuestionsBeforeAnActAreWhole)
{
    StationStatus named = samples::idle();
    profile::Profile profile = *named.profile;
    profile.mount.name = "The four metre dish on the roof of the eastern laboratory";
    named.profile = std::make_shared<const profile::Profile>(profile);
    int asked = 0;
    for (StationStatus status : {samples::idle(), samples::factoryDrives(), named}) {
        status.simulated = false;  // a simulated mount without a profile cannot be duplicated
        give(samples::update(status));
        for (const char panel : {'6', '7', '8'}) {
            openPanel(panel);
            asked += askAll();
        }
    }
    EXPECT_GE(asked, 12);
}

TEST_P(CutTextTest, WhatAClientMayDoIsWholeWheneverItChanges)
{
    openPanel('4');
    StationStatus status = samples::fighting();
    for (ClientStatus& client : status.clients) {
        client = {.id = client.id, .address = client.address, .program = client.program};
    }
    give(samples::update(status));
    settle();
    give(samples::update(samples::fighting()));  // the same clients, other words
    settle();
    const auto* const table = window.findChild<QTableView*>(QStringLiteral("clients"));
    ASSERT_NE(table, nullptr);
    const QHeaderView& header = *table->horizontalHeader();
    const int right = header.sectionViewportPosition(ClientModel::Role) + header.sectionSize(ClientModel::Role);
    EXPECT_LE(right, table->viewport()->width());
    for (const QString& word : roleWords()) {
        EXPECT_LT(table->fontMetrics().horizontalAdvance(word) + 6, header.sectionSize(ClientModel::Role))
            << word.toStdString();
    }
}

// REQ-UI-1413: The address of a client is complete at 1024×700, also for a client that connected while another panel
// was open and for an address longer than the earlier ones.
TEST_P(CutTextTest, TheAddressOfAClientIsWhole)
{
    StationStatus status = samples::fighting();
    give(samples::update(status));
    openPanel('4');
    settle();
    status.clients.at(0).address = QStringLiteral("192.168.100.184:51999");
    give(samples::update(status));
    settle();
    const auto* const table = window.findChild<QTableView*>(QStringLiteral("clients"));
    EXPECT_LT(table->fontMetrics().horizontalAdvance(status.clients.at(0).address) + 6,
              table->horizontalHeader()->sectionSize(ClientModel::Address));
}

INSTANTIATE_TEST_SUITE_P(All, CutTextTest, ::testing::Values("en", "pt"));

}  // namespace
}  // namespace boresight::ui
