// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gpredict/gpredict_qth.h"

#include "core/profile/small_file.h"
#include "tests/fakes/text_of.h"

#include <QDir>
#include <QTemporaryDir>

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::profile;

namespace {

// As Gpredict 2.3 writes it.
constexpr const char* kHome =
    "[QTH]\n"
    "DESCRIPTION=My station\n"
    "LOCATION=Lisboa, Portugal\n"
    "LAT=38.7223\n"
    "LON=-9.1393\n"
    "ALT=102\n"
    "WX=LPPT\n"
    "QTH_TYPE=0\n"
    "GPSDSERVER=\n"
    "GPSDPORT=2947\n";

std::string errorOf(const char* text)
{
    const auto station = parseQth(text, QStringLiteral("x"));
    return station ? "accepted" : textOf(station.error());
}

void write(const QString& path, const char* text)
{
    ASSERT_TRUE(writeFile(path, text));
}

}  // namespace

// REQ-PROFILE-16 (GpredictQth.*): Gpredict's stations are found, and an incomplete station is refused. Its satellite
// data are found, with the number of satellites and the epoch of the newest elements. They are in the usual folder of
// Gpredict or in the folder named by the profile.
TEST(GpredictQth, IsReadAsGpredictWritesIt)
{
    const auto station = parseQth(kHome, QStringLiteral("home"));
    ASSERT_TRUE(station) << textOf(station.error());
    EXPECT_EQ(station->name, QStringLiteral("home"));
    EXPECT_EQ(station->location, QStringLiteral("Lisboa, Portugal"));
    EXPECT_EQ(station->site,
              (SiteSettings{.known = true, .latitude = 38.7223_deg, .longitude = -9.1393_deg, .heightMetres = 102.0}));
}

TEST(GpredictQth, OnlyItsGroupCounts)
{
    const auto station = parseQth(
        "# LAT=1\n[OTHER]\nLAT=2\n[QTH]\r\n LAT = 3 \r\nLON=4\r\nLAT=5\nALT=6\n[QTH 2]\nLAT=7\n", QStringLiteral("x"));
    ASSERT_TRUE(station) << textOf(station.error());
    EXPECT_EQ(station->site.latitude, 5_deg);
    EXPECT_EQ(station->location, QString());
}

TEST(GpredictQth, AnIncompletePlaceIsRefused)
{
    EXPECT_EQ(errorOf(""), "LAT is missing");
    EXPECT_EQ(errorOf("[QTH]\nLAT=1\nALT=5\n"), "LON is missing");
    EXPECT_EQ(errorOf("[QTH]\nLAT=1\nLON=12,5\nALT=5\n"), "LON is not a number");
    EXPECT_EQ(errorOf("[QTH]\nLAT=91\nLON=12.5\nALT=5\n"), "LAT: 91 is outside -90…90");
    EXPECT_EQ(errorOf("LAT=1\nLON=12.5\nALT=5\n"), "LAT is missing") << "outside of [QTH]";
}

TEST(GpredictQth, FindsTheStationsWithTheDefaultFirst)
{
    const QTemporaryDir folder;
    EXPECT_TRUE(findGpredict(folder.path()).stations.empty());
    write(folder.filePath(QStringLiteral("away.qth")), "[QTH]\nLAT=1\nLON=2\nALT=3\n");
    write(folder.filePath(QStringLiteral("home.qth")), kHome);
    write(folder.filePath(QStringLiteral("sample.qth")), "[QTH]\nLAT=55.6167\nLON=12.6500\nALT=5\n");
    write(folder.filePath(QStringLiteral("bad.qth")), "[QTH]\nLAT=1\n");
    const auto names = [&] {
        std::string all;
        for (const GpredictStation& station : findGpredict(folder.path()).stations) {
            all += station.name.toStdString() + (station.isDefault ? "* " : " ");
        }
        return all;
    };
    EXPECT_EQ(names(), "sample* away home ") << "Gpredict's own default";
    write(folder.filePath(QStringLiteral("gpredict.cfg")), "[GLOBAL]\nDEFAULT_QTH=home.qth\n[MODULES]\nOPEN=Amateur\n");
    EXPECT_EQ(names(), "home* away sample ");
    EXPECT_EQ(findGpredict(folder.path()).problems, QStringList{QStringLiteral("bad.qth: LON is missing")});
}

TEST(GpredictQth, ItsFolderIsTheProfilesElseTheUsersOwn)
{
    const QTemporaryDir home;
    const QByteArray before = qgetenv("XDG_CONFIG_HOME");
    qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
    const QString folder = gpredictFolder({});
    qputenv("XDG_CONFIG_HOME", before);
    EXPECT_EQ(folder, home.filePath(QStringLiteral("Gpredict")));
    EXPECT_EQ(gpredictFolder({.folder = "/mnt/shack/Gpredict"}), QStringLiteral("/mnt/shack/Gpredict"));
}
