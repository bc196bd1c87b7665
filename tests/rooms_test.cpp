// SPDX-License-Identifier: GPL-3.0-or-later
// The rooms (folders) of the source, and which rooms each may include.
#include "tests/source_files.h"

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

// "core/sim" for "core/sim/servo.h".
std::string roomOf(const std::string& path)
{
    return path.substr(0, path.rfind('/'));
}

// "core/sim" for an include from there. Empty for other includes.
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

// Each include in `rooms` that is not from a `permitted` room, with the including file.
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

const Rooms kSeenByTheWindow{"core/base",      "core/units",    "core/pointing", "core/profile",
                             "core/alarms",    "core/messages", "core/elements", "core/orbit",
                             "core/passes",    "core/gpredict", "core/schedule", "core/targets",
                             "core/recording", "core/budget",   "core/plan",     "core/pass_report"};
const Rooms kAboveTheDriver{"core/control", "core/guards", "core/sources", "core/motion",     "core/mount",
                            "core/north",   "core/tuning", "core/night",   "core/cross_check"};
const Rooms kBelowPanels{"ui/kit", "ui/look", "ui/link", "ui/hold", "ui/budget", "ui/sky", "ui/plan", "ui/report"};

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
    // This room writes the diagnostics, from values that it already has.
    EXPECT_THAT(wrong({"ui/window"}, joined(joined(ui, kSeenByTheWindow), {"core/diagnostics"})), IsEmpty());
}

TEST(Rooms, TheCoreKnowsNoWindow)
{
    EXPECT_THAT(wrong(roomsOf("core"), roomsOf("core")), IsEmpty());
}

TEST(Rooms, NoPanelKnowsAnother)
{
    EXPECT_THAT(wrong({"ui/kit", "ui/report"}, kSeenByTheWindow), IsEmpty());
    EXPECT_THAT(wrong({"ui/look", "ui/link"}, joined(kSeenByTheWindow, {"ui/kit"})), IsEmpty());
    EXPECT_THAT(wrong({"ui/budget"}, joined(kSeenByTheWindow, {"ui/kit"})), IsEmpty());
    EXPECT_THAT(wrong({"ui/hold", "ui/sky"}, joined(kSeenByTheWindow, {"ui/kit", "ui/look", "ui/link", "ui/budget"})),
                IsEmpty());
    EXPECT_THAT(wrong({"ui/plan"}, joined(kSeenByTheWindow, {"ui/kit", "ui/look", "ui/sky"})), IsEmpty());
    Rooms panels = roomsOf("ui");
    for (const std::string& room : joined(kBelowPanels, {"ui/guide", "ui/replay", "ui/window"})) {
        panels.erase(room);
    }
    EXPECT_THAT(wrong(panels, joined(kSeenByTheWindow, kBelowPanels)), IsEmpty());
}

// The rooms that are not behind the port of the mount: the driver itself, its knowledge, and the simulated hardware.
TEST(Rooms, OnlySomeKnowHowTheDrivesSpeak)
{
    Rooms others = roomsOf("core");
    for (const char* const room :
         {"core/moteus", "core/moteus_mount", "core/journal", "core/sim", "core/sim_bus", "core/drive_check"}) {
        others.erase(room);
    }
    Rooms permitted = roomsOf("core");
    permitted.erase("core/moteus");
    EXPECT_THAT(wrong(others, permitted), IsEmpty());
}

// Rooms behind the driver of two moteus: their drive check and their journal.
TEST(Rooms, OnlyTheirDriverKnowsTheCheckAndTheJournal)
{
    Rooms others = roomsOf("core");
    for (const char* const room : {"core/moteus_mount", "core/journal", "core/drive_check"}) {
        others.erase(room);
    }
    Rooms permitted = roomsOf("core");
    permitted.erase("core/journal");
    permitted.erase("core/drive_check");
    EXPECT_THAT(wrong(others, permitted), IsEmpty());
}

TEST(Rooms, MessagesAreMadeOfValues)
{
    EXPECT_THAT(wrong({"core/messages"},
                      {"core/base", "core/brake", "core/budget", "core/plan", "core/end_switches", "core/units",
                       "core/pointing", "core/profile", "core/elements", "core/calibration", "core/ephemeris",
                       "core/orientation", "core/response", "core/schedule", "core/targets"}),
                IsEmpty());
}

TEST(Rooms, TheControlKnowsNoKindOfRotator)
{
    Rooms permitted = roomsOf("core");
    for (const char* const room :
         {"core/moteus", "core/moteus_mount", "core/gs232", "core/gs232_mount", "core/rotctl", "core/rotctld_mount",
          "core/rotator_box", "core/simple_mount", "core/drive_check", "core/journal", "core/can", "core/sim",
          "core/sim_bus", "core/inputs", "core/clients", "core/station", "core/perfect_mount"}) {
        permitted.erase(room);
    }
    EXPECT_THAT(wrong(kAboveTheDriver, permitted), IsEmpty());
}

// Only the control commands a driver. Apart from it and its guards, only the drivers and the code that makes them
// include the port.
TEST(Rooms, OnlyTheControlKnowsThePortOfTheMount)
{
    std::vector<std::string> found;
    for (const std::string& path : sourcesBelow("core")) {
        const std::string room = roomOf(path);
        if (room == "core/control" || room == "core/guards" || room == "core/mount" || room == "core/rotator_box" ||
            room == "core/station" || room.ends_with("_mount")) {
            continue;
        }
        std::ifstream file(std::filesystem::path(BORESIGHT_SOURCES) / path);
        for (std::string line; std::getline(file, line);) {
            if (line.starts_with("#include \"core/mount/mount_driver.h\"") ||
                line.starts_with("#include \"core/mount/mount_service.h\"") ||
                line.starts_with("#include \"core/mount/mount_connection.h\"")) {
                found.push_back(path + ": " + line);
            }
        }
    }
    EXPECT_THAT(found, IsEmpty());
}

