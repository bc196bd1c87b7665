// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/column_head.h"

#include "core/alarms/catalogue.h"
#include "tests/ui/sample_alarms.h"
#include "tests/ui/window_fixture.h"
#include "ui/kit/language.h"
#include "ui/window/alarm_card.h"
#include "ui/window/axis_card.h"
#include "ui/window/panel_tabs.h"
#include "ui/window/sensor_readout.h"

#include <QPushButton>
#include <QTabBar>

namespace boresight::ui {
namespace {

class ColumnHeadTest : public WindowFixture
{
protected:
    // The place where the tabs begin with this status.
    int tabs(const StationStatus& status)
    {
        for (int i = 0; i < 3; ++i) {  // the height of the card follows from its text once it has its width
            give(samples::update(status));
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
        auto* const panels = window.findChild<PanelTabs*>();
        return panels->mapTo(&window, QPoint()).y();
    }
    // Shows and clears each alarm of the catalogue. Returns those that move the tabs. Meanwhile nothing may be cut, and
    // a sentence that is left out must be behind the button More.
    QStringList movers(const SensorStatus& sensor)
    {
        const auto with = [&sensor](StationStatus status) {
            status.sensor = sensor;
            return status;
        };
        const int before = tabs(with(samples::idle()));
        QStringList found;
        for (const AlarmEntry* const entry : alarmCatalogue()) {
            const StationStatus status = with(samples::alarmed(*entry));
            if (const int moved = tabs(status) - before; moved != 0) {
                found << QStringLiteral("%1 by %2").arg(QLatin1String(entry->id)).arg(moved);
            }
            EXPECT_EQ(cut().join(u", ").toStdString(), "") << entry->id;
            EXPECT_TRUE(isWhole(status.alarms.front())) << entry->id;
        }
        EXPECT_EQ(tabs(with(samples::idle())), before);
        return found;
    }
    // The parts above the tabs that are not shown completely.
    QStringList cut()
    {
        QStringList found;
        for (const auto* const label : window.findChild<ColumnHead*>()->findChildren<ValueLabel*>()) {
            if (label->isVisible() && label->isElided()) {
                found << label->accessibleName() + QLatin1String(": ") + label->text();
            }
        }
        if (!window.findChild<AxisCard*>()->isVisible()) {
            found << QStringLiteral("the axes");
        }
        return found;
    }
    // Either all sentences, or what happened, what to do, and the way to the rest.
    bool isWhole(const Alarm& alarm)
    {
        const auto textOf = [this](const QString& name) { return labelOf(name.toUtf8()).text(); };
        const QString advice = textOf(AlarmCard::tr("What was done and what to do"));
        const bool isBrief = named<QPushButton>(AlarmCard::tr("Whole alarm").toUtf8())->isVisible();
        return textOf(AlarmCard::tr("Worst alarm")) == alarm.what && advice.contains(alarm.remedy) &&
               advice.contains(alarm.action) != isBrief;
    }
    const ValueLabel& labelOf(const char* name) { return *named<ValueLabel>(name); }

    const SensorStatus withSensor{.source = QStringLiteral("serial /dev/ttyUSB0"), .open = true};
};

struct Portuguese
{
    Translation translation{QStringLiteral("pt")};
};

// Portuguese texts are longer. The language applies before the window is made.
class PortugueseColumnHeadTest : private Portuguese, public ColumnHeadTest
{};

// Story: an alarm came while the hand was on the pad, and another button came under the pointer.
// REQ-UI-975: At 1280×800 and above no alarm of the catalogue moves the tabs, the panel or its buttons, with or without
// a sensor. The readouts of the axes make room.
TEST_F(ColumnHeadTest, NoAlarmMovesTheTabs)
{
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        window.resize(size);
        EXPECT_EQ(movers(withSensor).join(u", ").toStdString(), "") << size.width();
        EXPECT_EQ(movers({}).join(u", ").toStdString(), "") << size.width();
    }
}

// Story: beside each alarm the numerals had 20 to 28 pt at 1280×800.
// REQ-UI-1781: At 1280×800 the numerals keep 44 pt beside each alarm of the catalogue, with or without a sensor. Only
// beside the longest one, without a sensor, they are smaller.
TEST_F(ColumnHeadTest, TheNumeralsKeepTheirSizeBesideAnAlarm)
{
    window.resize(1280, 800);
    QStringList smaller;
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        StationStatus status = samples::alarmed(*entry);
        for (const SensorStatus& sensor : {withSensor, SensorStatus{}}) {
            status.sensor = sensor;
            tabs(status);
            if (labelOf("Actual azimuth").font() != fonts::actual(44)) {
                smaller << QLatin1String(entry->id) + (sensor.open ? QStringLiteral(", sensor") : QString());
            }
        }
    }
    EXPECT_EQ(smaller.join(u"; ").toStdString(), "switch.lost-steps");
}

// Story: at 1024×700 each alarm of the catalogue moved the tabs by 14 to 65 px.
// REQ-UI-1461: At 1024×700 no alarm of the catalogue moves the tabs, with or without a sensor. There the card has
// smaller letters and margins, and the last line of the log is below the sky, whose disc keeps its size.
TEST_F(ColumnHeadTest, NoAlarmMovesTheTabsOfASmallWindow)
{
    window.resize(1024, 700);
    EXPECT_EQ(movers(withSensor).join(u", ").toStdString(), "");
    EXPECT_EQ(movers({}).join(u", ").toStdString(), "");
}

TEST_F(PortugueseColumnHeadTest, NoAlarmMovesTheTabs)
{
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
        window.resize(size);
        EXPECT_EQ(movers(withSensor).join(u", ").toStdString(), "") << size.width();
        EXPECT_EQ(movers({}).join(u", ").toStdString(), "") << size.width();
    }
}

