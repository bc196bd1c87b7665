// SPDX-License-Identifier: GPL-3.0-or-later
// The classes of the product: one source and one name for each, and a limited size.
#include "tests/source_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace boresight {
namespace {

// The class of a member whose definition starts in this line, else empty: "Servo" of "const ServoOutput&
// Servo::step(double dt)", "Session" of "void Session::Destroy::operator()(int* handle)". Namespaces start with a small
// letter.
std::string classDefinedIn(const std::string& line)
{
    const std::string head = line.substr(0, line.find('('));
    const bool isDefinition = !head.empty() && head.size() < line.size() &&
                              (isPartOfAWord(head, 0) || head[0] == ':') && head.find(" = ") == std::string::npos;
    if (!isDefinition) {
        return {};
    }
    std::string name = head.substr(head.find_last_of(" *&") + 1);
    for (std::size_t end = name.find("::"); end != std::string::npos; end = name.find("::")) {
        if (std::isupper(static_cast<unsigned char>(name[0])) != 0) {
            return name.substr(0, end);
        }
        name = name.substr(end + 2);
    }
    return {};
}

TEST(Classes, AMemberShowsItsClass)
{
    EXPECT_EQ(classDefinedIn("Servo::Servo(const DriveConfig& config) : m_config(config)"), "Servo");
    EXPECT_EQ(classDefinedIn("const ServoOutput& Servo::step(double dt)"), "Servo");
    EXPECT_EQ(classDefinedIn("std::optional<Angle> Server::Connection::at() const"), "Server");
    EXPECT_EQ(classDefinedIn("void Session::Destroy::operator()(int* handle) const"), "Session");
    EXPECT_EQ(classDefinedIn("bool Place::operator==(const Place& other) const"), "Place");
    EXPECT_EQ(classDefinedIn("Result<Angle> parse(Text::Line line)"), "");
    EXPECT_EQ(classDefinedIn("const Angle kTurn = Angle::fromDegrees(360.0);"), "");
    EXPECT_EQ(classDefinedIn("    return Servo::limits(command);"), "");
    EXPECT_EQ(classDefinedIn("// Servo::step() moves it."), "");
}

// Each class, with its namespace, whose members are defined in a source. Names in an anonymous namespace do not count.
std::set<std::string> classesDefinedIn(const std::string& path)
{
    std::set<std::string> found;
    std::vector<std::string> spaces;
    std::ifstream file(std::filesystem::path(BORESIGHT_SOURCES) / path);
    for (std::string line; std::getline(file, line);) {
        constexpr std::string_view kSpace = "namespace ";
        if (line.starts_with(kSpace) && line.ends_with('{')) {
            spaces.push_back(line.substr(kSpace.size(), line.rfind(' ') - kSpace.size() + 1));
        } else if (line.starts_with("}  // namespace") && !spaces.empty()) {
            spaces.pop_back();
        } else if (const std::string name = classDefinedIn(line);
                   !name.empty() && std::ranges::count(spaces, std::string()) == 0) {
            found.insert((spaces.empty() ? std::string() : spaces.back()) + name);
        }
    }
    return found;
}

// A class that needs a second source should be two classes.
TEST(Classes, AClassHasOneSource)
{
    std::map<std::string, std::string> seen;
    for (const char* const top : {"core", "ui", "app"}) {
        for (const std::string& path : sourcesBelow(top)) {
            if (!path.ends_with(".cpp") ||
                path == "ui/jog/gamepad_none.cpp") {  // the build uses this file or gamepad_sdl.cpp
                continue;
            }
            for (const std::string& name : classesDefinedIn(path)) {
                const auto [first, isNew] = seen.emplace(name, path);
                EXPECT_TRUE(isNew) << name << " in " << path << " and " << first->second;
            }
        }
    }
    EXPECT_GT(seen.size(), 300U);
}

// The class that begins in this line, else empty. A declaration ends with a semicolon.
std::string classBegunIn(const std::string& line)
{
    constexpr std::string_view kClass = "class ";
    if (!line.starts_with(kClass) || line.find(';') != std::string::npos) {
        return {};
    }
    return line.substr(kClass.size(), line.find(' ', kClass.size()) - kClass.size());
}

bool isMember(const std::string& line)
{
    constexpr std::string_view kInside = "    ";
    const std::string code = line.substr(0, line.find("//"));
    const std::size_t name = code.find(" m_");
    const std::size_t reference = code.find("&m_");
    return line.starts_with(kInside) && line.size() > kInside.size() && line[kInside.size()] != ' ' &&
           line[kInside.size()] != '}' && (name != std::string::npos || reference != std::string::npos) &&
           code.find("return ") == std::string::npos && code.find_last_not_of(' ') == code.rfind(';');
}

TEST(Classes, AMemberIsRecognised)
{
    EXPECT_TRUE(isMember("    Angle m_place;  // of the axis"));
    EXPECT_TRUE(isMember("    std::function<void()> m_onTick = {};"));
    EXPECT_FALSE(isMember("    [[nodiscard]] Angle place() const { return m_place; }"));
    EXPECT_FALSE(isMember("        Angle m_ofAnInnerStruct;"));
    EXPECT_FALSE(isMember("    Angle place;"));
}

// The text of a source, or empty if there is none.
std::string textOf(const std::string& path)
{
    std::ifstream file(std::filesystem::path(BORESIGHT_SOURCES) / path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// A class with more than 15 members should be divided. If that makes no sense, the header gives the reason.
TEST(Classes, AClassOfManyMembersSaysWhy)
{
    constexpr int kMembers = 15;
    int largest = 0;
    for (const char* const top : {"core", "ui", "app"}) {
        for (const std::string& path : sourcesBelow(top)) {
            std::ifstream file(std::filesystem::path(BORESIGHT_SOURCES) / path);
            bool says = false;
            int members = 0;
            std::string name;
            for (std::string line; path.ends_with(".h") && std::getline(file, line);) {
                says = says || line.find("ore than 15 members") != std::string::npos;
                if (const std::string begun = classBegunIn(line); !begun.empty()) {
                    name = begun;
                    members = 0;
                }
                members += isMember(line) ? 1 : 0;
                if (line.starts_with("};")) {
                    EXPECT_TRUE(says || members <= kMembers) << name << " in " << path << " has " << members;
                    largest = std::max(largest, members);
                    members = 0;
                }
            }
        }
    }
    EXPECT_GT(largest, kMembers);
}

// The same holds for more than 600 lines of a header with its source.
TEST(Classes, AClassOfManyLinesSaysWhy)
{
    constexpr std::size_t kLines = 600;
    std::size_t largest = 0;
    for (const char* const top : {"core", "ui", "app"}) {
        for (const std::string& path : sourcesBelow(top)) {
            if (!path.ends_with(".h")) {
                continue;
            }
            const std::string header = textOf(path);
            const std::string source = textOf(path.substr(0, path.size() - 2) + ".cpp");
            const auto lines = static_cast<std::size_t>(std::ranges::count(header + source, '\n'));
            largest = std::max(largest, lines);
            EXPECT_TRUE(lines <= kLines || header.find("600 lines") != std::string::npos) << path << ": " << lines;
        }
    }
    EXPECT_GT(largest, kLines);
}

// Value structs may have the same name in rooms that do not include one another. Classes may not.
TEST(Classes, NoClassNameTwice)
{
    std::map<std::string, std::string> seen;
    for (const char* const top : {"core", "ui", "app"}) {
        for (const std::string& path : sourcesBelow(top)) {
            std::ifstream file(std::filesystem::path(BORESIGHT_SOURCES) / path);
            for (std::string line; std::getline(file, line);) {
                if (const std::string name = classBegunIn(line); !name.empty()) {
                    const auto [first, isNew] = seen.emplace(name, path);
                    EXPECT_TRUE(isNew) << name << " in " << path << " and " << first->second;
                }
            }
        }
    }
    EXPECT_GT(seen.size(), 300U);
}

}  // namespace
}  // namespace boresight
