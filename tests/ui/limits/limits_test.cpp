// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/kit/command_button.h"
#include "ui/limits/limits_panel.h"
#include "ui/sky/plot_editor.h"
#include "ui/sky/polar_plot.h"
#include "ui/window/panel_tabs.h"

#include <QContextMenuEvent>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>

namespace boresight::ui {
namespace {

using pointing::HorizonPoint;
using pointing::Region;

// Limits are changed as by an operator: mouse on the plot, cells and fields in the panel.
class LimitsTest : public WindowFixture
{
protected:
    LimitsTest()
    {
        give(samples::update(samples::bounded()));
        openPanel('3');
    }

    PolarPlot& plot() { return *window.findChild<PolarPlot*>(); }
    PlotEditor& editor() { return plot().editor(); }
    const Region& inForce() const { return samples::bounded().profile->limits; }

    QPoint pixel(Angle azimuth, Angle elevation)
    {
        return plot().markers().projection().toPixel({azimuth, elevation}).toPoint();
    }
    // The widget that receives the mouse: the editor while it takes the mouse, otherwise the markers below it.
    QWidget* under()
    {
        QWidget* const markers = window.findChild<SkyMarkers*>();
        return editor().isEditing() ? &editor() : markers;
    }
    void edit() { QTest::mouseClick(named<QToolButton>(kEdit), Qt::LeftButton); }
    void press(Angle azimuth, Angle elevation)
    {
        QTest::mousePress(under(), Qt::LeftButton, {}, pixel(azimuth, elevation));
    }
    void move(Angle azimuth, Angle elevation, Qt::KeyboardModifiers keys = {})
    {
        QMouseEvent event(QEvent::MouseMove, pixel(azimuth, elevation), under()->mapToGlobal(pixel(azimuth, elevation)),
                          Qt::NoButton, Qt::LeftButton, keys);
        QApplication::sendEvent(under(), &event);
    }
    void release(Angle azimuth, Angle elevation)
    {
        QTest::mouseRelease(under(), Qt::LeftButton, {}, pixel(azimuth, elevation));
    }
    void drag(SkyPointing from, SkyPointing to)
    {
        press(from.azimuth, from.elevation);
        move(from.azimuth + (to.azimuth - from.azimuth).wrapped180() * 0.5, (from.elevation + to.elevation) * 0.5);
        move(to.azimuth, to.elevation);
        release(to.azimuth, to.elevation);
    }
    // Presses Apply, and returns what the station received.
    Region applied()
    {
        const auto& panel = *window.findChild<LimitsPanel*>();
        QTest::mouseClick(findNamed<CommandButton>(panel, "Apply"), Qt::LeftButton);  // other panels have one too
        const auto sent = asked<request::ApplyProfile>();
        EXPECT_EQ(sent.size(), 1u);
        return sent.empty() ? Region() : sent.back().profile.limits;
    }

    static constexpr const char* kEdit = "Change limits, horizon and keep-outs on the plot (Ctrl+E)";
};

// A pixel of this plot is about half a degree: the result is within one step of the pointer.
constexpr double kStep = 0.76;

// REQ-UI-21: Limits, horizon and keep-outs can be changed on the plot only in Edit mode. Apply sends exactly what was
// dragged. Esc first cancels a drag. The STOP keys work at that time, too.
TEST_F(LimitsTest, WithoutEditModeNoDragChangesAnything)
{
    drag({180_deg, 28_deg}, {180_deg, 50_deg});
    drag({70_deg, 30_deg}, {90_deg, 30_deg});
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled());
    EXPECT_EQ(text("Changes of the profile"), QStringLiteral("All changes are applied"));
    edit();
    edit();
    drag({180_deg, 28_deg}, {180_deg, 50_deg});
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled());
}

TEST_F(LimitsTest, InEditModeAClickPicksNoDirectionAndMovesNothing)
{
    edit();
    QTest::mouseClick(under(), Qt::LeftButton, {}, pixel(30_deg, 60_deg));
    EXPECT_FALSE(plot().markers().markers().picked.has_value());
    EXPECT_TRUE(requests.empty());
}