// Story: at 1024×700 a refused Go made the page Limits scroll. The tabs lost their icons, and a click on Jog met
// Passes.
// REQ-UI-1773: The tabs do not move when a refusal is shown, on no page.
TEST_F(ColumnHeadTest, ARefusalDoesNotMoveTheTabs)
{
    window.resize(1024, 700);
    give(samples::update(samples::idle()));
    auto* const tabs = window.findChild<PanelTabs*>();
    auto* const refusal = named<ValueLabel>("Refused direction");
    const auto places = [&](const QString& refused) {
        refusal->setValue(refused, Tone::Warning);
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        QList<QRect> found;
        for (int tab = 0; tab < tabs->count(); ++tab) {
            found << tabs->tabBar()->tabRect(tab);
        }
        return found;
    };
    const QString refused =
        QStringLiteral("Go: 315.0° / 10.0° lies in keep-out \"roof\". Nearest allowed: 300.0° / 25.0°. ");
    for (int page = 0; page < tabs->count(); ++page) {
        tabs->setCurrentIndex(page);
        const QList<QRect> before = places({});
        EXPECT_EQ(places(refused.repeated(3)), before) << page;
    }
}

// Story: at 1280×800 some alarms left out a sentence that 1024×700 showed.
// REQ-UI-1775: At 1280×800 each alarm of the catalogue is whole. A long one is in smaller letters.
TEST_F(ColumnHeadTest, EachAlarmIsWholeInTheUsualWindow)
{
    window.resize(1280, 800);
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        StationStatus status = samples::alarmed(*entry);
        status.sensor = withSensor;
        tabs(status);
        EXPECT_FALSE(named<QPushButton>("Whole alarm")->isVisible()) << entry->id;
    }
}

// REQ-UI-1570: If the longest alarms have no room for three sentences, the card leaves out what Boresight did. Its
// button More opens the complete alarm in the log. The time is in the log, too.
TEST_F(ColumnHeadTest, TheLongestAlarmIsWholeBehindMore)
{
    window.resize(1024, 700);
    AlarmEntry longest = alarmEntry("sun.clock");
    longest.remedy =
        "Synchronise the clock by NTP or GPS. If its time is right, set clock (Sun) to trusted on the page "
        "Profile. A receiver of GPS needs a free sky and some minutes before it knows the time";
    tabs(samples::alarmed(longest));
    auto* const more = named<QPushButton>("Whole alarm");
    ASSERT_TRUE(more->isVisible());
    EXPECT_FALSE(labelOf("When the alarm came").isVisible());
    QSignalSpy wanted(window.findChild<AlarmCard*>(), &AlarmCard::lineWanted);
    more->click();
    EXPECT_EQ(wanted.count(), 1);
    tabs(samples::alarmed(alarmEntry("cable.ends")));
    EXPECT_FALSE(more->isVisible());
    EXPECT_TRUE(labelOf("When the alarm came").isVisible());
}

// REQ-UI-1571: While a long alarm leaves no room for bar and detail of an axis, the age of late data takes the place of
// the error.
TEST_F(ColumnHeadTest, TheBareCardShowsTheAgeOfLateData)
{
    window.resize(1024, 700);
    StationStatus status = samples::alarmed(alarmEntry("sun.clock"));
    status.trim = SkyPointing{.azimuth = 0.3_deg, .elevation = -0.1_deg};  // this detail is longer
    tabs(status);
    EXPECT_TRUE(labelOf("Error of azimuth").isVisible());
    EXPECT_FALSE(labelOf("Detail of azimuth").isVisible());
    status.azimuth.age = std::chrono::milliseconds(700);
    tabs(status);
    EXPECT_FALSE(labelOf("Error of azimuth").isVisible());
    EXPECT_TRUE(labelOf("Detail of azimuth").isVisible());
    EXPECT_EQ(labelOf("Detail of azimuth").text(), QStringLiteral("age 0.7 s"));
    EXPECT_TRUE(labelOf("Error of elevation").isVisible());
    EXPECT_EQ(cut().join(u", ").toStdString(), "");
}

// REQ-UI-1462: The place of the last log line depends on the size of the window: below the sky of a low window,
// otherwise at the end of the right column.
TEST_F(ColumnHeadTest, TheLastLineOfTheLogStandsWhereThereIsRoom)
{
    const auto left = [this](QSize size) {
        window.resize(size);
        QCoreApplication::processEvents();
        return named<ValueLabel>("Last line of the log")->mapTo(&window, QPoint()).x();
    };
    EXPECT_LT(left({1024, 700}), 20);
    EXPECT_GT(left({1280, 800}), 600);
    EXPECT_LT(left({1024, 700}), 20);
}

}  // namespace
}  // namespace boresight::ui
