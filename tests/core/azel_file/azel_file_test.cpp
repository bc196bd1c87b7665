// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/azel_file/azel_file.h"

#include "tests/fakes/text_of.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <sys/stat.h>

namespace boresight::azel {
namespace {

const QByteArray kText =
    "22:30:04,105.3, 59.9,Moon\n22:30:04,298.4,-59.7,Sun\n22:30:04,  0.0,  0.0,Source\n"
    " 1296,  2189.0,   -4.41,  1625.0,   -9.79,Doppler, R\n";

class AzelFileTest : public ::testing::Test
{
protected:
    [[nodiscard]] QString path(const char* name = "azel.dat") const { return m_folder.filePath(QLatin1String(name)); }
    void write(const QByteArray& text) const
    {
        QFile out(path());
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(text);
    }
    static std::string reasonOf(const QString& path)
    {
        const AzelReading reading = readAzelFile(path);
        return reading.text ? "none" : textOf(reading.text.error());
    }

private:
    QTemporaryDir m_folder;
};

// REQ-AZEL-909: The file named in the profile is read, with the time of its last change. Without a name the file of
// WSJT-X for this user is read.
TEST_F(AzelFileTest, ReadsTheFileOfTheProfile)
{
    write(kText);
    const AzelReading reading = readAzelFile(azelPath({.file = path().toStdString()}));
    ASSERT_TRUE(reading.text) << textOf(reading.text.error());
    EXPECT_EQ(reading.text->moon, (SkyPointing{105.3_deg, 59.9_deg}));
    EXPECT_EQ(reading.path, path());
    ASSERT_TRUE(reading.written);
    EXPECT_LT(std::chrono::abs(*reading.written - std::chrono::system_clock::now()), std::chrono::minutes(1));
    EXPECT_TRUE(azelPath({}).endsWith(QStringLiteral("/WSJT-X/azel.dat")));
}

// REQ-AZEL-910: A file that is missing, empty, not a regular file or huge does no harm, and gives a reason.
TEST_F(AzelFileTest, WhatIsNoFileHasItsReason)
{
    EXPECT_EQ(reasonOf(path("none.dat")), "there is no such file");
    EXPECT_EQ(reasonOf(path("")), "there is no such file") << "a folder";
    write({});
    EXPECT_EQ(reasonOf(path()), "the file is empty");
    ASSERT_EQ(mkfifo(path("pipe").toLocal8Bit().constData(), 0600), 0);
    EXPECT_EQ(reasonOf(path("pipe")), "there is no such file") << "nobody writes into it, and nobody waits";
    write(kText);
    ASSERT_TRUE(QFile(path()).resize(100'000'000));
    EXPECT_EQ(reasonOf(path()), "The file is not an azel.dat. It is longer than 512 bytes.");
}

}  // namespace
}  // namespace boresight::azel