// REQ-UI-21
TEST_F(LimitsTest, ADraggedHorizonPointIsWhatApplySends)
{
    edit();
    EXPECT_TRUE(window.findChild<LimitsPanel*>()->isVisible());
    drag({180_deg, 28_deg}, {170_deg, 40_deg});
    EXPECT_TRUE(text("Changes of the profile").endsWith(QStringLiteral(": horizon")));
    EXPECT_TRUE(asked<request::ApplyProfile>().empty()) << "nothing is in force before Apply";
    const Region sent = applied();
    EXPECT_NEAR(sent.horizon.at(3).azimuth.degrees(), 170.0, kStep);
    EXPECT_NEAR(sent.horizon.at(3).elevation.degrees(), 40.0, kStep);
    Region rest = sent;
    rest.horizon[3] = inForce().horizon[3];
    EXPECT_EQ(rest, inForce()) << "and nothing else";
}

// REQ-UI-21
TEST_F(LimitsTest, ADraggedElevationLimitIsWhatApplySends)
{
    edit();
    drag({30_deg, 5_deg}, {30_deg, 15_deg});
    const Region sent = applied();
    EXPECT_NEAR(sent.elevation.min.degrees(), 15.0, kStep);
    EXPECT_EQ(sent.keepOuts, inForce().keepOuts);
}

TEST_F(LimitsTest, ADraggedAzimuthLimitKeepsItsTurn)
{
    edit();
    drag({300_deg, 2_deg}, {320_deg, 2_deg});  // -60°
    EXPECT_NEAR(applied().azimuth.min.degrees(), -40.0, kStep);
}

TEST_F(LimitsTest, ADraggedEdgeCornerAndWholeOfAKeepOut)
{
    edit();
    drag({285_deg, 30_deg}, {285_deg, 42_deg});  // upper edge of the house
    drag({308_deg, 42_deg}, {320_deg, 50_deg});  // corner
    drag({68_deg, 30_deg}, {90_deg, 40_deg});    // the whole mast
    const Region sent = applied();
    const auto& [mast, house] = std::tie(sent.keepOuts.at(0), sent.keepOuts.at(1));
    EXPECT_NEAR(house.elevationMax.degrees(), 50.0, 2 * kStep);
    EXPECT_NEAR(house.azimuthTo.degrees(), 320.0, 2 * kStep);
    EXPECT_EQ(house.azimuthFrom, 262_deg);
    EXPECT_NEAR(mast.azimuthFrom.degrees(), 84.0, 2 * kStep);
    EXPECT_NEAR((mast.azimuthTo - mast.azimuthFrom).degrees(), 12.0, 1e-9);
    EXPECT_NEAR((mast.elevationMax - mast.elevationMin).degrees(), 48.0, 1e-9);
}

// REQ-UI-21
TEST_F(LimitsTest, EscDuringADragCancelsItThenEndsTheEditingThenStops)
{
    edit();
    press(180_deg, 28_deg);
    move(180_deg, 60_deg);
    EXPECT_TRUE(named<CommandButton>("Apply")->isEnabled());
    QTest::keyClick(window.windowHandle(), Qt::Key_Escape);
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled());
    EXPECT_TRUE(asked<request::Stop>().empty());
    move(180_deg, 70_deg);
    release(180_deg, 70_deg);
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled()) << "the rest of the movement is no drag";
    QTest::keyClick(window.windowHandle(), Qt::Key_Escape);
    EXPECT_TRUE(asked<request::Stop>().empty()) << "it ends the editing";
    QTest::keyClick(window.windowHandle(), Qt::Key_Escape);
    EXPECT_EQ(asked<request::Stop>().size(), 1u);
}

// REQ-UI-21
TEST_F(LimitsTest, TheStopKeysStopAlsoDuringADrag)
{
    edit();
    press(180_deg, 28_deg);
    move(180_deg, 60_deg);
    QTest::keyClick(window.windowHandle(), Qt::Key_F12);
    EXPECT_EQ(asked<request::Stop>().size(), 1u);
}

TEST_F(LimitsTest, PointsAreAddedByDoubleClickAndPlusAndRemovedByDel)
{
    edit();
    auto* const table = named<QTableView>("Horizon");
    ASSERT_EQ(table->model()->rowCount(), 6);
    QTest::mouseDClick(under(), Qt::LeftButton, {}, pixel(320_deg, 55_deg));
    ASSERT_EQ(table->model()->rowCount(), 7);
    EXPECT_NEAR(table->model()->index(6, 0).data().toString().toDouble(), 320.0, 2 * kStep);
    move(330_deg, 60_deg);
    editor().setFocus();
    QTest::keyClick(&editor(), Qt::Key_Plus);
    EXPECT_EQ(table->model()->rowCount(), 8);
    QTest::keyClick(&editor(), Qt::Key_Delete);
    EXPECT_EQ(table->model()->rowCount(), 7);
    QTest::keyClick(&editor(), Qt::Key_Delete);
    EXPECT_EQ(table->model()->rowCount(), 7) << "nothing is selected any more";
}

