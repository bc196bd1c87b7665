// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gpredict/gpredict_satellites.h"

#include "core/gpredict/gpredict_qth.h"
#include "core/profile/setting.h"
#include "core/profile/small_file.h"

#include <QDir>
#include <QTemporaryDir>

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::profile;

namespace {

// The published example of the format: 2008, day 264.51782528.
constexpr const char* kIss = "1 25544U 98067A   08264.51782528 -.00002182  00000-0 -11606-4 0  2927";

double secondsBetween(UtcTime a, UtcTime b)
{
    return std::chrono::duration<double>(b - a).count();
}

class SatelliteFolder : public testing::Test
{
protected:
    SatelliteFolder() { EXPECT_TRUE(QDir(home.path()).mkdir(QStringLiteral("satdata"))); }

    // As Gpredict 2.2 and later write it.
    void add(const char* file, const QByteArray& line)
    {
        ASSERT_TRUE(writeFile(home.filePath(QStringLiteral("satdata/") + QLatin1String(file)),
                              "[Satellite]\nVERSION=1.1\nNAME=X\nNICKNAME=X\nTLE1=" + line + "\nTLE2=2\nSTATUS=1\n"));
    }

    QTemporaryDir home;
};

}  // namespace

// REQ-PROFILE-16 (ElementEpoch.*)
TEST(ElementEpoch, IsReadFromItsColumns)
{
    using namespace std::chrono;
    const auto epoch = elementEpoch(kIss);
    ASSERT_TRUE(epoch);
    const UtcTime day = sys_days(2008y / September / 20);  // the 264th of a leap year
    EXPECT_NEAR(secondsBetween(day, *epoch), 0.51782528 * 86400.0, 1e-3);
}

TEST(ElementEpoch, YearsTurnAtFiftySeven)
{
    using namespace std::chrono;
    EXPECT_EQ(elementEpoch("1 00005U 58002B   57001.00000000 "), UtcTime(sys_days(1957y / January / 1)));
    EXPECT_EQ(elementEpoch("1 00005U 58002B   56366.00000000 "), UtcTime(sys_days(2056y / December / 31)));
    EXPECT_EQ(elementEpoch("1 00005U 58002B   00  1.50000000 "), UtcTime(sys_days(2000y / January / 1) + 12h))
        << "blanks in place of zeros";
}

TEST(ElementEpoch, RubbishHasNone)
{
    for (const char* const line :
         {"", "1 25544U 98067A   08264.5", "2 25544U 98067A   08264.51782528 -.00002182",
          "1 25544U 98067A   xx264.51782528 -.00002182", "1 25544U 98067A   08000.51782528 -.00002182",
          "1 25544U 98067A   08367.51782528 -.00002182", "1 25544U 98067A   08nan          -.00002182"}) {
        EXPECT_EQ(elementEpoch(line), std::nullopt) << line;
    }
}

// REQ-PROFILE-16 (SatelliteFolder.*)
TEST_F(SatelliteFolder, CountsItsFilesAndTellsTheNewestElements)
{
    EXPECT_EQ(findGpredictSatellites(home.path()),
              (GpredictSatellites{.folder = home.filePath(QStringLiteral("satdata"))}));
    add("25544.sat", kIss);
    add("07530.sat", "1 07530U 74089B   26324.25000000 -.00000030  00000-0  90000-4 0  9990");
    add("99999.sat", "rubbish");
    add("amateur.cat", kIss);
    const GpredictSatellites found = findGpredict(home.path()).satellites;
    EXPECT_EQ(found.files, 3);
    ASSERT_TRUE(found.newest);
    using namespace std::chrono;
    EXPECT_EQ(*found.newest, UtcTime(sys_days(2026y / November / 20) + 6h));
}

TEST(GpredictFolderSetting, IsAnAbsolutePathOrEmpty)
{
    Profile profile;
    const Setting* const setting = findSetting("gpredict.folder");
    ASSERT_NE(setting, nullptr);
    EXPECT_EQ(setting->get(profile), SettingValue(std::string()));
    EXPECT_TRUE(setting->set(profile, std::string("/home/op/.config/Gpredict")));
    EXPECT_EQ(profile.gpredict.folder, "/home/op/.config/Gpredict");
    EXPECT_FALSE(setting->set(profile, std::string("Gpredict")));
    EXPECT_EQ(profile.gpredict.folder, "/home/op/.config/Gpredict");
    EXPECT_TRUE(setting->set(profile, std::string()));
}
