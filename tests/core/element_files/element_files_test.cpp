// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/element_files/element_files.h"

#include "core/elements/element_reader.h"
#include "core/elements/tle_fields.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <sys/stat.h>

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
    "OLD,2024-05-09T08:48:15,15.51043222,.0003466,51.6381,147.859,150.467,338.5502,25544,.00027777,.0001,0\n";

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

// REQ-ELEMENTFILES-01: Files and folders of element sets are read in each form. For each satellite number the newest
// epoch is used.
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

// REQ-ELEMENTFILES-02: Each bad set is reported with file, line and reason, and the others are used. Files that are
// unreadable, empty or too large are reported, too.
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
    QFile huge(folder.filePath(QStringLiteral("huge.tle")));
    ASSERT_TRUE(huge.open(QIODevice::WriteOnly));
    ASSERT_TRUE(huge.resize((kMostElementMegabytes << 20) + 1));
    EXPECT_THAT(linesOf(readElementFiles({huge.fileName()})),
                ElementsAre(HasSubstr("huge.tle: The file is larger than 64 MB. Split it.")));
    EXPECT_THAT(linesOf(readElementFiles({QStringLiteral("/proc/self/mem")})), SizeIs(1));
}

// REQ-ELEMENTFILES-05: Anything but a regular file is refused without being opened, because a pipe would block the
// reader. This also holds inside a folder, and in place of the file of a satellite.
TEST_F(ElementFilesTest, APipeIsNotWaitedFor)
{
    const auto pipe = [this](const char* name) {
        const QString path = folder.filePath(QLatin1String(name));
        EXPECT_EQ(::mkfifo(QFile::encodeName(path).constData(), 0600), 0);
        return path;
    };
    EXPECT_THAT(linesOf(readElementFiles({pipe("pipe.tle")})),
                ElementsAre(HasSubstr("pipe.tle: This is a pipe or a device. Name a file or a folder.")));
    EXPECT_THAT(linesOf(readElementFiles({pipe("pipe.mod")})),
                ElementsAre(HasSubstr("pipe.mod: This is a pipe or a device.")));
    EXPECT_THAT(linesOf(readElementFiles({QStringLiteral("/dev/zero")})),
                ElementsAre("/dev/zero: This is a pipe or a device. Name a file or a folder."));
    EXPECT_THAT(linesOf(readElementFiles({folder.path()})), ElementsAre(HasSubstr("There is no file of elements")));
    ASSERT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("satdata")));
    pipe("satdata/25544.sat");
    EXPECT_THAT(linesOf(readElementFiles({write("one.mod", "[GLOBAL]\nSATELLITES=25544\n")})),
                ElementsAre(HasSubstr("There are no elements of satellite 25544")));
}

// REQ-ELEMENTFILES-02
TEST_F(ElementFilesTest, AFileOfAnotherKindHasFewLines)
{
    std::string rubbish;
    for (int i = 0; i < 500; ++i) {
        rubbish += "no elements\n";
    }
    const auto lines = linesOf(readElementFiles({write("notes.txt", rubbish)}));
    ASSERT_THAT(lines, SizeIs(22));
    EXPECT_THAT(lines[0], HasSubstr("notes.txt:1: \"no elements\" is not part of an element set."));
    EXPECT_THAT(lines[20], HasSubstr("notes.txt: 480 further problems are not listed."));
    EXPECT_THAT(lines[21], HasSubstr("notes.txt: There is no element set in this file."));
}

