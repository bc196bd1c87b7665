// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"
#include "tests/system/programs/boresightd_process.h"

#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTcpServer>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

// Hamlib's own drivers for serial rotators from Debian drive boresightd through its further listeners: by the link to a
// pseudo-terminal like a serial port, and by TCP.
namespace boresight::system_test {
namespace {

// The tolerance for a reading at the target, by the digits of the protocol.
constexpr double kWholeDegrees = 1e-6;
constexpr double kTenths = 0.15;

struct Outcome
{
    int exitCode = -1;
    QString said;
};

struct AzEl
{
    double azimuth;
    double elevation;
};

class HamlibSerial : public ::testing::Test
{
protected:
    void SetUp() override
    {
        if (QStandardPaths::findExecutable(QStringLiteral("rotctl")).isEmpty()) {
            GTEST_SKIP() << "rotctl is not installed (Debian package libhamlib-utils)";
        }
        QFile profile(folder.filePath(QStringLiteral("profile.toml")));
        ASSERT_TRUE(profile.open(QIODevice::WriteOnly));
        profile.write(QStringLiteral("version = 1\n[listeners]\nlist = [\n"
                                     "\"gs232a drive pty:%1\", \"gs232b drive pty:%2\", \"gs232b read pty:%3\",\n"
                                     "\"gs232b drive tcp:%4\", \"easycomm1 drive pty:%5\", "
                                     "\"easycomm2 drive pty:%6\", \"easycomm3 drive pty:%7\",\n"
                                     "\"easycomm3 drive tcp:%8\"]\n")
                          .arg(a, b, reading, tcp, easycomm1, easycomm2, easycomm3, easycommTcp)
                          .toUtf8());
        profile.close();
        boresightd = std::make_unique<BoresightdProcess>(
            QStringList{QStringLiteral("--simulate"), QStringLiteral("--profile"), profile.fileName()});
        ASSERT_TRUE(boresightd->listens()) << boresightd->complaints();
        ASSERT_TRUE(fakes::waitUntil([&] { return QFileInfo(reading).isSymLink(); }));
        client = boresightd->connect();
        ASSERT_TRUE(fakes::waitUntil([&] { return client->ask("p\n", 2).find("RPRT") == std::string::npos; }))
            << "the drives do not answer";
    }

