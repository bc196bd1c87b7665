// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_progress.h"
#include "ui/manual/manual_pdf.h"
#include "ui/manual/manual_window.h"

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

class ManualTest : public testing::Test
{
protected:
    ManualTest() { m_window.show(); }

    QTextBrowser& text() { return *m_window.findChild<QTextBrowser*>(); }
    QListWidget& contents() { return *m_window.findChild<QListWidget*>(); }
    void search(const QString& wanted)
    {
        m_window.findChild<QLineEdit*>()->setText(wanted);
        m_window.findNext();
    }
    QString notice() { return m_window.findChild<QLabel*>()->text(); }

    ManualWindow m_window;
};

QString readResource(const QString& path)
{
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return QString::fromUtf8(file.readAll());
}

// REQ-UI-1000: The manual lists its chapters. A click on one brings its heading to the top.
TEST_F(ManualTest, AChapterOfTheContentsComesToTheTop)
{
    const auto found = contents().findItems(QStringLiteral("Find north"), Qt::MatchContains);
    ASSERT_EQ(found.size(), 1);
    contents().setCurrentItem(found.front());
    EXPECT_EQ(text().textCursor().block().text(), QStringLiteral("Find north"));
    EXPECT_LT(text().cursorRect().top(), 8);
}

// REQ-UI-1001: A search finds the next match, starts again after the last one, and reports if there is none.
TEST_F(ManualTest, TheSearchGoesOnAtTheBeginning)
{
    search(QStringLiteral("Not yet in any manual"));
    EXPECT_FALSE(notice().isEmpty());
    search(QStringLiteral("leap second"));
    const int place = text().textCursor().position();
    EXPECT_GT(place, 0);
    EXPECT_TRUE(notice().isEmpty());
    search(QStringLiteral("leap second"));
    EXPECT_EQ(text().textCursor().position(), place) << "it stands once in the book";
}

// REQ-UI-1002: Every picture and page that the manual names is in the program.
TEST(ManualBook, HasEveryPictureAndPageThatItNames)
{
    const QString book = readResource(QStringLiteral(":/boresight/manual/manual.md"));
    static const QRegularExpression link(QStringLiteral(R"(\]\(([^)#:]+)\))"));
    int links = 0;
    for (auto found = link.globalMatch(book); found.hasNext(); ++links) {
        const QString target = found.next().captured(1);
        EXPECT_TRUE(QFile::exists(QStringLiteral(":/boresight/manual/") + target)) << target.toStdString();
    }
    EXPECT_GT(links, 2);
}

// Story: the manual listed ten steps and the window nine, and six of them had other names.
// REQ-UI-1410: The manual lists the steps of the guide with the names and in the order of the window.
TEST(ManualBook, NamesTheStepsOfTheGuideAsTheWindowDoes)
{
    const QString book = readResource(QStringLiteral(":/boresight/manual/manual.md"));
    const QString chapter = book.section(QStringLiteral("## The guide\n"), 1).section(QStringLiteral("\n## "), 0, 0);
    static const QRegularExpression item(QStringLiteral(R"(^\d+\. \*\*([^*]+)\*\*:)"),
                                         QRegularExpression::MultilineOption);
    QStringList listed;
    for (auto found = item.globalMatch(chapter); found.hasNext();) {
        listed << found.next().captured(1);
    }
    QStringList steps;
    for (const GuideStep step : kGuideSteps) {
        steps << name(step);
    }
    EXPECT_EQ(listed.join(QLatin1Char('\n')).toStdString(), steps.join(QLatin1Char('\n')).toStdString());
}

// REQ-UI-1003: The manual is written as PDF. A file that cannot be written is named with the reason.
TEST(ManualPdf, IsABookOfSeveralPages)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("manual.pdf"));
    ASSERT_TRUE(writeManualPdf(path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray pdf = file.readAll();
    EXPECT_TRUE(pdf.startsWith("%PDF"));
    EXPECT_GE(pdf.count("/Type /Page\n"), 5);
    const Result<> refused = writeManualPdf(folder.filePath(QStringLiteral("absent/manual.pdf")));
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().text.contains(QStringLiteral("absent/manual.pdf")));
}

}  // namespace
}  // namespace boresight::ui
