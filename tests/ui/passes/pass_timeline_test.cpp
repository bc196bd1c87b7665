// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_timeline.h"

#include "tests/ui/event_loop.h"
#include "tests/ui/passes/passes_fixture.h"
#include "ui/passes/pass_views.h"
#include "ui/sky/polar_plot.h"

#include <QToolButton>

#include <gmock/gmock.h>

#include <chrono>

namespace boresight::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using namespace std::chrono_literals;

const UtcTime kTimelineNow{std::chrono::sys_days{std::chrono::year{2026} / 3 / 1} + 18h + 20min};

// This number of satellites, numbered from 1, each with one pass: the first in 10 minutes, the others 5 minutes apart.
std::shared_ptr<const PassBook> bookOf(int satellites)
{
    auto elements = std::make_shared<std::vector<orbit::ElementSet>>();
    PassBook book;
    for (int i = 0; i < satellites; ++i) {
        const std::string name = "SAT " + std::to_string(i + 1);
        elements->push_back(satellite(name.c_str(), i + 1, 0_deg, kTimelineNow));
        const UtcTime rises = kTimelineNow + 10min + i * 5min;
        passes::Pass pass;
        pass.aos.utc = rises;
        pass.tca = {.utc = rises + 5min, .direction = {.azimuth = 90_deg, .elevation = Angle::fromDegrees(5.0 + i)}};
        pass.los.utc = rises + 10min;
        book.passes.push_back({.satellite = static_cast<std::size_t>(i), .pass = pass});
    }
    book.satellites = elements;
    return std::make_shared<const PassBook>(book);
}

schedule::WatchedPass watched(const PassBook& book, std::size_t pass)
{
    return {.number = book.elementsOf(book.passes[pass]).number, .pass = book.passes[pass].pass};
}

std::vector<std::int64_t> numbersOf(const Timeline& timeline)
{
    std::vector<std::int64_t> numbers;
    std::ranges::transform(timeline.rows, std::back_inserter(numbers), &TimelineRow::number);
    return numbers;
}

// REQ-PASSES-962: The timeline has a row for each listed satellite and a bar for each pass of a day. Favourites come
// first, then the satellites watched by the schedule. It has at most 40 rows, and says how many satellites are only in
// the list. Passes that the schedule tracks, and passes that it leaves out, look different. A click or the arrow keys
// select a pass.
TEST(PassTimeline, FavouritesComeFirstThenWhatIsWatched)
{
    const auto book = bookOf(4);
    PassTable table;
    table.show(book, kTimelineNow);
    schedule::NightPlan plan;
    plan.chosen = {watched(*book, 2)};
    plan.conflicts = {{.leftOut = watched(*book, 1), .chosen = watched(*book, 2)}};
    const Timeline timeline = timelineOf(table, {{.number = 4, .favourite = orbit::Favourite::On, .note = {}}}, plan);
    EXPECT_THAT(numbersOf(timeline), ElementsAre(4, 2, 3, 1));
    EXPECT_TRUE(timeline.rows[0].isFavourite);
    EXPECT_EQ(timeline.rows[0].bars.front().plan, PassPlan::None);
    EXPECT_EQ(timeline.rows[1].bars.front().plan, PassPlan::LeftOut);
    EXPECT_EQ(timeline.rows[2].bars.front().plan, PassPlan::Tracked);
    EXPECT_THAT(timeline.rows[1].bars.front().tracked, testing::IsEmpty());
    EXPECT_THAT(timeline.rows[2].bars.front().tracked, testing::SizeIs(1));
    EXPECT_EQ(timeline.leftOut, 0U);
}

