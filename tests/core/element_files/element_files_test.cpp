// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/element_files/element_files.h"

#include <QDir>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <fstream>
#include <string>

using namespace boresight;
using namespace boresight::orbit;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

const std::string kStation =
    "ISS (ZARYA)\n"
    "1 25544U 98067A   24130.36689744  .00016024  00000+0  27777-3 0  9992\n"
    "2 25544  51.6381 147.8590 0003466 150.4670 338.5502 15.51043222452521\n";
const std::string kWeather =
    "NOAA 19\n"
    "1 33591U 09005A   23023.55811021  .00000311  00000+0  19296-3 0  9992\n"
    "2 33591  99.1220  67.0323 0012994 290.9949  68.9832 14.12673821719529\n";
const std::string kOlderStation =
    "OBJECT_NAME,EPOCH,MEAN_MOTION,ECCENTRICITY,INCLINATION,RA_OF_ASC_NODE,ARG_OF_PERICENTER,MEAN_ANOMALY,NORAD_CAT_ID,"
    "BSTAR,MEAN_MOTION_DOT,MEAN_MOTION_DDOT\n"
    "OLD,2024-05-08T00:00:00,15.5,.0003,51.6,147.8,150.4,338.5,25544,.0002,.0001,0\n";

class ElementFilesTest : public testing::Test
{
protected:
    QString write(const char* name, const std::string& text) const
    {
        const QString path = folder.filePath(QString::fromUtf8(name));
        std::ofstream(path.toStdString()) << text;
        return path;
    }

    QTemporaryDir folder;
};

std::vector<std::string> linesOf(const ElementFiles& files)
{
    std::vector<std::string> lines;
    for (const QString& line : files.problems) {
        lines.push_back(line.toStdString());
    }
    return lines;
}

}  // namespace

// REQ-ELEMENTFILES-01: Files and folders of element sets are read in each form. The newest epoch of a number wins.
TEST_F(ElementFilesTest, TheNewestSetOfEachNumberIsUsed)
{
    write("a.tle", kWeather + kStation);
    write("b.csv", kOlderStation);
    write("notes.md", "no elements\n");
    ASSERT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("deeper.txt")));
    const ElementFiles both = readElementFiles({folder.path()});
    EXPECT_THAT(linesOf(both), IsEmpty());
    ASSERT_THAT(both.sets, SizeIs(2));
    EXPECT_EQ(both.sets[0].name, "ISS (ZARYA)");
    EXPECT_EQ(both.sets[1].name, "NOAA 19");
    EXPECT_EQ(readElementFiles({write("any name", kOlderStation)}).sets.at(0).name, "OLD");
}

// REQ-ELEMENTFILES-02: Each bad set is reported with file, line and reason, and the others are used. So are files that
// cannot be read, are empty or too large.
TEST_F(ElementFilesTest, WhatIsBadIsReportedAndTheRestIsUsed)
{
    std::string bad = kStation;
    bad[bad.find("51.6381") + 1] = '2';
    const QString path = write("bad.tle", bad + kWeather);
    const QString absent = folder.filePath(QStringLiteral("absent.tle"));
    const QString empty = write("empty.tle", "");
    const ElementFiles files = readElementFiles({path, absent, empty});
    ASSERT_THAT(files.sets, SizeIs(1));
    EXPECT_EQ(files.sets[0].number, 33591);
    EXPECT_THAT(linesOf(files), ElementsAre(HasSubstr("bad.tle:3: "), HasSubstr("absent.tle: "),
                                            HasSubstr("empty.tle: There is no element set in this file.")));
    EXPECT_THAT(linesOf(readElementFiles({QStringLiteral("/dev/zero")})),
                ElementsAre("/dev/zero: The file is larger than 64 MB."));
    EXPECT_THAT(linesOf(readElementFiles({QStringLiteral("/proc/self/mem")})), SizeIs(1));
}

TEST_F(ElementFilesTest, AFolderWithoutElementsSaysSo)
{
    EXPECT_THAT(linesOf(readElementFiles({folder.path()})),
                ElementsAre(folder.path().toStdString() + ": There is no file of elements in this folder."));
}
