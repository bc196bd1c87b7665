// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/catalogue.h"
#include "tests/ui/event_loop.h"
#include "tests/ui/sample_alarms.h"
#include "ui/kit/language.h"
#include "ui/kit/request_desk.h"
#include "ui/kit/value_label.h"
#include "ui/link/profile_draft.h"
#include "ui/window/alarm_card.h"

#include <QApplication>
#include <QPushButton>
#include <QVBoxLayout>

#include <gtest/gtest.h>

#include <ostream>

namespace boresight::ui {
namespace {

// A card as narrow as the window's right column, with the fonts and languages of other desktops.
struct NarrowDesktop
{
    int points;
    const char* language;
};

void PrintTo(const NarrowDesktop& desktop, std::ostream* out)
{
    *out << desktop.points << " pt, " << desktop.language;
}

class AlarmFontsTest : public ::testing::TestWithParam<NarrowDesktop>
{
protected:
    AlarmFontsTest() : m_before(QApplication::font()), m_translation(QLatin1String(GetParam().language))
    {
        QFont font = m_before;
        font.setPointSize(GetParam().points);
        QApplication::setFont(font);
    }
    ~AlarmFontsTest() override { QApplication::setFont(m_before); }

private:
    QFont m_before;
    Translation m_translation;
};

constexpr int kNarrow = 400;  // px

// REQ-UI-803: At a width of 400 px no sentence and no button of any alarm in the catalogue is cut, with the fonts of
// every desktop, in every language.
TEST_P(AlarmFontsTest, NoAlarmOfTheCatalogueIsCut)
{
    RequestDesk desk;
    const ProfileDraft draft(desk);
    QWidget column;
    auto* const card = new AlarmCard(draft, desk, &column);
    auto* const box = new QVBoxLayout(&column);
    box->setContentsMargins(0, 0, 0, 0);
    box->addWidget(card);
    box->addStretch();
    column.resize(kNarrow, 600);
    column.show();
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        for (const bool stopped : {false, true}) {
            StationStatus status = samples::alarmed(*entry);
            status.alarms.push_back(status.alarms.front());
            status.state = stopped ? StationState::Fault : StationState::Standby;
            card->showStatus(status);
            settle();
            ASSERT_TRUE(card->isVisible());
            EXPECT_EQ(card->width(), kNarrow) << entry->id;
            for (const ValueLabel* const label : card->findChildren<ValueLabel*>()) {
                EXPECT_FALSE(label->isVisible() && label->isElided())
                    << entry->id << ": " << label->text().toStdString();
                EXPECT_FALSE(label->isVisible() && label->text().contains(QLatin1String("%1"))) << entry->id;
            }
            for (const QPushButton* const button : card->findChildren<QPushButton*>()) {
                if (button->isVisible()) {
                    EXPECT_TRUE(card->rect().contains(button->geometry())) << entry->id << button->text().toStdString();
                    EXPECT_GE(button->width(), button->sizeHint().width()) << entry->id;
                    EXPECT_EQ(card->childAt(button->geometry().center()), button) << entry->id;
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Desktops, AlarmFontsTest,
                         ::testing::Values(NarrowDesktop{9, "en"}, NarrowDesktop{10, "en"}, NarrowDesktop{11, "en"},
                                           NarrowDesktop{12, "en"}, NarrowDesktop{9, "pt"}, NarrowDesktop{12, "pt"}));

}  // namespace
}  // namespace boresight::ui