TEST_F(LimitsTest, TheNumbersUnderTheCursorAreShownWhileEditing)
{
    edit();
    move(30_deg, 60_deg);
    EXPECT_TRUE(text("Under the cursor").startsWith(QStringLiteral("az ")));
    press(180_deg, 28_deg);
    move(180_deg, 40_deg);
    EXPECT_TRUE(text("Under the cursor").startsWith(QStringLiteral("horizon")));
    release(180_deg, 40_deg);
    edit();
    EXPECT_EQ(text("Under the cursor"), QString());
}

TEST_F(LimitsTest, ShiftDrawsFiner)
{
    edit();
    press(180_deg, 28_deg);
    move(177.3_deg, 41.2_deg, Qt::ShiftModifier);
    const HorizonPoint fine = [&] {
        release(177.3_deg, 41.2_deg);
        return applied().horizon.at(3);
    }();
    const double tenths = fine.elevation.degrees() * 10.0;
    EXPECT_NEAR(tenths, std::round(tenths), 1e-6);
}

// REQ-UI-22: Plot, fields and tables change one draft. An invalid text, or an unreadable horizon file, changes nothing
// and shows the reason.
TEST_F(LimitsTest, AFieldOrACellChangesTheSameDraft)
{
    auto* const field = named<QDoubleSpinBox>("Lowest elevation");
    EXPECT_EQ(field->value(), 5.0);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("12.5"));
    QTest::keyClick(field, Qt::Key_Return);

    auto* const keepOuts = named<QTableView>("Keep-outs");
    const QModelIndex name = keepOuts->model()->index(0, 0);
    keepOuts->setCurrentIndex(name);
    keepOuts->edit(name);
    auto* const cell = keepOuts->findChild<QLineEdit*>();
    ASSERT_NE(cell, nullptr);
    cell->selectAll();
    QTest::keyClicks(cell, QStringLiteral("flag pole"));
    QTest::keyClick(cell, Qt::Key_Return);

    const Region sent = applied();
    EXPECT_EQ(sent.elevation.min, 12.5_deg);
    EXPECT_EQ(sent.keepOuts.at(0).name, "flag pole");
}

// REQ-UI-22
TEST_F(LimitsTest, ATextThatIsNoValueIsRefusedWithTheReason)
{
    auto* const horizon = named<QTableView>("Horizon");
    QAbstractItemModel& model = *horizon->model();
    EXPECT_FALSE(model.setData(model.index(2, 1), QStringLiteral("1O"), Qt::EditRole));
    EXPECT_TRUE(text("Why the entry was refused").contains(QStringLiteral("not a number")));
    EXPECT_FALSE(model.setData(model.index(2, 0), QStringLiteral("400"), Qt::EditRole));
    EXPECT_FALSE(model.setData(model.index(2, 0), QStringLiteral("110"), Qt::EditRole));
    EXPECT_TRUE(text("Why the entry was refused").contains(QStringLiteral("already")));
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled());
    EXPECT_TRUE(model.setData(model.index(2, 1), QStringLiteral("23.5°"), Qt::EditRole));
    EXPECT_EQ(text("Why the entry was refused"), QString());
    EXPECT_EQ(applied().horizon.at(2).elevation, 23.5_deg);
}

TEST_F(LimitsTest, TheLiveCheckSpeaksBeforeApply)
{
    QAbstractItemModel& model = *named<QTableView>("Keep-outs")->model();
    EXPECT_TRUE(model.setData(model.index(0, 4), QStringLiteral("0"), Qt::EditRole));
    EXPECT_TRUE(text("Changes of the profile").startsWith(QStringLiteral("elevation_min_deg (keep_out[1]): ")))
        << text("Changes of the profile").toStdString();
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled());
    EXPECT_FALSE(model.index(0, 0).data(Qt::ToolTipRole).toString().isEmpty());
    QTest::mouseClick(named<CommandButton>("Revert"), Qt::LeftButton);
    EXPECT_EQ(model.index(0, 4).data().toString(), QStringLiteral("48.0"));
}

// REQ-UI-994: The tooltip of a row of the limits shows the complete text of the cell, because a long name does not fit.
TEST_F(LimitsTest, TheTooltipHasTheWholeName)
{
    QAbstractItemModel& model = *named<QTableView>("Keep-outs")->model();
    const QString name = QStringLiteral("the chimney of the neighbour and the mast behind it");
    EXPECT_TRUE(model.setData(model.index(0, 0), name, Qt::EditRole));
    EXPECT_EQ(model.index(0, 0).data(Qt::ToolTipRole).toString(), name);
}

