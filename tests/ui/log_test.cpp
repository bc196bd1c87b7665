// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_status.h"
#include "ui/log_panel.h"
#include "ui/value_label.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

class LogTest : public ::testing::Test
{
protected:
    LogTest()
    {
        panel.append({samples::logEntry(1, Severity::Advisory, QStringLiteral("operator"), QStringLiteral("park")),
                      samples::logEntry(2, Severity::Advisory, QStringLiteral("rotctld 10.0.0.7:40112"),
                                        QStringLiteral("P 339.5 57.0: accepted")),
                      samples::logEntry(3, Severity::Alarm, QStringLiteral("azimuth drive"),
                                        QStringLiteral("fault 38: over temperature")),
                      samples::logEntry(4, Severity::Warning, QStringLiteral("rotctld 10.0.0.8:40113"),
                                        QStringLiteral("dropped: line longer than 1000 bytes"))});
        panel.resize(480, 300);
        panel.show();
    }
    int rows() const { return panel.shown().rowCount(); }
    LogPanel panel;
};

TEST_F(LogTest, FiltersBySource)
{
    auto* const source = panel.findChild<QComboBox*>();
    EXPECT_EQ(rows(), 4);
    source->setCurrentIndex(1);
    EXPECT_EQ(rows(), 1);
    source->setCurrentIndex(2);
    EXPECT_EQ(rows(), 2);
    source->setCurrentIndex(3);
    EXPECT_EQ(rows(), 1);
}

TEST_F(LogTest, FiltersBySeverityAndText)
{
    panel.findChild<QCheckBox*>()->setChecked(true);
    EXPECT_EQ(rows(), 2);
    panel.findChild<QLineEdit*>()->setText(QStringLiteral("TEMPERATURE"));
    EXPECT_EQ(rows(), 1);
    EXPECT_TRUE(panel.shown().index(0, LogModel::Text).data().toString().startsWith(QStringLiteral("■")));
}

// Story: in the window's narrow column half of the lines ended in dots.
TEST_F(LogTest, ShowsTheCurrentLineWhole)
{
    const QString alarm = QStringLiteral(
        "No reply from the elevation drive. Motion ended; the drive, if it has power, stops itself by its watchdog "
        "(0.1 s). "
        "Check the supply, the CAN cable and the adapter, then re-arm");
    panel.append({samples::logEntry(5, Severity::Alarm, QStringLiteral("elevation drive"), alarm)});
    auto* const table = panel.findChild<QTableView*>();
    const auto* const whole = panel.findChild<ValueLabel*>();
    table->selectRow(4);
    EXPECT_EQ(whole->text(), alarm);
    EXPECT_FALSE(whole->isElided());
    panel.findChild<QComboBox*>()->setCurrentIndex(1);
    table->selectRow(0);
    EXPECT_EQ(whole->text(), QStringLiteral("park")) << "the row of the filter, not of the log";
}

TEST_F(LogTest, CopiesTheSelectionElseAllThatIsShownWithDate)
{
    auto* const copy = panel.findChild<QPushButton*>();
    panel.findChild<QComboBox*>()->setCurrentIndex(2);
    QTest::mouseClick(copy, Qt::LeftButton);
    EXPECT_EQ(
        QApplication::clipboard()->text(),
        QStringLiteral("2026-11-21 17:06:01.000Z  rotctld 10.0.0.7:40112  P 339.5 57.0: accepted\n"
                       "2026-11-21 17:06:03.000Z  rotctld 10.0.0.8:40113  dropped: line longer than 1000 bytes\n"));
    panel.findChild<QTableView*>()->selectRow(1);
    QTest::mouseClick(copy, Qt::LeftButton);
    EXPECT_EQ(QApplication::clipboard()->text().count(QLatin1Char('\n')), 1);
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
    EXPECT_EQ(panel.shown().index(rows() - 1, LogModel::Text).data().toString(), QStringLiteral("6000"));
}

}  // namespace
}  // namespace boresight::ui
