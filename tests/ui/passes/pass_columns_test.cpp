// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/event_loop.h"
#include "tests/ui/passes/passes_fixture.h"
#include "ui/kit/format.h"
#include "ui/passes/pass_details.h"
#include "ui/passes/pass_words.h"
#include "ui/passes/passes_panel.h"

#include <QMenu>
#include <QScrollBar>
#include <QToolButton>

#include <gmock/gmock.h>

#include <algorithm>
#include <ranges>

namespace boresight::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// The columns of the list, and the menu that chooses them.
class PassColumnsTest : public PassesFixture
{
protected:
    // A mount whose cable ends in the north, with a horizon of 20°.
    StationStatus withShortCable()
    {
        StationStatus status = withSatellites();
        profile::Profile profile = *status.profile;
        profile.azimuth.geometry.travel = {0_deg, 360_deg};
        profile.limits.horizon = {{0_deg, 20_deg}, {180_deg, 20_deg}};
        status.profile = std::make_shared<const profile::Profile>(profile);
        return status;
    }
    [[nodiscard]] const PassTable& model() { return *qobject_cast<PassTable*>(table().model()); }
    // A cell that stays empty until the window has computed it.
    QString worked(int row, PassTable::Column column)
    {
        EXPECT_TRUE(fakes::waitUntil([&] { return !cell(row, column).isEmpty(); }));
        return cell(row, column);
    }
    [[nodiscard]] bool isShown(PassTable::Column column) { return !table().isColumnHidden(column); }
    [[nodiscard]] QList<QAction*> choices() { return named<QToolButton>("Columns of the list")->menu()->actions(); }
    void choose(PassTable::Column column)
    {
        const QString heading = model().headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const QList<QAction*> all = choices();
        const auto found = std::ranges::find_if(
            all, [&](const QAction* one) { return one->text().startsWith(heading + QStringLiteral(": ")); });
        ASSERT_NE(found, all.end()) << heading.toStdString();
        (*found)->trigger();
        settle();
    }
    // A cell whose text is wider than its column is cut.
    void expectNothingCut()
    {
        const QFontMetrics metrics(table().font());
        for (int column = PassTable::Rises; column < model().columnCount(); ++column) {
            if (table().isColumnHidden(column)) {
                continue;
            }
            for (int row = 0; row < rows(); ++row) {
                const QString text = cell(row, static_cast<PassTable::Column>(column));
                EXPECT_LE(metrics.horizontalAdvance(text) + 6, table().columnWidth(column)) << text.toStdString();
            }
        }
    }
};

// The extra facts of a pass take some milliseconds each, and a list of 10,000 satellites has 50,000 passes.
// REQ-PASSES-998: Sunlight and cable are never computed while the list is painted or read. They are computed one pass
// at a time when the window is idle, the visible passes first. However far the list is scrolled, only a few results are
// kept.
TEST_F(PassColumnsTest, NothingIsWorkedOutWhileItIsPainted)
{
    giveFound(withSatellites());
    auto book = std::make_shared<PassBook>(*model().book());
    while (book->passes.size() < PassDetails::kMostKept + 50) {
        book->passes.push_back(book->passes.front());
    }
    PassDetails details;
    std::vector<std::size_t> worked;
    QObject::connect(&details, &PassDetails::workedOut, &details, [&](std::size_t pass) { worked.push_back(pass); });
    details.begin(book);
    for (std::size_t pass = 0; pass < book->passes.size(); ++pass) {
        EXPECT_EQ(details.find(pass), nullptr) << "scrolled past";
    }
    EXPECT_EQ(details.wanted(), PassDetails::kMostWanted);
    ASSERT_TRUE(fakes::waitUntil([&] { return details.wanted() == 0; }));
    ASSERT_EQ(worked.size(), PassDetails::kMostWanted);
    EXPECT_EQ(worked.front(), book->passes.size() - 1) << "what is seen now";
    ASSERT_NE(details.find(worked.front()), nullptr);
    for (std::size_t pass = 0; pass < book->passes.size(); ++pass) {
        (void)details.find(pass);
        if (details.wanted() == PassDetails::kMostWanted) {
            ASSERT_TRUE(fakes::waitUntil([&] { return details.wanted() == 0; }));
        }
    }
    ASSERT_TRUE(fakes::waitUntil([&] { return details.wanted() == 0; }));
    EXPECT_EQ(details.kept(), PassDetails::kMostKept);
}

