// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl report with the desktop program beside it, started as from a shell.
#include "core/recording/record_writer.h"
#include "tests/core/recording/recorded_pass.h"
#include "tests/fakes/program.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::HasSubstr;

class ReportProgramTest : public testing::Test
{
protected:
    // Without a display, even that of the tests.
    void SetUp() override { qunsetenv("QT_QPA_PLATFORM"); }
    void TearDown() override { qputenv("QT_QPA_PLATFORM", "offscreen"); }

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    [[nodiscard]] QString keep(const char* name, const QByteArray& bytes) const
    {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return file.fileName();
    }
    [[nodiscard]] QByteArray read(const char* name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static QByteArray recorded(std::size_t ticks)
    {
        QByteArray bytes = recording::fileStart(recording::recordedHeader());
        if (ticks > 0) {
            bytes += recording::tickBlock(recording::RecordedPass().ticks(ticks));
        }
        return bytes + recording::fileEnd();
    }
    struct Ended
    {
        int status;
        std::string errors;
    };
    [[nodiscard]] Ended report(const QStringList& files, const char* out) const
    {
        fakes::Program program(QStringLiteral(BORESIGHTCTL), QStringList{QStringLiteral("report")} + files +
                                                                 QStringList{QStringLiteral("--out"), path(out)});
        const int status = program.waitForEnd();
        return {status, program.errors().toStdString()};
    }

private:
    QTemporaryDir m_folder;
};

// REQ-CTL-1041: `report` writes the report of one recording, or of two side by side, on a computer without a display.
TEST_F(ReportProgramTest, WritesAPageWithoutADisplay)
{
    const QString pass = keep("pass.recording", recorded(500));
    const Ended one = report({pass}, "one.pdf");
    EXPECT_EQ(one.status, 0) << one.errors;
    EXPECT_TRUE(read("one.pdf").startsWith("%PDF-"));
    const Ended two = report({pass, keep("second.recording", recorded(300))}, "two.png");
    EXPECT_EQ(two.status, 0) << two.errors;
    EXPECT_TRUE(read("two.png").startsWith("\x89PNG"));
}

// REQ-CTL-1042: `report` names the recording that has no ticks or is none, and writes no file. For a damaged recording
// it writes the report, names the damage, and ends with the status 1.
TEST_F(ReportProgramTest, NamesWhatIsWrongWithARecording)
{
    const Ended none = report({keep("notes.txt", "Not a recording")}, "none.pdf");
    EXPECT_EQ(none.status, 1);
    EXPECT_THAT(none.errors, HasSubstr("notes.txt"));
    const Ended empty = report({keep("empty.recording", recorded(0))}, "none.pdf");
    EXPECT_EQ(empty.status, 1);
    EXPECT_THAT(empty.errors, HasSubstr("empty.recording: The recording has no ticks."));
    EXPECT_FALSE(QFile::exists(path("none.pdf")));
    QByteArray damaged = recorded(500);
    const QByteArray more = recording::tickBlock(recording::RecordedPass().ticks(10));
    damaged += more.first(more.size() - 5);
    const Ended cut = report({keep("cut.recording", damaged)}, "cut.pdf");
    EXPECT_EQ(cut.status, 1);
    EXPECT_THAT(cut.errors, HasSubstr("cut.recording: "));
    EXPECT_TRUE(read("cut.pdf").startsWith("%PDF-"));
}

}  // namespace
}  // namespace boresight