TEST_F(LimitsTest, UndoAsksForWhatWasInForceBefore)
{
    named<QDoubleSpinBox>("Lowest elevation")->setValue(9.0);
    applied();
    StationStatus status = samples::bounded();
    status.profile = std::make_shared<const profile::Profile>(asked<request::ApplyProfile>().back().profile);
    give(samples::acceptance(status, requests.back().id));
    EXPECT_EQ(text("Changes of the profile"), QStringLiteral("All changes are applied"));
    QTest::mouseClick(named<CommandButton>("Undo"), Qt::LeftButton);
    EXPECT_EQ(asked<request::ApplyProfile>().back().profile.limits, inForce());
}

TEST_F(LimitsTest, ARefusalStandsUnderTheButtonsAndTheEditsStay)
{
    named<QDoubleSpinBox>("Lowest elevation")->setValue(9.0);
    applied();
    give(samples::refusal(samples::bounded(), requests.back().id, "not while a proof runs"));
    bool said = false;
    for (const ValueLabel* const label : window.findChild<LimitsPanel*>()->findChildren<ValueLabel*>()) {
        said = said || label->text().contains(QStringLiteral("not while a proof runs"));
    }
    EXPECT_TRUE(said);
    EXPECT_EQ(named<QDoubleSpinBox>("Lowest elevation")->value(), 9.0);
    EXPECT_TRUE(named<CommandButton>("Apply")->isEnabled());
}

TEST_F(LimitsTest, AChangeFromElsewhereUnderEditsIsSaidAndKeepEditsJoinsBoth)
{
    named<QDoubleSpinBox>("Lowest elevation")->setValue(9.0);
    StationStatus status = samples::bounded();
    profile::Profile other = *status.profile;
    other.limits.keepOuts.clear();
    status.profile = std::make_shared<const profile::Profile>(other);
    give(samples::update(status));
    EXPECT_TRUE(text("Changes of the profile").contains(QStringLiteral("keep-outs")));
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled());
    QTest::mouseClick(named<CommandButton>("Keep edits"), Qt::LeftButton);
    const Region sent = applied();
    EXPECT_TRUE(sent.keepOuts.empty());
    EXPECT_EQ(sent.elevation.min, 9_deg);
}

TEST_F(LimitsTest, KeepOutsAreAddedAndRemovedByButtons)
{
    auto* const table = named<QTableView>("Keep-outs");
    QTest::mouseClick(named<QPushButton>("Add a keep-out around the present direction of the mount"), Qt::LeftButton);
    ASSERT_EQ(table->model()->rowCount(), 3);
    EXPECT_EQ(table->currentIndex().row(), 2);
    EXPECT_EQ(table->model()->index(2, 1).data().toString(), QStringLiteral("10.0"));  // the mount points to 20°
    QTest::mouseClick(named<QPushButton>("Remove the current keep-out (Del)"), Qt::LeftButton);
    EXPECT_EQ(table->model()->rowCount(), 2);
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled());
}

// REQ-UI-24: A place that the station reports as forbidden is not offered, and the reason is shown.
TEST_F(LimitsTest, TheBarSaysWhyAPickedPlaceIsForbiddenAndOffersNoWayThere)
{
    judge = [](const SkyPointing& at) {
        return DirectionVerdict{.whyNot = at.azimuth < 100_deg && at.elevation < 40_deg ? QStringLiteral("the mast")
                                          : at.azimuth > 100_deg                        ? QStringLiteral("the hill")
                                                                                        : QString()};
    };
    const auto pick = [&](Angle azimuth, Angle elevation) {
        QTest::mouseClick(under(), Qt::LeftButton, {}, pixel(azimuth, elevation));
        give(samples::update(samples::bounded()));
        return named<CommandButton>("Go here");
    };
    EXPECT_TRUE(pick(20_deg, 60_deg)->isEnabled());
    EXPECT_FALSE(pick(68_deg, 30_deg)->isEnabled());
    EXPECT_EQ(named<CommandButton>("Go here")->toolTip(), QStringLiteral("Go here: forbidden: the mast"));
    EXPECT_FALSE(pick(180_deg, 15_deg)->isEnabled()) << "below the hill";
    // The same place is permitted once the profile in effect permits it.
    judge = [](const SkyPointing&) { return DirectionVerdict{}; };
    StationStatus status = samples::bounded();
    profile::Profile open = *status.profile;
    open.limits.horizon.clear();
    status.profile = std::make_shared<const profile::Profile>(open);
    give(samples::update(status));  // asked with this one
    give(samples::update(status));
    EXPECT_TRUE(named<CommandButton>("Go here")->isEnabled());
}

