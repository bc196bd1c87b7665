// SPDX-License-Identifier: GPL-3.0-or-later
// boresight started from a menu or a terminal.
#include "tests/fakes/program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::HasSubstr;
using testing::Not;

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

    [[nodiscard]] QString simulationOf(const QString& mount) const
    {
        return m_home.filePath(QStringLiteral("boresight/simulated/%1.toml").arg(mount));
    }

    static QByteArray contentOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    // Runs until it has shown a status of the station. Returns what it reported meanwhile.
    static std::string runWith(const QStringList& arguments)
    {
        qputenv("BORESIGHT_STARTUP_TIMING", "1");
        fakes::Program program(QStringLiteral(BORESIGHT),
                               arguments + QStringList{QStringLiteral("--listen"), QStringLiteral("127.0.0.1:0")});
        EXPECT_TRUE(program.waitForError(QStringLiteral("first picture after"))) << program.errors().toStdString();
        program.terminate();
        EXPECT_EQ(program.waitForEnd(), 0) << program.errors().toStdString();
        return program.errors().toStdString();
    }

private:
    QTemporaryDir m_home;
};

TEST_F(StartTest, ASimulatedMountHasAProfileOfItsOwn)
{
    const QByteArray real = "version = 1\n[mount]\nname = \"roof\"\n[bus]\nname = \"fdcanusb:/dev/nothing\"\n";
    const QString file = keep(real);
    EXPECT_THAT(runWith({QStringLiteral("--simulate")}), Not(HasSubstr("names no bus")));
    EXPECT_EQ(contentOf(file), real);
    EXPECT_THAT(contentOf(simulationOf(QStringLiteral("roof"))).toStdString(), HasSubstr("name = \"simulated\""));
}

TEST_F(StartTest, AProfileThatNamesNoRealBusIsSimulatedAndSaysSo)
{
    const QByteArray old = "version = 1\n[mount]\nname = \"tried\"\n[bus]\nname = \"simulated\"\n";
    const QString file = keep(old);
    EXPECT_THAT(runWith({}),
                HasSubstr(file.toStdString() + " names no bus of a real mount, so the mount is simulated"));
    EXPECT_EQ(contentOf(file), old);
    EXPECT_FALSE(contentOf(simulationOf(QStringLiteral("tried"))).isEmpty());
}

TEST_F(StartTest, ABrokenProfileIsSaidInAWindowThatStaysUntilItIsClosed)
{
    const QString file = keep("version = 1\n[azimuth]\nmax_speed_deg_s = \"fast\"\n");
    fakes::Program program(QStringLiteral(BORESIGHT), {});
    const QString reason = file + QStringLiteral(":3: azimuth.max_speed_deg_s: a number is expected");
    EXPECT_TRUE(program.waitForError(QStringLiteral("boresight: the window shows: ") + reason))
        << program.errors().toStdString();
    program.terminate();  // as at the end of a session, with the window still open
    EXPECT_EQ(program.waitForEnd(), 2) << "the event loop ended it, and not the signal";
}

TEST_F(StartTest, AProfileThatWasNamedIsSaidInAWindowToo)
{
    const QString file = keep("version = 1\n[azimuth]\nmax_speed_deg_s = \"fast\"\n");
    fakes::Program program(QStringLiteral(BORESIGHT), {QStringLiteral("--profile"), file});
    EXPECT_TRUE(program.waitForError(QStringLiteral("boresight: the window shows: ") + file +
                                     QStringLiteral(":3: azimuth.max_speed_deg_s: ")))
        << program.errors().toStdString();
    program.terminate();
    EXPECT_EQ(program.waitForEnd(), 2);
}

TEST_F(StartTest, WhatWasTypedWrongIsSaidInTheTerminalAlone)
{
    fakes::Program program(QStringLiteral(BORESIGHT), {QStringLiteral("--listen"), QStringLiteral("nowhere")});
    EXPECT_EQ(program.waitForEnd(), 2);
    EXPECT_THAT(program.errors().toStdString(), HasSubstr("--listen: "));
    EXPECT_THAT(program.errors().toStdString(), Not(HasSubstr("the window shows")));
}

}  // namespace
}  // namespace boresight