// REQ-PASSES-962
TEST(PassTimeline, ThePartThatIsTrackedIsUnderlined)
{
    const auto book = bookOf(2);
    PassTable table;
    table.show(book, kTimelineNow);
    schedule::NightPlan plan;
    schedule::WatchedPass rest = watched(*book, 1);
    rest.rest = passes::Stretch{.from = rest.pass.tca.utc, .to = rest.pass.los.utc};
    plan.chosen = {watched(*book, 0), rest};
    plan.conflicts = {{.leftOut = watched(*book, 1), .chosen = watched(*book, 0), .rests = {*rest.rest}}};
    const TimelineBar bar = timelineOf(table, {}, plan).rows.at(1).bars.front();
    EXPECT_EQ(bar.plan, PassPlan::LeftOut);
    EXPECT_THAT(bar.tracked, ElementsAre(*rest.rest));
}

TEST(PassTimeline, SaysWhatHasNoRow)
{
    PassTable table;
    table.show(bookOf(100), kTimelineNow);
    PassTimeline widget;
    widget.show(timelineOf(table, {}, {}));
    EXPECT_EQ(widget.timeline().rows.size(), kMostTimelineRows);
    EXPECT_THAT(widget.summary().toStdString(), HasSubstr("40 satellites. 60 more satellites are only in the list."));
}

TEST(PassTimeline, ABarIsWhereItsPassIsAndAsHigh)
{
    PassTable table;
    table.show(bookOf(3), kTimelineNow);
    PassTimeline widget;
    widget.resize(600, 200);
    widget.setNow(kTimelineNow);
    widget.show(timelineOf(table, {}, {}));
    const auto box = [&](std::size_t row) { return widget.barBox(row, widget.timeline().rows[row].bars.front()); };
    EXPECT_GT(box(1).left(), box(0).left());
    EXPECT_GT(box(1).top(), box(0).bottom());
    EXPECT_GT(box(2).height(), box(0).height()) << "a theme of one colour shows it, too";
    EXPECT_LT(box(0).left(), box(0).right());
    EXPECT_NEAR(box(1).left() - box(0).left(), box(2).left() - box(1).left(), 1e-6);
}

class TimelineViewTest : public PassesFixture
{
protected:
    TimelineViewTest()
    {
        giveFound(status);
        QTest::mouseClick(named<QToolButton>("The passes of the next 24 hours side by side"), Qt::LeftButton);
        settle();
    }
    PassTimeline& timeline() { return *named<PassTimeline>("Timeline of the coming passes"); }
    QWidget& canvas() { return *timeline().viewport(); }

    StationStatus status = withSatellites();
};

TEST_F(TimelineViewTest, AClickSelectsThePass)
{
    ASSERT_TRUE(timeline().isVisible());
    EXPECT_FALSE(table().isVisible());
    ASSERT_EQ(timeline().timeline().rows.size(), 3U);
    const auto& model = *qobject_cast<PassTable*>(table().model());
    const TimelineRow& row = timeline().timeline().rows[2];
    const TimelineBar& bar = row.bars.back();
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, timeline().barBox(2, bar).center().toPoint());
    EXPECT_EQ(table().currentIndex().row(), *model.rowOf(row.number, bar.highest));
    EXPECT_TRUE(text("The selected pass").startsWith(row.name)) << "a picture has no name of it";
    EXPECT_TRUE(requests.empty()) << "selecting moves nothing";
}

TEST_F(TimelineViewTest, TheArrowKeysGoThroughThePasses)
{
    timeline().setFocus();
    QTest::keyClick(&timeline(), Qt::Key_Right);
    EXPECT_EQ(table().currentIndex().row(), 1);
    QTest::keyClick(&timeline(), Qt::Key_Left);
    QTest::keyClick(&timeline(), Qt::Key_Left);
    EXPECT_EQ(table().currentIndex().row(), 0) << "not past the first";
    EXPECT_TRUE(requests.empty());
}

