// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl export and replay, started as from a shell.
#include "core/recording/record_writer.h"
#include "tests/app/ctl_outcome.h"
#include "tests/core/recording/recorded_pass.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class CtlRecordingTest : public testing::Test
{
protected:
    [[nodiscard]] QString write(const QByteArray& bytes) const
    {
        QFile file(m_folder.filePath(QStringLiteral("one.recording")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        EXPECT_EQ(file.write(bytes), bytes.size());
        return file.fileName();
    }
    static QByteArray twoSeconds()
    {
        return recording::fileStart(recording::recordedHeader()) +
               recording::tickBlock(recording::RecordedPass().ticks(101));
    }

    QTemporaryDir m_folder;
};

}  // namespace

// REQ-RECORD-10
TEST_F(CtlRecordingTest, ExportPrintsARecording)
{
    const QString file = write(twoSeconds() + recording::fileEnd());
    const Outcome csv = ctl({QStringLiteral("export"), file});
    EXPECT_EQ(csv.status, 0) << csv.errors;
    EXPECT_THAT(csv.output, StartsWith("t_utc,state,actual_azimuth_deg,"));
    EXPECT_EQ(std::count(csv.output.begin(), csv.output.end(), '\n'), 102);
    const Outcome info = ctl({QStringLiteral("export"), file, QStringLiteral("--what"), QStringLiteral("info"),
                              QStringLiteral("--format"), QStringLiteral("table")});
    EXPECT_THAT(info.output, HasSubstr("NOAA 19"));
}

// REQ-RECORD-11
TEST_F(CtlRecordingTest, ReplayPrintsStatusLines)
{
    const QString file = write(twoSeconds() + recording::fileEnd());
    const Outcome replay = ctl({QStringLiteral("replay"), file, QStringLiteral("--speed"), QStringLiteral("60")});
    EXPECT_EQ(replay.status, 0) << replay.errors;
    EXPECT_EQ(std::count(replay.output.begin(), replay.output.end(), '\n'), 3);
    EXPECT_THAT(replay.output, HasSubstr("  off by 0.0"));
}

TEST_F(CtlRecordingTest, WhatIsDamagedIsNamed)
{
    const Outcome cut = ctl({QStringLiteral("export"), write(twoSeconds())});
    EXPECT_EQ(cut.status, 1);
    EXPECT_EQ(std::count(cut.output.begin(), cut.output.end(), '\n'), 102);
    EXPECT_THAT(cut.errors, HasSubstr("the recording has no end"));
    const Outcome foreign = ctl({QStringLiteral("replay"), write("one,two\n")});
    EXPECT_EQ(foreign.status, 1);
    EXPECT_THAT(foreign.errors, HasSubstr("one.recording: this is not a recording"));
    EXPECT_EQ(ctl({QStringLiteral("export")}).status, 2);
}

}  // namespace boresight
