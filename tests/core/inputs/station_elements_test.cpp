// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_elements.h"

#include "tests/core/inputs/elements_fixture.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/wait_until.h"

#include <QFile>

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

// Invented elements. The checksum of the first line is wrong.
const QByteArray kBroken =
    "BROKEN\n"
    "1 90002U 26001B   26001.50000000  .00001000  00000-0  20000-4 0   106\n"
    "2 90002  51.6000 100.0000 0010000  90.0000 270.0000 15.50000000000017\n";

// REQ-TRACK-908: The station reads the element files of the profile at its start, after a change of the profile, and
// when a file changes. Good sets are used. Errors in the others are in the log once, with file and line.
TEST_F(StationElementsTest, ReadsTheFilesOfTheProfileAndTellsWhatIsWrong)
{
    write(kFirst + kBroken);
    profile::InForce profile(naming(file()));
    StationElements elements(profile, log, clock, nullptr);
    EXPECT_TRUE(elements.satellites()->empty()) << "nobody has opened it";
    elements.open();
    ASSERT_TRUE(waitFor(elements, 1));
    EXPECT_EQ(elements.satellites()->front().name, "FIRST");
    EXPECT_THAT(lines(Severity::Warning), testing::ElementsAre(testing::StartsWith(file().toStdString() + ":5: ")));
    EXPECT_THAT(lines(Severity::Advisory), testing::ElementsAre("the elements of 1 satellites are read"));
}

TEST_F(StationElementsTest, ReadsAgainWhenAFileOrTheProfileChanges)
{
    write(kBroken);
    profile::InForce profile(naming(file()));
    StationElements elements(profile, log, clock, nullptr);
    elements.open();
    ASSERT_TRUE(fakes::waitUntil([&] { return !lines(Severity::Warning).empty(); }));
    write(kFirst);
    ASSERT_TRUE(waitFor(elements, 1));
    const auto before = profile.shared();
    profile.apply(naming(file() + QStringLiteral(".not-there")));
    elements.profileChanged(*before, *profile);
    ASSERT_TRUE(waitFor(elements, 0));
}

// Story: a downloader removed the file and wrote the new one two seconds later. Meanwhile the schedule had no
// satellites, and nobody read the new file.
// REQ-TRACK-909: Satellites whose file is broken or missing keep their last elements, with a warning. A file that comes
// back is read again.
TEST_F(StationElementsTest, KeepsWhatItKnowsWhileAFileIsGoneOrBroken)
{
    write(kFirst);
    profile::InForce profile(naming(file()));
    StationElements elements(profile, log, clock, nullptr);
    fakes::HandTurnedTimers timers(elements, clock);
    const auto laterWarned = [&](const char* words) {
        return fakes::waitUntil([&] {
            timers.elapse(Seconds(1.0));
            const std::vector<std::string> warnings = lines(Severity::Warning);
            return std::ranges::any_of(warnings,
                                       [&](const std::string& line) { return line.find(words) != std::string::npos; });
        });
    };
    elements.open();
    ASSERT_TRUE(waitFor(elements, 1));
    ASSERT_TRUE(QFile::remove(file()));
    ASSERT_TRUE(laterWarned("No such file"));
    ASSERT_TRUE(laterWarned("1 satellites are missing there. They keep"));
    EXPECT_EQ(elements.satellites()->size(), 1U);
    write("<html>503 Service Unavailable</html>");
    ASSERT_TRUE(laterWarned("There is no element set in this file"));
    EXPECT_EQ(elements.satellites()->size(), 1U);
    QByteArray newer = kFirst;
    newer.replace("FIRST", "AGAIN");
    write(newer);
    EXPECT_TRUE(fakes::waitUntil([&] {
        timers.elapse(Seconds(1.0));
        return elements.satellites()->front().name == "AGAIN";
    }));
}

}  // namespace
}  // namespace boresight