// Whether a line names rotator hardware in code, include, text or comment. "CAN" counts as a separate word, "can" does
// not.
bool namesHardware(const std::string& line)
{
    for (const char* const name : {"moteus", "Moteus", "core/can/", "CanLink", "CanFrame", "GS-232", "gs232",
                                   "socketcan", "fdcanusb", "can0", "mjbots"}) {
        if (line.find(name) != std::string::npos) {
            return true;
        }
    }
    constexpr std::string_view kBus = "CAN";
    for (std::size_t at = line.find(kBus); at != std::string::npos; at = line.find(kBus, at + 1)) {
        if ((at == 0 || !isPartOfAWord(line, at - 1)) && !isPartOfAWord(line, at + kBus.size())) {
            return true;
        }
    }
    return false;
}

TEST(Rooms, HardwareIsRecognisedByItsName)
{
    EXPECT_TRUE(namesHardware("// of a moteus"));
    EXPECT_TRUE(namesHardware("tr(\"CAN off\")"));
    EXPECT_TRUE(namesHardware("#include \"core/can/can_link.h\""));
    EXPECT_TRUE(namesHardware("// as in \"socketcan:can0\""));
    EXPECT_TRUE(namesHardware("tr(\"Start moteus_tool\")"));
    EXPECT_FALSE(namesHardware("// It can be left out. CANCEL"));
}

// Only the panels of such drives may name the keys of their settings, and tools for them.
TEST(Rooms, NobodyAboveTheDriverNamesItsHardware)
{
    Rooms rooms = joined(joined(kAboveTheDriver, {"core/messages"}), roomsOf("ui"));
    rooms.erase("ui/drives");
    for (const char* const top : {"core", "ui"}) {
        for (const std::string& path : sourcesBelow(top)) {
            if (!rooms.contains(roomOf(path))) {
                continue;
            }
            std::ifstream file(std::filesystem::path(BORESIGHT_SOURCES) / path);
            for (std::string line; std::getline(file, line);) {
                EXPECT_FALSE(namesHardware(line)) << path << ": " << line;
            }
        }
    }
}

TEST(Rooms, AFolderIsSeenAtAGlance)
{
    constexpr int kSources = 30;
    std::map<std::string, int> count;
    for (const char* const top : {"core", "ui", "app", "tests"}) {
        for (const std::string& path : sourcesBelow(top)) {
            count[roomOf(path)] += path.ends_with(".cpp") ? 1 : 0;
        }
    }
    EXPECT_GT(count.size(), 30U);
    for (const auto& [room, sources] : count) {
        EXPECT_LT(sources, kSources) << room;
    }
}

// The lines of the headers below `top` that contain `words`, with the file.
std::vector<std::string> linesWith(const std::string& words, const std::string& top = "core")
{
    std::vector<std::string> found;
    for (const std::string& path : sourcesBelow(top)) {
        std::ifstream file(std::filesystem::path(BORESIGHT_SOURCES) / path);
        for (std::string line; path.ends_with(".h") && std::getline(file, line);) {
            if (line.find(words) != std::string::npos) {
                found.push_back(path + ":" + line);
            }
        }
    }
    return found;
}

// Code reads the profile in effect where it uses it, because a stored copy becomes outdated. Code that must react to a
// change has profileChanged(before, after).
TEST(Rooms, NobodyIsHandedTheProfileOrKeepsIt)
{
    EXPECT_THAT(linesWith("setProfile("), IsEmpty());
    EXPECT_THAT(linesWith("profile::Profile m_"), IsEmpty());
    EXPECT_THAT(linesWith("profile::Profile& m_"), IsEmpty());
    auto parts = linesWith("Settings m_");
    std::erase_if(parts, [](const std::string& line) { return line.find("profile::") == std::string::npos; });
    EXPECT_THAT(parts, IsEmpty());
    // The next station has this profile.
    EXPECT_THAT(linesWith("profile::Profile> m_"),
                testing::ElementsAre(testing::StartsWith("core/station/profile_desk.h:    std::optional")));
    // These classes know no profile. Their settings are computed from it: in the units of a drive, for a stream of
    // values, for a mounting in effect and a proposed one.
    EXPECT_THAT(linesWith("void setSettings("),
                testing::UnorderedElementsAre(testing::StartsWith("core/moteus_mount/drive.h:"),
                                              testing::StartsWith("core/orientation/judge.h:"),
                                              testing::StartsWith("core/cross_check/sensor_check.h:")));
    EXPECT_THAT(linesWith("setProfile(", "ui"), IsEmpty());
    EXPECT_THAT(linesWith("profile::Profile& m_", "ui"), IsEmpty());
    // The edited profile, and those that it is compared with.
    EXPECT_THAT(linesWith("profile::Profile m_", "ui"), testing::Each(testing::StartsWith("ui/link/profile_draft.h:")));
}

// A program's main() is an exception. A stand-in in the tests may have the name of the original.
TEST(Rooms, NoFileNameTwice)
{
    const std::vector<std::string> product{"core", "ui", "app"};
    for (const auto& tops : {product, std::vector<std::string>{"tests"}}) {
        std::map<std::string, std::string> seen;
        for (const std::string& top : tops) {
            for (const std::string& path : sourcesBelow(top)) {
                const auto [first, isNew] = seen.emplace(path.substr(path.rfind('/') + 1), path);
                EXPECT_TRUE(isNew || path.ends_with("/main.cpp")) << path << " and " << first->second;
            }
        }
    }
}

}  // namespace
}  // namespace boresight
