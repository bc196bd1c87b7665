// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/find_widget.h"
#include "tests/ui/sample_status.h"
#include "tests/ui/window_fixture.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/request_desk.h"
#include "ui/kit/value_label.h"
#include "ui/log/log_page.h"
#include "ui/log/log_panel.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

class LogTest : public ::testing::Test
{
protected:
    LogTest()
    {
        LogEntry motion = samples::logEntry(2, Severity::Advisory, QStringLiteral("rotctld 10.0.0.7:40112"),
                                            QStringLiteral("moves the mount from 0.00° 0.00°: go to 339.50° 57.00°"));
        motion.kind = LogKind::MotionStart;
        panel.append({samples::logEntry(1, Severity::Advisory, QStringLiteral("operator"), QStringLiteral("park")),
                      motion,
                      samples::logEntry(3, Severity::Alarm, QStringLiteral("azimuth drive"),
                                        QStringLiteral("fault 38: over temperature")),
                      samples::logEntry(4, Severity::Warning, QStringLiteral("rotctld 10.0.0.8:40113"),
                                        QStringLiteral("dropped: line longer than 1000 bytes"))});
        panel.resize(480, 300);
    }
    void show()
    {
        panel.show();
        panel.activateWindow();
        ASSERT_TRUE(becomesActive(panel));
    }
    template <class T>
    T& on(const LogPage& page)
    {
        return *page.findChild<T*>();
    }
    const LogPage& events() const { return panel.events(); }
    int rows() const { return events().shown().rowCount(); }
    QString cell(int row, int column) const { return events().shown().index(row, column).data().toString(); }
    void press(const LogPage& page, const char* text)
    {
        for (auto* const button : page.findChildren<QPushButton*>()) {
            if (button->text() == QString::fromUtf8(text)) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        ADD_FAILURE() << "no button " << text;
    }
    void clickRow(QTableView& table, int row)
    {
        const QRect place = table.visualRect(table.model()->index(row, LogModel::Text));
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, place.center());
    }
    QString outcome() const { return events().findChild<ValueLabel*>()->text(); }
    RequestDesk desk;
    LogPanel panel{desk, true};
};

TEST_F(LogTest, FiltersBySource)
{
    auto& source = on<QComboBox>(events());
    EXPECT_EQ(rows(), 4);
    source.setCurrentIndex(1);
    EXPECT_EQ(rows(), 1);
    source.setCurrentIndex(2);
    EXPECT_EQ(rows(), 2);
    source.setCurrentIndex(3);
    EXPECT_EQ(rows(), 1);
    panel.append({samples::logEntry(5, Severity::Warning, QStringLiteral("shell"), QStringLiteral("STOP is latched"))});
    EXPECT_EQ(rows(), 1);
    source.setCurrentIndex(1);
    EXPECT_EQ(rows(), 2) << "the shell asks as the operator";
}

TEST_F(LogTest, FiltersBySeverityAndText)
{
    show();
    QTest::mouseClick(&on<QCheckBox>(events()), Qt::LeftButton, {}, {8, 22});
    EXPECT_EQ(rows(), 2);
    QTest::keyClicks(&on<QLineEdit>(events()), QStringLiteral("TEMPERATURE"));
    EXPECT_EQ(rows(), 1);
    EXPECT_TRUE(cell(0, LogModel::Text).startsWith(QStringLiteral("■")));
}

TEST_F(LogTest, NamesAClientByItsPortInTheNarrowColumn)
{
    EXPECT_EQ(cell(0, LogModel::From), QStringLiteral("operator"));
    EXPECT_EQ(cell(1, LogModel::From), QStringLiteral("rotctld :40112"));
    on<QLineEdit>(events()).setText(QStringLiteral("10.0.0.7"));
    EXPECT_EQ(rows(), 1) << "the filter looks at the whole source";
}

