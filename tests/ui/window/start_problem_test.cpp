// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/start_problem.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

TEST(StartProblem, ShowsTheReasonAsItIsAndEndsWithItsButton)
{
    const QString reason = QStringLiteral("mount.toml:3: azimuth.id: \"<b>one</b>\" is not a number");
    StartProblem problem(reason);
    problem.show();
    EXPECT_EQ(problem.windowTitle(), QStringLiteral("Boresight cannot start"));
    auto* const text = problem.findChild<QLabel*>(QStringLiteral("qt_msgbox_label"));
    ASSERT_NE(text, nullptr);
    EXPECT_EQ(text->text(), reason);
    EXPECT_EQ(text->textFormat(), Qt::PlainText);
    EXPECT_TRUE(text->textInteractionFlags().testFlag(Qt::TextSelectableByMouse));
    QTest::mouseClick(problem.button(QMessageBox::Ok), Qt::LeftButton);
    EXPECT_FALSE(problem.isVisible());
}

}  // namespace
}  // namespace boresight::ui