TEST_F(TimelineViewTest, HasTheFilteredPassesOnly)
{
    named<QLineEdit>("Satellites to list")->setText(QStringLiteral("beta"));
    status.utc += 1s;
    give(samples::update(status));
    ASSERT_EQ(timeline().timeline().rows.size(), 1U);
    EXPECT_EQ(timeline().timeline().rows.front().name.toStdString(), "BETA");
    status.utc = timeline().timeline().rows.front().bars.front().sets + 1s;
    const std::size_t before = timeline().timeline().rows.front().bars.size();
    give(samples::update(status));
    EXPECT_EQ(timeline().timeline().rows.front().bars.size(), before - 1) << "what is over has gone";
}

// REQ-PASSES-963: The page Coming shows in one place the passes as a list or as a timeline, and for the selected pass
// its elevation over time and its path over the Earth. The sky keeps its size.
TEST_F(TimelineViewTest, TheSkyKeepsItsSizeInEachView)
{
    const QSize sky = window.findChild<PolarPlot*>()->size();
    for (const char* const view : {"The elevation of the selected pass over time",
                                   "The path of the selected satellite over the Earth", "The passes as a list"}) {
        QTest::mouseClick(named<QToolButton>(view), Qt::LeftButton);
        settle();
        EXPECT_EQ(window.findChild<PolarPlot*>()->size(), sky) << view;
        EXPECT_EQ(window.size(), QSize(1024, 700)) << view;
    }
    EXPECT_TRUE(table().isVisible());
}

// Story: at 1024×700 the map was 84 px high, and the timeline had three rows.
// REQ-PASSES-911: In a low window the pictures have the room of the note, and a picture of one pass that of the filter.
// The buttons that choose the view stay in their places.
TEST_F(TimelineViewTest, APictureHasRoomInALowWindow)
{
    auto* const list = named<QToolButton>("The passes as a list");
    const QPoint place = list->mapTo(&window, QPoint());
    const std::pair<const char*, int> views[] = {{"The passes of the next 24 hours side by side", 100},
                                                 {"The elevation of the selected pass over time", 140},
                                                 {"The way of the selected satellite over the Earth", 140}};
    for (const auto& [view, height] : views) {
        QTest::mouseClick(named<QToolButton>(view), Qt::LeftButton);
        settle();
        ASSERT_EQ(window.size(), QSize(1024, 700));
        EXPECT_GE(window.findChild<PassViews*>()->height(), height) << view;
        EXPECT_EQ(list->mapTo(&window, QPoint()), place) << view;
        EXPECT_FALSE(named<ValueLabel>("The selected pass")->isElided()) << view;
    }
    QTest::mouseClick(list, Qt::LeftButton);
    settle();
    EXPECT_TRUE(named<QLineEdit>("Satellites to list")->isVisible());
}

// A name is whole where it takes no more than a third of the timeline, and the selected satellite is in sight.
// REQ-PASSES-911
TEST(PassTimeline, ShowsTheNameAndTheRowOfTheSelectedPass)
{
    Timeline many;
    for (int i = 0; i < 30; ++i) {
        many.rows.push_back(
            {.number = i + 1,
             .name = QStringLiteral("ISS DEB [SPX-28 IPA FSE]"),
             .bars = {{.rises = kTimelineNow, .highest = kTimelineNow + 5min, .sets = kTimelineNow + 9min}}});
    }
    PassTimeline timeline;
    timeline.resize(700, 140);
    timeline.setVisible(true);
    timeline.setNow(kTimelineNow);
    timeline.show(many);
    EXPECT_GE(timeline.nameBox(0).width(), timeline.fontMetrics().horizontalAdvance(many.rows[0].name));
    timeline.setSelected(25, kTimelineNow + 5min);
    const QRectF bar = timeline.barBox(24, many.rows[24].bars[0]);
    EXPECT_TRUE(QRectF(timeline.viewport()->rect()).contains(bar));
    timeline.setSelected(1, kTimelineNow + 5min);
    EXPECT_GE(timeline.barBox(0, many.rows[0].bars[0]).top(), 0.0);
}

}  // namespace
}  // namespace boresight::ui