// REQ-UI-27: For every start of a motion the log shows who asked for it and why. When a new station starts to count
// again, no line is lost or out of order.
TEST_F(LogTest, TellsWhyItMovedFromTheMotionStartsAlone)
{
    show();
    const auto choices = panel.findChildren<ChoiceButton*>();
    const auto why = std::find_if(choices.begin(), choices.end(), [](const ChoiceButton* choice) {
        return choice->text() == QLatin1String("Why did it move?");
    });
    ASSERT_NE(why, choices.end());
    EXPECT_TRUE(events().isVisible());
    QTest::mouseClick(*why, Qt::LeftButton);
    EXPECT_TRUE(panel.motions().isVisible());
    EXPECT_FALSE(events().isVisible());
    EXPECT_EQ(panel.motions().shown().rowCount(), 1);
    clickRow(on<QTableView>(panel.motions()), 0);
    EXPECT_EQ(on<QPlainTextEdit>(panel.motions()).toPlainText(),
              QStringLiteral("17:06:01Z  rotctld 10.0.0.7:40112\n"
                             "moves the mount from 0.00° 0.00°: go to 339.50° 57.00°"));
    // By keys too: an arrow key goes to the next choice.
    (*why)->setFocus();
    QTest::keyClick(*why, Qt::Key_Right);
    EXPECT_TRUE(events().isVisible());
}

