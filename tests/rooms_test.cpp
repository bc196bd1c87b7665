// SPDX-License-Identifier: GPL-3.0-or-later
// The rooms of the house and what each may know of the others: who includes whom.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace boresight {
namespace {

using testing::IsEmpty;

using Rooms = std::set<std::string>;
using Arrows = std::map<std::string, std::map<std::string, std::string>>;  // room -> room -> by which file

// "core/sim" of "core/sim/servo.h"
std::string roomOf(const std::string& path)
{
    return path.substr(0, path.rfind('/'));
}

std::vector<std::string> sourcesBelow(const std::string& top)
{
    const std::filesystem::path root(BORESIGHT_SOURCES);
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / top)) {
        if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") {
            found.push_back(entry.path().lexically_relative(root).string());
        }
    }
    return found;
}

// "core/sim" of an include from there; empty: of no room.
std::string includedRoom(const std::string& line)
{
    constexpr std::string_view kInclude = "#include \"";
    const std::string path = line.starts_with(kInclude) ? line.substr(kInclude.size()) : std::string();
    const auto isIn = [&path](const char* top) { return path.starts_with(top); };
    const bool isOurs = isIn("core/") || isIn("ui/") || isIn("app/") || isIn("tests/");
    return isOurs ? roomOf(path) : std::string();
}

Arrows readArrows()
{
    Arrows all;
    for (const char* const top : {"core", "ui"}) {
        for (const std::string& path : sourcesBelow(top)) {
            std::ifstream file(std::filesystem::path(BORESIGHT_SOURCES) / path);
            for (std::string line; std::getline(file, line);) {
                if (const std::string room = includedRoom(line); !room.empty() && room != roomOf(path)) {
                    all[roomOf(path)].emplace(room, path);
                }
            }
        }
    }
    return all;
}

const Arrows& arrows()
{
    static const Arrows all = readArrows();
    return all;
}

// Each arrow of `rooms` that does not end in `permitted`, with the file that draws it.
std::vector<std::string> wrong(const Rooms& rooms, const Rooms& permitted)
{
    std::vector<std::string> found;
    for (const auto& [from, targets] : arrows()) {
        for (const auto& [to, by] : targets) {
            if (rooms.contains(from) && !permitted.contains(to)) {
                found.push_back(by + " includes " + to);
            }
        }
    }
    return found;
}

Rooms roomsOf(const std::string& top)
{
    Rooms rooms;
    for (const std::string& path : sourcesBelow(top)) {
        rooms.insert(roomOf(path));
    }
    return rooms;
}

Rooms joined(Rooms one, const Rooms& other)
{
    one.insert(other.begin(), other.end());
    return one;
}

const Rooms kSeenByTheWindow{"core/base",    "core/units",  "core/pointing",
                             "core/profile", "core/alarms", "core/messages"};
const Rooms kBelowPanels{"ui/kit", "ui/link", "ui/hold", "ui/sky"};

TEST(Rooms, NoTwoKnowEachOther)
{
    std::map<std::string, Rooms> reached;
    for (bool more = true; more;) {
        more = false;
        for (const auto& [from, targets] : arrows()) {
            Rooms& mine = reached[from];
            const std::size_t before = mine.size();
            for (const auto& [to, by] : targets) {
                mine.insert(to);
                mine = joined(mine, reached[to]);
            }
            more = more || mine.size() > before;
        }
    }
    for (const auto& [room, known] : reached) {
        EXPECT_FALSE(known.contains(room)) << room << " is in a circle";
    }
}

TEST(Rooms, TheWindowKnowsMessagesAndValuesOnly)
{
    const Rooms ui = roomsOf("ui");
    Rooms panels = ui;
    panels.erase("ui/window");
    EXPECT_THAT(wrong(panels, joined(ui, kSeenByTheWindow)), IsEmpty());
    // It writes the diagnostics, of values that it has.
    EXPECT_THAT(wrong({"ui/window"}, joined(joined(ui, kSeenByTheWindow), {"core/diagnostics"})), IsEmpty());
}

TEST(Rooms, TheCoreKnowsNoWindow)
{
    EXPECT_THAT(wrong(roomsOf("core"), roomsOf("core")), IsEmpty());
}