    // One run of Hamlib's driver with these commands.
    [[nodiscard]] static Outcome rotctl(const QString& model, const QString& where, const QString& commands)
    {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(QStringLiteral("rotctl"), QStringList{QStringLiteral("-m"), model, QStringLiteral("-r"), where} +
                                                    commands.split(QLatin1Char(' ')));
        const bool ended = fakes::waitUntil([&] { return process.state() == QProcess::NotRunning; });
        return {.exitCode = ended ? process.exitCode() : -1,
                .said = QString::fromUtf8(process.readAllStandardOutput())};
    }
    static void expectAccepted(const QString& model, const QString& where, const QString& commands)
    {
        const Outcome outcome = rotctl(model, where, commands);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.said.toStdString();
        EXPECT_FALSE(outcome.said.contains(QStringLiteral("error"))) << outcome.said.toStdString();
    }
    // The position of the mount, by our own protocol.
    [[nodiscard]] AzEl position() const
    {
        const QStringList lines = QString::fromStdString(client->ask("p\n", 2)).split(QLatin1Char('\n'));
        return {.azimuth = lines.value(0).toDouble(), .elevation = lines.value(1).toDouble()};
    }
    [[nodiscard]] bool isAt(AzEl place) const
    {
        const AzEl now = position();
        return std::abs(std::remainder(now.azimuth - place.azimuth, 360.0)) < 0.1 &&
               std::abs(now.elevation - place.elevation) < 0.1;
    }
    // If a busy computer starves the simulated drives, their watchdog ends the motion. Then they are re-armed.
    [[nodiscard]] bool wantsReArm()
    {
        log += boresightd->complaints();
        return log.find("Then press Re-arm", armed) != std::string::npos;
    }
    void reArm()
    {
        armed = log.size();
        EXPECT_TRUE(fakes::waitUntil([&] { return client->ask("R 1\n") == "RPRT 0\n"; }));
    }
    [[nodiscard]] bool points(const QString& model, const QString& where, AzEl place)
    {
        constexpr int kPatience = 12;
        constexpr std::chrono::seconds kOneTry{15};  // a motion takes some seconds
        for (int i = 0; i < kPatience; ++i) {
            expectAccepted(model, where, QStringLiteral("P %1 %2").arg(place.azimuth).arg(place.elevation));
            static_cast<void>(fakes::waitUntil([&] { return isAt(place) || wantsReArm(); }, kOneTry));
            if (isAt(place)) {
                return true;
            }
            reArm();
        }
        return false;
    }
    // The position as Hamlib's driver reads it. It may take a late reply to the previous program for its own reply.
    static void expectRead(const QString& model, const QString& where, AzEl place, double within = kWholeDegrees)
    {
        Outcome outcome;
        static_cast<void>(fakes::waitUntil([&] {
            outcome = rotctl(model, where, QStringLiteral("p"));
            return outcome.exitCode == 0;
        }));
        const QStringList lines = outcome.said.split(QLatin1Char('\n'));
        EXPECT_EQ(outcome.exitCode, 0) << outcome.said.toStdString();
        EXPECT_NEAR(std::remainder(lines.value(0).toDouble() - place.azimuth, 360.0), 0.0, within)
            << outcome.said.toStdString();
        EXPECT_NEAR(lines.value(1).toDouble(), place.elevation, within);
    }
    // Points twice, reads, and stops on the way to a third position.
    void drive(const QString& model, const QString& where, double within = kWholeDegrees)
    {
        SCOPED_TRACE(model.toStdString() + " " + where.toStdString());
        for (const AzEl place : {AzEl{20.0, 15.0}, AzEl{35.0, 22.0}}) {
            EXPECT_TRUE(points(model, where, place)) << log;
            expectRead(model, where, place, within);
        }
        expectAccepted(model, where, QStringLiteral("P 180 60"));
        expectAccepted(model, where, QStringLiteral("S"));
        const AzEl stopped = position();
        EXPECT_GT(std::abs(std::remainder(stopped.azimuth - 180.0, 360.0)), 20.0) << "S ended the way";
    }