// With a station that hangs, the actions that need no answer are offered all the same.
TEST_F(LimitsTest, TheMenuOpensWithoutAnAnswerAfterHalfASecond)
{
    auto& markers = *window.findChild<SkyMarkers*>();
    QContextMenuEvent event(QContextMenuEvent::Mouse, pixel(20_deg, 60_deg),
                            markers.mapToGlobal(pixel(20_deg, 60_deg)));
    QApplication::sendEvent(&markers, &event);
    EXPECT_EQ(plot().findChild<QMenu*>(), nullptr);
    elapse(Seconds(0.6));
    auto* const menu = plot().findChild<QMenu*>();
    ASSERT_NE(menu, nullptr);
    const auto actions = menu->actions();
    const auto entry = std::ranges::find_if(
        actions, [](const QAction* action) { return action->text().startsWith(QStringLiteral("Go here")); });
    ASSERT_NE(entry, actions.end());
    EXPECT_EQ((*entry)->text(), QStringLiteral("Go here (The station does not answer.)"));
    EXPECT_FALSE((*entry)->isEnabled());
    give(samples::update(samples::bounded()));
    EXPECT_EQ(plot().findChildren<QMenu*>().size(), 1) << "the answer comes too late";
}

TEST_F(LimitsTest, AHorizonGoesOutAsTextAndComesBack)
{
    QTemporaryDir folder;
    auto& panel = *window.findChild<LimitsPanel*>();
    const QString path = folder.filePath(QStringLiteral("horizon.txt"));
    panel.exportHorizon(path);
    QAbstractItemModel& model = *named<QTableView>("Horizon")->model();
    EXPECT_TRUE(model.setData(model.index(2, 1), QStringLiteral("40"), Qt::EditRole));
    EXPECT_TRUE(named<CommandButton>("Apply")->isEnabled());
    panel.importHorizon(path);
    EXPECT_EQ(model.index(2, 1).data().toString(), QStringLiteral("22.0"));
    EXPECT_TRUE(text("Why the entry was refused").contains(QStringLiteral("points read")));
}

// REQ-UI-22
TEST_F(LimitsTest, AHorizonFileThatCannotBeReadChangesNothingAndSaysWhichLine)
{
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("bad.txt")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("0 5\n90 high\n");
    file.close();
    auto& panel = *window.findChild<LimitsPanel*>();
    panel.importHorizon(file.fileName());
    EXPECT_TRUE(text("Why the entry was refused").contains(QStringLiteral("bad.txt:2")));
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled());
    panel.importHorizon(folder.filePath(QStringLiteral("none.txt")));
    EXPECT_FALSE(text("Why the entry was refused").isEmpty());
    EXPECT_FALSE(named<CommandButton>("Apply")->isEnabled());
}

// Story: on an empty table Remove could be pressed, and then asked to select a row.
// REQ-UI-1760: A button that removes a row of the horizon or of the keep-outs is disabled while there is no row. Its
// tooltip then gives the reason.
TEST_F(LimitsTest, NothingIsRemovedFromAnEmptyTable)
{
    auto* const point = named<QPushButton>("Remove the current point of the horizon (Del)");
    auto* const keepOut = named<QPushButton>("Remove the current keep-out (Del)");
    EXPECT_TRUE(point->isEnabled());
    EXPECT_TRUE(keepOut->isEnabled());
    StationStatus status = samples::bounded();
    auto profile = std::make_shared<profile::Profile>(*status.profile);
    profile->limits.horizon.clear();
    profile->limits.keepOuts.clear();
    status.profile = profile;
    give(samples::update(status));
    EXPECT_FALSE(point->isEnabled());
    EXPECT_EQ(point->toolTip(), QStringLiteral("The horizon has no point."));
    EXPECT_FALSE(keepOut->isEnabled());
    EXPECT_EQ(keepOut->toolTip(), QStringLiteral("There is no keep-out."));
    give(samples::update(samples::bounded()));
    EXPECT_TRUE(keepOut->isEnabled());
    EXPECT_EQ(keepOut->toolTip(), QStringLiteral("Remove the current keep-out (Del)"));
}

}  // namespace
}  // namespace boresight::ui