// REQ-PASSES-993: For each pass the list has the times of rise, highest point and set, the highest elevation, the
// duration, the hidden time, the time lost by unwrapping the cable, the time in sunlight, and the age of the elements.
TEST_F(PassColumnsTest, EachFactHasItsColumn)
{
    giveFound(withShortCable());
    const PassBook& book = *model().book();
    int unwraps = 0;
    for (int row = 0; row < rows(); ++row) {
        const BookedPass& one = model().pass(row);
        EXPECT_EQ(cell(row, PassTable::HighestAt), clockText(one.pass.tca.utc));
        EXPECT_EQ(cell(row, PassTable::Sets), setText(one.pass));
        const Seconds hidden = hiddenTime(one.pass);
        EXPECT_EQ(cell(row, PassTable::Hidden), one.pass.clear.empty() ? QStringLiteral("all") : lengthText(hidden));
        const targets::CableTurns cable = cableOf(one, book);
        EXPECT_EQ(worked(row, PassTable::Unwraps), cable.turns == 0 ? QStringLiteral("no") : lengthText(cable.lost));
        unwraps += cable.turns;
        const auto light = passes::lightOf(one.pass, book.elementsOf(one), book.site);
        EXPECT_EQ(worked(row, PassTable::Sunlit), partText(passes::sunlitTime(one.pass, light), one.pass.duration()));
        EXPECT_THAT(cell(row, PassTable::Elements).toStdString(), testing::MatchesRegex("0\\.[01] d"));
    }
    EXPECT_GT(unwraps, 0) << "some pass goes through north";
    EXPECT_LT(unwraps, rows());
    // With one and a half turns of cable no pass needs unwrapping.
    giveFound(withSatellites());
    ASSERT_TRUE(fakes::waitUntil([&] { return model().book()->antenna.reach.azimuths.max > 360_deg; }));
    for (int row = 0; row < rows(); ++row) {
        EXPECT_EQ(worked(row, PassTable::Unwraps), QStringLiteral("no"));
    }
}

// REQ-PASSES-994: The tooltip and the facts of the selected pass explain what unwrapping during a pass means. If the
// mount goes over the top instead, this is shown.
TEST_F(PassColumnsTest, UnwrappingIsExplained)
{
    const targets::CableTurns none;
    const targets::CableTurns once{.hasRoom = false, .turns = 1, .lost = Seconds(37.0)};
    const targets::CableTurns gap{.hasRoom = false, .hasGap = true};
    targets::CableTurns spared = once;
    spared.fitsOverTheTop = true;
    EXPECT_EQ(briefCableText(none), QStringLiteral("no"));
    EXPECT_EQ(briefCableText(once), QStringLiteral("0:37"));
    EXPECT_EQ(briefCableText(spared), QStringLiteral("over the top"));
    EXPECT_THAT(cableText(none).toStdString(), HasSubstr("room for all"));
    EXPECT_THAT(cableText(gap).toStdString(), HasSubstr("less than 360°"));
    EXPECT_THAT(cableText(once).toStdString(), AllOf(HasSubstr("loses 0:37"), Not(HasSubstr("top"))));
    EXPECT_THAT(cableText(spared).toStdString(), HasSubstr("tracks the pass over the top"));

    giveFound(withShortCable());
    for (int row = 0; row < rows(); ++row) {
        table().selectRow(row);
        const bool ends = worked(row, PassTable::Unwraps) != QStringLiteral("no");
        EXPECT_EQ(named<ValueLabel>("The selected pass")->toolTip().contains(QStringLiteral("unwraps the cable")),
                  ends);
        const QString help = model().index(row, PassTable::Unwraps).data(Qt::ToolTipRole).toString();
        EXPECT_EQ(help.contains(QStringLiteral("The cable ends")), ends);
    }
}

// REQ-PASSES-995: By default the list shows as many columns as fit, the most important first. A menu chooses columns.
// If the chosen columns need more room the list scrolls sideways, and no number is cut. The choice is restored at the
// next start.
TEST_F(PassColumnsTest, ByItselfTheListHasWhatThereIsRoomFor)
{
    giveFound(withShortCable());
    EXPECT_TRUE(isShown(PassTable::Rises));
    EXPECT_TRUE(isShown(PassTable::Lasts));
    EXPECT_FALSE(isShown(PassTable::HighestAt));
    EXPECT_EQ(table().horizontalScrollBar()->maximum(), 0);
    expectNothingCut();
    window.resize(3200, 1000);
    settle();
    EXPECT_TRUE(isShown(PassTable::HighestAt));
    EXPECT_EQ(table().horizontalScrollBar()->maximum(), 0);
    EXPECT_EQ(window.arrangement().passes.columns, QStringList());
}