// REQ-ELEMENTFILES-03: Two sets of one satellite that give positions too far apart are reported with both files. A set
// that is only older is not reported.
TEST_F(ElementFilesTest, SourcesThatDisagreeAreReported)
{
    std::string swapped = kWeather;  // another satellite with the number of the station, half a day older
    swapped.replace(swapped.find("23023.55811021"), 14, "24129.86689744");
    for (const std::string number : {"1 33591", "2 33591"}) {
        swapped.replace(swapped.find(number), number.size(), number.substr(0, 2) + "25544");
    }
    for (const char digit : {'1', '2'}) {
        const std::size_t line = swapped.find(std::string("\n") + digit + " 25544") + 1;
        const std::string_view summed = std::string_view(swapped).substr(line, kTleColumns);
        swapped[line + kTleColumns - 1] = static_cast<char>('0' + tleChecksum(summed));
    }
    const QString good = write("good.tle", kStation);
    const QString wrong = write("wrong.tle", swapped);
    for (const QStringList& paths : {QStringList{good, wrong}, QStringList{wrong, good, wrong}}) {
        const ElementFiles files = readElementFiles(paths);
        ASSERT_THAT(files.sets, SizeIs(1));
        EXPECT_EQ(files.sets[0].name, "ISS (ZARYA)");
        ASSERT_THAT(files.problems, SizeIs(1));
        EXPECT_TRUE(files.problems[0].startsWith(
            wrong + QStringLiteral(": This file and %1 place satellite 25544 ").arg(good)));
        EXPECT_TRUE(files.problems[0].endsWith(QStringLiteral(" km apart. Boresight uses %1.").arg(good)));
    }
    EXPECT_THAT(linesOf(readElementFiles({good, good})), IsEmpty());
}

// REQ-ELEMENTFILES-04: The elements of Gpredict are read from its own files: its folder, its satdata, one satellite, or
// the satellites of a module. A satellite of the module without elements is reported.
TEST_F(ElementFilesTest, TheFilesOfGpredictAreReadInPlace)
{
    const auto satdata = [](const std::string& set) {
        const std::size_t first = set.find("\n1 ") + 1;
        const std::size_t second = set.find("\n2 ") + 1;
        return "[Satellite]\nVERSION=1.1\nNAME=" + set.substr(0, first) + "TLE1=" + set.substr(first, second - first) +
               "TLE2=" + set.substr(second) + "STATUS=1\n";
    };
    ASSERT_TRUE(QDir(folder.path()).mkpath(QStringLiteral("satdata/cache")));
    ASSERT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("modules")));
    const QString station = write("satdata/25544.sat", satdata(kStation));
    write("satdata/33591.sat", satdata(kWeather));
    write("satdata/weather.cat", "Weather\n33591\n");
    const QString module = write("modules/mine.mod", "[GLOBAL]\nSATELLITES=33591;90001;x;\nQTHFILE=home.qth\n");
    for (const QString& path : {folder.path(), folder.filePath(QStringLiteral("satdata"))}) {
        EXPECT_THAT(readElementFiles({path}).sets, SizeIs(2));
        EXPECT_THAT(linesOf(readElementFiles({path})), IsEmpty());
    }
    EXPECT_EQ(readElementFiles({station}).sets.at(0).name, "ISS (ZARYA)");
    const ElementFiles files = readElementFiles({module});
    ASSERT_THAT(files.sets, SizeIs(1));
    EXPECT_EQ(files.sets[0].number, 33591);
    EXPECT_THAT(linesOf(files), ElementsAre(HasSubstr("mine.mod: There are no elements of satellite 90001 in "),
                                            HasSubstr("mine.mod: \"x\" is not a catalogue number.")));
    EXPECT_THAT(linesOf(readElementFiles({write("modules/empty.mod", "[GLOBAL]\n")})),
                ElementsAre(HasSubstr("empty.mod: The module names no satellite.")));
    EXPECT_THAT(linesOf(readElementFiles({QStringLiteral("/nowhere/absent.mod")})),
                ElementsAre(HasSubstr("/nowhere/absent.mod: ")));
}

TEST_F(ElementFilesTest, AFolderWithoutElementsSaysSo)
{
    EXPECT_THAT(linesOf(readElementFiles({folder.path()})),
                ElementsAre(folder.path().toStdString() + ": There is no file of elements in this folder."));
}
