// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl report, started as from a shell, on a computer without the desktop program.
#include "tests/app/ctl_outcome.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::HasSubstr;

TEST(CtlReport, NamesWhatIsMissingInItsCommandLine)
{
    EXPECT_EQ(ctl(words("report")).status, 2);
    EXPECT_THAT(ctl(words("report a.recording")).errors, HasSubstr("--out is missing"));
    EXPECT_THAT(ctl(words("report --out a.pdf")).errors, HasSubstr("name one recording, or two to compare"));
    EXPECT_THAT(ctl(words("report a b c --out a.pdf")).errors, HasSubstr("name one recording, or two to compare"));
    EXPECT_THAT(ctl(words("report a --into a.pdf")).errors, HasSubstr("unknown option --into"));
}

// REQ-CTL-1040: `report` needs the desktop program, because boresightctl links nothing graphical. Without this program
// a sentence says what to install.
TEST(CtlReport, SaysThatTheDesktopProgramIsNotInstalled)
{
    const QTemporaryDir folder;
    const QString alone = folder.filePath(QStringLiteral("boresightctl"));
    ASSERT_TRUE(QFile::copy(QStringLiteral(BORESIGHTCTL), alone));
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", folder.path().toLocal8Bit());
    fakes::Program program(alone, words("report a.recording --out a.pdf"));
    EXPECT_EQ(program.waitForEnd(), 1);
    qputenv("PATH", path);
    EXPECT_THAT(program.errors().toStdString(),
                HasSubstr("the desktop program \"boresight\" is not installed on this computer"));
}

}  // namespace
}  // namespace boresight