// Story: in the narrow column of the window half of the lines ended in dots, and below the list the text ended after
// its third line.
// REQ-UI-26
TEST_F(LogTest, ShowsTheCurrentLineWholeHoweverLong)
{
    show();
    auto& table = on<QTableView>(events());
    auto& whole = on<QPlainTextEdit>(events());
    const QString alarm =
        QStringLiteral("No reply from the elevation drive. Motion ended; the drive stops itself by its watchdog. ")
            .repeated(8) +
        QStringLiteral("Then re-arm.");
    panel.append({samples::logEntry(5, Severity::Alarm, QStringLiteral("elevation drive"), alarm)});
    QTest::keyClick(&table, Qt::Key_End, Qt::ControlModifier);
    EXPECT_TRUE(whole.toPlainText().endsWith(alarm));
    whole.setFocus();
    EXPECT_LT(whole.verticalScrollBar()->value(), whole.verticalScrollBar()->maximum());
    for (int page = 0; page < 8; ++page) {
        QTest::keyClick(&whole, Qt::Key_PageDown);
    }
    EXPECT_EQ(whole.verticalScrollBar()->value(), whole.verticalScrollBar()->maximum()) << "its end can be read";
    QTest::keyClick(&whole, Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_TRUE(table.hasFocus()) << "no focus trap";
    on<QComboBox>(events()).setCurrentIndex(1);
    table.selectRow(0);
    EXPECT_TRUE(whole.toPlainText().endsWith(QStringLiteral("park"))) << "the row of the filter, not of the log";
}

// Story: lines arrived while another panel was open. When the log was opened they were below the edge of the list.
// REQ-UI-26: The log opens at its newest line, stays there until it is scrolled away, and shows the complete selected
// line, however long it is.
TEST_F(LogTest, OpensAtTheNewestLineAndStaysThereUntilScrolledAway)
{
    std::vector<LogEntry> many;
    for (std::uint64_t number = 5; number <= 60; ++number) {
        many.push_back(
            samples::logEntry(number, Severity::Advisory, QStringLiteral("operator"), QString::number(number)));
    }
    panel.append(many);
    show();
    const QScrollBar& bar = *on<QTableView>(events()).verticalScrollBar();
    ASSERT_GT(bar.maximum(), 0);
    EXPECT_EQ(bar.value(), bar.maximum());
    const auto add = [this](std::uint64_t number) {
        panel.append({samples::logEntry(number, Severity::Advisory, QStringLiteral("operator"), QStringLiteral("x"))});
        settle();
    };
    add(61);
    EXPECT_EQ(bar.value(), bar.maximum());
    QTest::keyClick(&on<QTableView>(events()), Qt::Key_End, Qt::ControlModifier);
    QTest::keyClick(&on<QTableView>(events()), Qt::Key_Home, Qt::ControlModifier);
    add(62);
    EXPECT_EQ(bar.value(), 0) << "who reads is left alone";
}

TEST_F(LogTest, CopiesTheSelectionElseAllThatIsShownWithDate)
{
    show();
    on<QComboBox>(events()).setCurrentIndex(2);
    press(events(), "Copy");
    EXPECT_EQ(QApplication::clipboard()->text(),
              QStringLiteral(
                  "2026-11-21 17:06:01.000Z  rotctld 10.0.0.7:40112  moves the mount from 0.00° 0.00°: go to 339.50° "
                  "57.00°\n"
                  "2026-11-21 17:06:03.000Z  rotctld 10.0.0.8:40113  dropped: line longer than 1000 bytes\n"));
    clickRow(on<QTableView>(events()), 1);
    QTest::keyClick(&on<QTableView>(events()), Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QApplication::clipboard()->text().count(QLatin1Char('\n')), 1);
}

TEST_F(LogTest, SavesTheShownLinesToAFileOrSaysWhyNot)
{
    show();
    const QTemporaryDir folder;
    const auto saveAs = [this](const QString& path) {
        press(events(), "File …");
        chooseFile(panel, path);
        EXPECT_TRUE(comesTrue([this] { return panel.findChild<QFileDialog*>() == nullptr; }));
    };
    saveAs(folder.filePath(QStringLiteral("nowhere/night.txt")));
    EXPECT_TRUE(outcome().startsWith(QStringLiteral("Not written: "))) << outcome().toStdString();
    on<QLineEdit>(events()).setText(QStringLiteral("over"));
    saveAs(folder.filePath(QStringLiteral("night.txt")));
    QFile file(folder.filePath(QStringLiteral("night.txt")));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(outcome(), QStringLiteral("Lines written: 1"));
    EXPECT_EQ(file.readAll(), QByteArray("2026-11-21 17:06:02.000Z  azimuth drive  fault 38: over temperature\n"));
}

// Story: after Reconnect a new station counts its lines from 1 again.
// REQ-UI-27
TEST_F(LogTest, KeepsEveryLineInItsOrderWhenANewStationCountsFromOneAgain)
{
    panel.append({samples::logEntry(1, Severity::Advisory, QStringLiteral("station"), QStringLiteral("begins again")),
                  samples::logEntry(2, Severity::Advisory, QStringLiteral("operator"), QStringLiteral("park"))});
    ASSERT_EQ(rows(), 6);
    EXPECT_EQ(cell(0, LogModel::Text), QStringLiteral("park"));
    EXPECT_TRUE(cell(3, LogModel::Text).contains(QStringLiteral("dropped")));
    EXPECT_EQ(cell(4, LogModel::Text), QStringLiteral("begins again"));
    EXPECT_EQ(cell(5, LogModel::Text), QStringLiteral("park"));
}

TEST_F(LogTest, KeepsABoundedTail)
{
    std::vector<LogEntry> many;
    for (std::uint64_t number = 5; number <= 6000; ++number) {
        many.push_back(
            samples::logEntry(number, Severity::Advisory, QStringLiteral("operator"), QString::number(number)));
    }
    panel.append(many);
    EXPECT_EQ(rows(), 5000);
    EXPECT_EQ(cell(rows() - 1, LogModel::Text), QStringLiteral("6000"));
}

using LogInWindowTest = WindowFixture;

// Story: at 1280×800 the last line of the page was cut in half, and the page scrolled by some pixels.
// REQ-UI-1792: Each page of the log fits into a window of 1280×800 without a scroll bar, also with an alarm.
TEST_F(LogInWindowTest, ThePagesFitWithoutAScrollBar)
{
    window.resize(1280, 800);
    openPanel('5');
    const auto* const log = window.findChild<LogPanel*>();
    const auto* const room = qobject_cast<QScrollArea*>(log->parentWidget()->parentWidget());
    ASSERT_NE(room, nullptr);
    const auto choices = log->findChildren<ChoiceButton*>();
    ASSERT_EQ(choices.size(), 3);
    for (const StationStatus& status : {samples::idle(), samples::faulted()}) {
        give(samples::update(status));
        for (ChoiceButton* const choice : choices) {
            choice->click();
            settle();
            EXPECT_EQ(room->verticalScrollBar()->maximum(), 0) << choice->text().toStdString();
        }
    }
}

}  // namespace
}  // namespace boresight::ui
