// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/picture_book.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"
#include "ui/sky/polar_plot.h"

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QTreeView>

// The panels while the operator works in them: a question before an act, past events, edits that are not applied.
namespace boresight::ui {
namespace {

class EditingPictures : public PictureBook
{
protected:
    void leave() { show(samples::idle(), '1'); }
};

// REQ-UI-15 (EditingPictures.*)
TEST_P(EditingPictures, AreTakenOfTheQuestions)
{
    const std::tuple<const char*, StationStatus (*)(), char, const char*> whatIsAsked[] = {
        {"question-fix", samples::factoryDrives, '7', "Fix …"},
        {"question-off", samples::idle, '7', "Switch drives off …"},
        {"question-proof", samples::idle, '6', "Run (both axes) …"}};
    for (const auto& [scene, status, panel, button] : whatIsAsked) {
        show(status(), panel);
        QTest::mouseClick(named<QPushButton>(button), Qt::LeftButton);
        take(QLatin1String(scene));
        leave();
    }
}

// Past alarms, and who moved the mount.
TEST_P(EditingPictures, AreTakenOfTheViewsOfTheLog)
{
    show(samples::disconnected(), '5');
    show(samples::faulted(), '5');
    StationUpdate update = samples::update(samples::faulted());
    update.log.push_back(samples::logEntry(12, Severity::Advisory, QStringLiteral("rotctld 127.0.0.1:51234"),
                                           QStringLiteral("moves the mount from 10.00° 20.00°: go to 339.50° 57.00°")));
    update.log.back().kind = LogKind::MotionStart;
    give(update);
    for (const auto& [scene, choice] :
         {std::pair("log-alarms", "Active alarms, and all alarms since the start of the window"),
          std::pair("log-motions", "Who moved the mount, and why")}) {
        QTest::mouseClick(named<ChoiceButton>(choice), Qt::LeftButton);
        take(QLatin1String(scene));
    }
}

// Including the question before a mount is renamed.
TEST_P(EditingPictures, AreTakenOfTheProfile)
{
    show(samples::bounded(), '8');
    auto* const search = named<QLineEdit>("Search the settings");
    QTest::keyClicks(search, QStringLiteral("azimuth speed"));
    auto* const tree = named<QTreeView>("Settings of the mount");
    const QModelIndex group = tree->model()->index(0, 0);
    EXPECT_TRUE(tree->model()->setData(tree->model()->index(0, 1, group), QStringLiteral("4.5")));
    search->setText(QStringLiteral("a"));
    tree->setCurrentIndex(tree->model()->index(3, 1, tree->model()->index(2, 0)));
    take(QStringLiteral("profile-edited"));
    auto* const menu = named<QPushButton>("Duplicate, rename, import, export the chosen mount")->menu();
    menu->actions().at(1)->trigger();
    take(QStringLiteral("profile-rename"));
}

TEST_P(EditingPictures, AreTakenOfThePlot)
{
    auto& plot = *window.findChild<PolarPlot*>();
    show(samples::bounded(), '3');
    plot.setEditing(true);
    QAbstractItemModel& keepOuts = *named<QTableView>("Keep-outs")->model();
    EXPECT_TRUE(keepOuts.setData(keepOuts.index(0, 4), QStringLiteral("60"), Qt::EditRole));
    QAbstractItemModel& horizon = *named<QTableView>("Horizon")->model();
    EXPECT_TRUE(horizon.setData(horizon.index(3, 1), QStringLiteral("45"), Qt::EditRole));
    named<QDoubleSpinBox>("Lowest elevation")->setValue(12.0);
    take(QStringLiteral("edited"));
    QTest::mouseClick(named<CommandButton>("Revert"), Qt::LeftButton);
    plot.setEditing(false);
    show(samples::routed(), '3');
    plot.toggleZoom();
    take(QStringLiteral("magnified"));
}

INSTANTIATE_TEST_SUITE_P(All, EditingPictures, kThemes, editionName);

}  // namespace
}  // namespace boresight::ui