    QTemporaryDir folder;
    QString a = folder.filePath(QStringLiteral("a"));
    QString b = folder.filePath(QStringLiteral("b"));
    QString reading = folder.filePath(QStringLiteral("reading"));
    QString tcp = QStringLiteral("127.0.0.1:%1").arg(fakes::unusedPort());
    QString easycomm1 = folder.filePath(QStringLiteral("easycomm1"));
    QString easycomm2 = folder.filePath(QStringLiteral("easycomm2"));
    QString easycomm3 = folder.filePath(QStringLiteral("easycomm3"));
    QString easycommTcp = QStringLiteral("127.0.0.1:%1").arg(fakes::unusedPort());
    std::unique_ptr<BoresightdProcess> boresightd;
    std::unique_ptr<fakes::TcpPeer> client;
    std::string log;
    std::size_t armed = 0;  // length of the log at the last re-arm
};

// REQ-GS232SERVER-06 (HamlibSerial.Gs232*): Hamlib's own unmodified drivers 601, 602, 603 and 606 point, read and stop
// the mount through the emulation, by a pseudo-terminal and by TCP. 604 points it.
TEST_F(HamlibSerial, Gs232AIsDriven)
{
    drive(QStringLiteral("601"), a);
    drive(QStringLiteral("602"), a);
    drive(QStringLiteral("606"), a);
    EXPECT_TRUE(points(QStringLiteral("604"), a, {10.0, 12.0})) << log;
}

TEST_F(HamlibSerial, Gs232BIsDriven)
{
    drive(QStringLiteral("603"), b);
    drive(QStringLiteral("603"), tcp);
}

TEST_F(HamlibSerial, Gs232TurnsUntilItsClientLeaves)
{
    const AzEl before = position();
    EXPECT_TRUE(fakes::waitUntil([&] {
        expectAccepted(QStringLiteral("603"), b, QStringLiteral("M 16 100 pause 1"));
        return position().azimuth != before.azimuth;
    }));
    EXPECT_TRUE(fakes::waitUntil([&] {
        const double first = position().azimuth;
        return first == position().azimuth;
    }));
}

TEST_F(HamlibSerial, Gs232ThatOnlyReadsIsRefused)
{
    const AzEl before = position();
    expectRead(QStringLiteral("603"), reading, {std::round(before.azimuth), std::round(before.elevation)});
    // The driver does not read the reply to a motion.
    static_cast<void>(rotctl(QStringLiteral("603"), reading, QStringLiteral("P 90 45")));
    static_cast<void>(rotctl(QStringLiteral("603"), reading, QStringLiteral("M 2 100")));
    expectRead(QStringLiteral("603"), reading, {std::round(before.azimuth), std::round(before.elevation)});
    EXPECT_TRUE(fakes::waitUntil([&] { return isAt(before); }));
}

// REQ-EASYCOMMSERVER-08 (HamlibSerial.Easycomm*): Hamlib's own unmodified drivers 202 and 204 point, read, turn, stop
// and park the mount, by a pseudo-terminal and by TCP. 201 points and stops it.
TEST_F(HamlibSerial, EasycommOfTheSecondVersionIsDriven)
{
    drive(QStringLiteral("202"), easycomm2, kTenths);
}

TEST_F(HamlibSerial, EasycommOfTheThirdVersionIsDriven)
{
    drive(QStringLiteral("204"), easycomm3, kTenths);
}

TEST_F(HamlibSerial, EasycommIsDrivenByTcp)
{
    drive(QStringLiteral("204"), easycommTcp, kTenths);
}

TEST_F(HamlibSerial, EasycommOfTheFirstVersionIsDriven)
{
    EXPECT_TRUE(points(QStringLiteral("201"), easycomm1, {10.0, 12.0})) << log;
    EXPECT_TRUE(points(QStringLiteral("201"), easycomm1, {25.5, 20.5})) << log;
    expectAccepted(QStringLiteral("201"), easycomm1, QStringLiteral("P 180 60"));
    expectAccepted(QStringLiteral("201"), easycomm1, QStringLiteral("S"));
    EXPECT_GT(std::abs(std::remainder(position().azimuth - 180.0, 360.0)), 20.0) << "S ended the way";
}

TEST_F(HamlibSerial, EasycommTurnsUntilItsClientLeaves)
{
    for (const auto& [model, where] : {std::pair("202", easycomm2), std::pair("204", easycomm3)}) {
        const AzEl before = position();
        EXPECT_TRUE(fakes::waitUntil([&] {
            expectAccepted(QLatin1String(model), where, QStringLiteral("M 16 50 pause 1"));
            return position().azimuth != before.azimuth;
        })) << model;
        EXPECT_TRUE(fakes::waitUntil([&] {
            const double first = position().azimuth;
            return first == position().azimuth;
        })) << model;
    }
}

TEST_F(HamlibSerial, EasycommParks)
{
    EXPECT_TRUE(points(QStringLiteral("202"), easycomm2, {10.0, 12.0})) << log;
    const AzEl away = position();
    EXPECT_TRUE(fakes::waitUntil([&] {
        expectAccepted(QStringLiteral("202"), easycomm2, QStringLiteral("K"));
        return std::abs(position().elevation - away.elevation) > 1.0 ||
               std::abs(std::remainder(position().azimuth - away.azimuth, 360.0)) > 1.0;
    }));
}

}  // namespace
}  // namespace boresight::system_test
