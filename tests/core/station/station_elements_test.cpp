// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_elements.h"

#include "tests/fakes/canned_web.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

// Made up. The sum of the first line of the second one is wrong.
const QByteArray kFirst =
    "FIRST\n"
    "1 90001U 26001A   26001.50000000  .00001000  00000-0  20000-4 0   104\n"
    "2 90001  51.6000 100.0000 0010000  90.0000 270.0000 15.50000000000016\n";
const QByteArray kBroken =
    "BROKEN\n"
    "1 90002U 26001B   26001.50000000  .00001000  00000-0  20000-4 0   106\n"
    "2 90002  51.6000 100.0000 0010000  90.0000 270.0000 15.50000000000017\n";

// With a cache of its own.
class StationElementsTest : public ::testing::Test
{
protected:
    StationElementsTest() { qputenv("XDG_CACHE_HOME", QFile::encodeName(m_folder.path())); }
    ~StationElementsTest() override { qputenv("XDG_CACHE_HOME", m_before); }
    StationElementsTest(const StationElementsTest&) = delete;
    StationElementsTest& operator=(const StationElementsTest&) = delete;

    void write(const QByteArray& text) const
    {
        QFile out(file());
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(text);
    }
    [[nodiscard]] QString file() const { return m_folder.filePath(QStringLiteral("some.tle")); }
    [[nodiscard]] static profile::Profile naming(const QString& path) { return naming({path.toStdString()}); }
    [[nodiscard]] static profile::Profile naming(const std::vector<std::string>& entries)
    {
        profile::Profile profile;
        profile.orbit.elements = entries;
        return profile;
    }
    [[nodiscard]] std::vector<std::string> lines(Severity severity) const
    {
        std::vector<std::string> texts;
        for (const LogEntry& line : log.since(0, EventLog::kCapacity)) {
            if (line.severity == severity) {
                texts.push_back(line.text.toStdString());
            }
        }
        return texts;
    }
    [[nodiscard]] bool waitFor(const StationElements& elements, std::size_t count) const
    {
        return fakes::waitUntil([&] { return elements.satellites()->size() == count; });
    }

    fakes::ManualClock clock;
    EventLog log{clock};

private:
    QTemporaryDir m_folder;
    QByteArray m_before = qgetenv("XDG_CACHE_HOME");
};

// REQ-TRACK-908: The station reads the element files of the profile at its start, with a change of the profile and when
// a file changes. The good sets are used. What is wrong with the others is in the log once, with file and line.
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

// Story: a downloader removed the file and wrote it anew two seconds later. The schedule had no satellites meanwhile,
// and nobody read the new file.
// REQ-TRACK-909: Satellites that are missing because a file is broken or gone stay as they were read before, with a
// warning. A file that comes back is found again.
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

// REQ-ELEMENTWEB-09: The station downloads the addresses of the profile and uses them as files. Without a network it
// starts with what the cache has. What is wrong is in the log once, and in the status as long as it is so.
TEST_F(StationElementsTest, DownloadsTheAddressesOfTheProfile)
{
    fakes::CannedWeb server;
    server.answersWith("/good", "200 OK", {}, kFirst);
    server.answersWith("/gone", "404 Not Found", {}, {});
    profile::InForce profile(naming({server.address("/good"), server.address("/gone")}));
    {
        StationElements elements(profile, log, clock, nullptr);
        elements.open();
        ASSERT_TRUE(waitFor(elements, 1));
        ASSERT_TRUE(fakes::waitUntil([&] { return !elements.problems().isEmpty(); }));
        const auto isGone = testing::StartsWith(server.address("/gone") + ": The server answers 404 Not Found.");
        EXPECT_THAT(elements.problems().constFirst().toStdString(), isGone);
        EXPECT_THAT(lines(Severity::Warning), testing::ElementsAre(isGone));
        const auto before = profile.shared();
        profile.apply(naming({server.address("/good")}));
        elements.profileChanged(*before, *profile);
        ASSERT_TRUE(fakes::waitUntil([&] { return elements.problems().isEmpty(); }));
        EXPECT_EQ(elements.satellites()->size(), 1U);
    }
    server.stopListening();
    StationElements later(profile, log, clock, nullptr);
    later.open();
    EXPECT_TRUE(waitFor(later, 1)) << "from the cache";
}

// A profile with addresses only does not fall back on Gpredict while nothing is downloaded.
TEST_F(StationElementsTest, WithoutAnAnswerThereAreNoSatellites)
{
    fakes::CannedWeb server;
    server.answersWith("/gone", "404 Not Found", {}, {});
    profile::Profile wanted = naming({server.address("/gone")});
    QDir().mkpath(file() + QStringLiteral("/satdata"));
    wanted.gpredict.folder = file().toStdString();
    profile::InForce profile(wanted);
    StationElements elements(profile, log, clock, nullptr);
    elements.open();
    ASSERT_TRUE(fakes::waitUntil([&] { return !elements.problems().isEmpty(); }));
    EXPECT_THAT(lines(Severity::Warning), testing::SizeIs(1));
}

}  // namespace
}  // namespace boresight
