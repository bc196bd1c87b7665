// SPDX-License-Identifier: GPL-3.0-or-later
// boresight as a menu starts it, without any argument, when it cannot start.
#include "tests/fakes/program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::HasSubstr;

class StartTest : public testing::Test
{
protected:
    StartTest()
    {
        for (const auto& [name, value] :
             {std::pair("XDG_CONFIG_HOME", m_home.path()), std::pair("XDG_STATE_HOME", m_home.path()),
              std::pair("QT_QPA_PLATFORM", QStringLiteral("offscreen"))}) {
            qputenv(name, value.toUtf8());
        }
    }

    [[nodiscard]] QString keep(const QByteArray& profile) const
    {
        const QString folder = m_home.filePath(QStringLiteral("boresight/profiles"));
        QDir().mkpath(folder);
        QFile file(folder + QStringLiteral("/mount.toml"));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(profile);
        return file.fileName();
    }

private:
    QTemporaryDir m_home;
};

TEST_F(StartTest, ABrokenProfileIsSaidInAWindowThatStaysUntilItIsClosed)
{
    const QString file = keep("version = 1\n[azimuth]\nmax_speed_deg_s = \"fast\"\n");
    fakes::Program program(QStringLiteral(BORESIGHT), {});
    const QString reason = file + QStringLiteral(":3: azimuth.max_speed_deg_s: a number is expected");
    EXPECT_TRUE(program.waitForError(QStringLiteral("boresight: the window says: ") + reason))
        << program.errors().toStdString();
    program.terminate();  // as at the end of a session, with the window still open
    EXPECT_EQ(program.waitForEnd(), 2) << "the event loop ended it, and not the signal";
}

TEST_F(StartTest, FromATerminalItIsSaidThereAlone)
{
    const QString file = keep("version = 1\n[azimuth]\nmax_speed_deg_s = \"fast\"\n");
    fakes::Program program(QStringLiteral(BORESIGHT), {QStringLiteral("--profile"), file});
    EXPECT_EQ(program.waitForEnd(), 2);
    EXPECT_THAT(program.errors().toStdString(), HasSubstr(file.toStdString() + ":3: azimuth.max_speed_deg_s: "));
}

}  // namespace
}  // namespace boresight
