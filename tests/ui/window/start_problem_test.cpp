// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/start_problem.h"

#include "tests/ui/event_loop.h"
#include "tests/ui/find_widget.h"

#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

QPushButton& buttonOf(const StartProblem& problem, const char* text)
{
    for (QPushButton* const button : problem.findChildren<QPushButton*>()) {
        if (button->text() == QString::fromUtf8(text)) {
            return *button;
        }
    }
    throw std::runtime_error(std::string("no button ") + text);
}

// REQ-UI-801 (StartProblem.*): A program that cannot start shows a window with the complete reason, what Boresight did,
// and what to do. It starts with another profile, or quits.
TEST(StartProblem, ShowsTheReasonAsItIsAndQuits)
{
    const QString reason = QStringLiteral("mount.toml:3: azimuth.id: \"<b>one</b>\" is not a number");
    StartProblem problem(reason);
    problem.show();
    EXPECT_EQ(problem.windowTitle(), QStringLiteral("Boresight cannot start"));
    auto* const text = problem.findChild<QLabel*>(QStringLiteral("reason"));
    ASSERT_NE(text, nullptr);
    EXPECT_EQ(text->text(), reason + QLatin1Char('.'));
    EXPECT_EQ(text->textFormat(), Qt::PlainText);
    EXPECT_TRUE(text->textInteractionFlags().testFlag(Qt::TextSelectableByMouse));
    for (const char* const sentence : {"action", "remedy"}) {
        EXPECT_FALSE(problem.findChild<QLabel*>(QLatin1String(sentence))->text().isEmpty());
    }
    QTest::mouseClick(&buttonOf(problem, "Quit"), Qt::LeftButton);
    EXPECT_FALSE(problem.isVisible());
    EXPECT_TRUE(problem.chosenProfile().isEmpty());
}

TEST(StartProblem, StartsWithAnotherProfile)
{
    QTemporaryDir folder;
    const QString other = folder.filePath(QStringLiteral("other.toml"));
    ASSERT_TRUE(QFile(other).open(QIODevice::WriteOnly));
    StartProblem problem(QStringLiteral("mount.toml: not found"));
    problem.show();
    QTest::mouseClick(&buttonOf(problem, "Choose another profile …"), Qt::LeftButton);
    chooseFile(problem, other);
    EXPECT_EQ(problem.chosenProfile(), other);
    EXPECT_FALSE(problem.isVisible());
}

TEST(StartProblem, IsWholeAlsoWhenTheReasonIsLong)
{
    StartProblem problem(QStringLiteral("mount.toml:3: azimuth.id: a very long reason. ").repeated(12));
    problem.show();
    settle();
    for (const QLabel* const label : problem.findChildren<QLabel*>()) {
        EXPECT_LE(label->heightForWidth(label->width()), label->height()) << label->text().toStdString();
    }
}

}  // namespace
}  // namespace boresight::ui