// Story: the name of the ISS was elided, because the column Unwraps had room for its longest text in each list.
// REQ-PASSES-910: A column is as wide as what is seen of it. The name has the rest of the room. Columns after Unwraps
// appear only where the name is whole.
TEST_F(PassColumnsTest, TheNameHasTheRoomThatTheNumbersDoNotNeed)
{
    StationStatus status = withShortCable();
    const std::string name = "ISS DEB [SPX-28 IPA FSE]";
    status.satellites = std::make_shared<const std::vector<orbit::ElementSet>>(
        std::vector{satellite(name.c_str(), 57212, 10_deg, status.utc)});
    window.resize(1280, 800);
    giveFound(status);
    settle();
    EXPECT_TRUE(isShown(PassTable::Unwraps));
    const QFontMetrics metrics(table().font());
    EXPECT_LE(metrics.horizontalAdvance(QString::fromStdString(name)) + 6, table().columnWidth(PassTable::Satellite));
    EXPECT_EQ(table().horizontalScrollBar()->maximum(), 0);

    profile::Profile profile = *status.profile;
    profile.elevation.geometry.travel = {0_deg, 180_deg};
    profile.limits.elevation = {0_deg, 180_deg};
    status.profile = std::make_shared<const profile::Profile>(profile);
    giveFound(status);
    const auto flips = [this] {
        for (int row = 0; row < rows(); ++row) {
            if (cell(row, PassTable::Unwraps).endsWith(QStringLiteral("over the top"))) {
                return row;
            }
        }
        return -1;
    };
    ASSERT_TRUE(fakes::waitUntil([&] { return flips() >= 0; }));
    table().scrollTo(table().model()->index(flips(), PassTable::Unwraps));
    give(samples::update(status));
    settle();
    if (isShown(PassTable::Unwraps)) {
        const QString text = cell(flips(), PassTable::Unwraps);
        EXPECT_LE(metrics.horizontalAdvance(text) + 6, table().columnWidth(PassTable::Unwraps)) << text.toStdString();
    }
    const int wide = table().columnWidth(PassTable::Unwraps);
    table().scrollToTop();
    settle();
    EXPECT_EQ(table().columnWidth(PassTable::Unwraps), wide) << "it does not dance";
}

// The numbers and their headings end at one line.
// REQ-PASSES-910
TEST_F(PassColumnsTest, AHeadingStandsAboveItsNumbers)
{
    giveFound(withShortCable());
    for (int column = PassTable::Satellite; column < model().columnCount(); ++column) {
        const QVariant cells = model().index(0, column).data(Qt::TextAlignmentRole);
        EXPECT_EQ(model().headerData(column, Qt::Horizontal, Qt::TextAlignmentRole), cells) << column;
    }
}

TEST_F(PassColumnsTest, AMenuChoosesTheColumns)
{
    giveFound(withShortCable());
    choose(PassTable::Until);
    EXPECT_FALSE(isShown(PassTable::Until));
    for (const auto column : {PassTable::HighestAt, PassTable::Sets, PassTable::Sunlit, PassTable::Elements}) {
        if (!isShown(column)) {
            choose(column);
        }
        EXPECT_TRUE(isShown(column));
    }
    EXPECT_GT(table().horizontalScrollBar()->maximum(), 0);
    expectNothingCut();
    EXPECT_GE(table().viewport()->height(), 2 * table().rowHeight(0)) << "the scroll bar takes its room";
    const QList<QAction*> all = choices();
    EXPECT_FALSE(all.front()->isChecked());
    EXPECT_EQ(std::ranges::count_if(all, &QAction::isChecked),
              std::ranges::count_if(std::views::iota(int(PassTable::Rises), model().columnCount()),
                                    [this](int column) { return !table().isColumnHidden(column); }));

    WindowSettings next = settings();
    next.layout = window.arrangement();
    next.layout.passes.columns << QStringLiteral("no such column");
    const MainWindow again(clock, next);
    EXPECT_EQ(again.arrangement().passes.columns, window.arrangement().passes.columns);
    all.at(1)->trigger();
    settle();
    for (int column = 0; column < model().columnCount(); ++column) {
        EXPECT_FALSE(table().isColumnHidden(column)) << column;
    }
    expectNothingCut();
    all.front()->trigger();
    settle();
    EXPECT_TRUE(isShown(PassTable::Until));
    EXPECT_EQ(table().horizontalScrollBar()->maximum(), 0);
    EXPECT_EQ(window.arrangement().passes.columns, QStringList());
}

// REQ-PASSES-996: The menu of the columns does not cover the STOP button, not even in a low window.
TEST_F(PassColumnsTest, TheMenuLeavesStopFree)
{
    giveFound(withShortCable());
    QMenu* const menu = named<QToolButton>("Columns of the list")->menu();
    auto* const stop = named<QAbstractButton>("STOP");
    const QRect button(stop->mapToGlobal(QPoint()), stop->size());
    menu->popup(QPoint(button.left(), 0));  // as Qt does if there is no room below
    settle();
    EXPECT_FALSE(menu->geometry().intersects(button));
    menu->close();
}

}  // namespace
}  // namespace boresight::ui