TEST(Rooms, NoPanelKnowsAnother)
{
    EXPECT_THAT(wrong({"ui/kit"}, kSeenByTheWindow), IsEmpty());
    EXPECT_THAT(wrong({"ui/link"}, joined(kSeenByTheWindow, {"ui/kit"})), IsEmpty());
    EXPECT_THAT(wrong({"ui/hold", "ui/sky"}, joined(kSeenByTheWindow, {"ui/kit", "ui/link"})), IsEmpty());
    Rooms panels = roomsOf("ui");
    for (const std::string& room : joined(kBelowPanels, {"ui/guide", "ui/window"})) {
        panels.erase(room);
    }
    EXPECT_THAT(wrong(panels, joined(kSeenByTheWindow, kBelowPanels)), IsEmpty());
}

// What is not behind the port of the mount: the driver itself, its knowledge, and the hardware that is simulated.
TEST(Rooms, OnlySomeKnowHowTheDrivesSpeak)
{
    Rooms others = roomsOf("core");
    for (const char* const room : {"core/moteus", "core/moteus_mount", "core/memory", "core/sim", "core/sim_bus",
                                   "core/supervision", "core/survey"}) {
        others.erase(room);
    }
    Rooms permitted = roomsOf("core");
    permitted.erase("core/moteus");
    EXPECT_THAT(wrong(others, permitted), IsEmpty());
}

TEST(Rooms, TheControlKnowsNoKindOfRotator)
{
    Rooms permitted = roomsOf("core");
    for (const char* const room :
         {"core/moteus", "core/moteus_mount", "core/can", "core/sim", "core/sim_bus", "core/station"}) {
        permitted.erase(room);
    }
    EXPECT_THAT(
        wrong({"core/control", "core/sources", "core/motion", "core/mount", "core/north", "core/witness"}, permitted),
        IsEmpty());
    permitted.erase("core/survey");
    permitted.erase("core/memory");
    EXPECT_THAT(wrong({"core/control", "core/sources"}, permitted), IsEmpty());
}

TEST(Rooms, AFolderIsSeenAtAGlance)
{
    constexpr int kSources = 30;
    std::map<std::string, int> count;
    for (const char* const top : {"core", "ui", "app"}) {
        for (const std::string& path : sourcesBelow(top)) {
            count[roomOf(path)] += path.ends_with(".cpp") ? 1 : 0;
        }
    }
    EXPECT_GT(count.size(), 30U);
    for (const auto& [room, sources] : count) {
        EXPECT_LT(sources, kSources) << room;
    }
}

// Lines of the headers below core that have `words`, with the file.
std::vector<std::string> linesWith(const std::string& words)
{
    std::vector<std::string> found;
    for (const std::string& path : sourcesBelow("core")) {
        std::ifstream file(std::filesystem::path(BORESIGHT_SOURCES) / path);
        for (std::string line; path.ends_with(".h") && std::getline(file, line);) {
            if (line.find(words) != std::string::npos) {
                found.push_back(path + ":" + line);
            }
        }
    }
    return found;
}

// Everybody reads the profile in force where it is used: what is handed on or kept grows stale. Whoever must react has
// profileChanged(before, after).
TEST(Rooms, NobodyIsHandedTheProfileOrKeepsIt)
{
    EXPECT_THAT(linesWith("setProfile("), IsEmpty());
    EXPECT_THAT(linesWith("profile::Profile m_"), IsEmpty());
    EXPECT_THAT(linesWith("profile::Profile& m_"), IsEmpty());
    auto parts = linesWith("Settings m_");
    std::erase_if(parts, [](const std::string& line) { return line.find("profile::") == std::string::npos; });
    EXPECT_THAT(parts, IsEmpty());
    // The station begins anew with this one.
    EXPECT_THAT(linesWith("profile::Profile> m_"),
                testing::ElementsAre(testing::StartsWith("core/station/station.h:    std::optional")));
    // These know no profile, and what they are set to is worked out from it: in the units of a drive, for a stream of
    // values, for a mounting in force and one that is proposed.
    EXPECT_THAT(linesWith("void setSettings("),
                testing::UnorderedElementsAre(testing::StartsWith("core/moteus_mount/drive.h:"),
                                              testing::StartsWith("core/orientation/judge.h:"),
                                              testing::StartsWith("core/witness/sensor_check.h:")));
}

TEST(Rooms, NoTwoHeadersOfOneName)
{
    std::map<std::string, std::string> seen;
    for (const char* const top : {"core", "ui"}) {
        for (const std::string& path : sourcesBelow(top)) {
            if (path.ends_with(".h")) {
                const auto [first, isNew] = seen.emplace(path.substr(path.rfind('/') + 1), path);
                EXPECT_TRUE(isNew) << path << " and " << first->second;
            }
        }
    }
}

}  // namespace
}  // namespace boresight
