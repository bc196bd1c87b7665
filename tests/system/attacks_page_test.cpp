// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

// The pages name tests. A test that was renamed or removed no longer shows what the page says.
namespace boresight::system_test {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// The names "Suite.Name" of all matches. The first two groups of the pattern are suite and name.
std::set<std::string> names(const std::string& text, const std::regex& pattern)
{
    std::set<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
        found.insert((*match)[1].str() + "." + (*match)[2].str());
    }
    return found;
}

std::set<std::string> testsIn(const fs::path& folder)
{
    static const std::regex definition(R"(\nTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\))");
    std::set<std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".cpp") {
            found.merge(names(textOf(entry.path()), definition));
        }
    }
    return found;
}

void expectExisting(const char* page)
{
    static const std::regex name(R"(`([A-Z]\w+)\.([A-Z]\w+)`)");
    const std::set<std::string> named = names(textOf(fs::path(TESTS_FOLDER) / "system" / page), name);
    const std::set<std::string> existing = testsIn(TESTS_FOLDER);
    EXPECT_GT(named.size(), 30U);
    for (const std::string& test : named) {
        EXPECT_TRUE(existing.contains(test)) << test;
    }
}

std::set<std::string> firstGroups(const std::string& text, const std::regex& pattern)
{
    std::set<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
        found.insert((*match)[1].str());
    }
    return found;
}

// Story: the page named a program under its former name.
TEST(AttacksPage, NamesFuzzProgramsThatExist)
{
    const fs::path folder(TESTS_FOLDER);
    const std::set<std::string> existing =
        firstGroups(textOf(folder / "fuzz" / "CMakeLists.txt"), std::regex(R"(\nboresight_add_fuzz\((\w+))"));
    for (const std::string page : {"fuzz/README.md", "system/ATTACKS.md"}) {
        const std::set<std::string> named =
            firstGroups(textOf(folder / page), std::regex(R"((?:ctest -R Fuzz\.|`fuzz_)(\w+))"));
        EXPECT_GE(named.size(), 5U) << page;
        for (const std::string& program : named) {
            EXPECT_TRUE(program == "NAME" || existing.contains(program)) << page << " names " << program;
        }
    }
}

TEST(AttacksPage, NamesTestsThatExist)
{
    expectExisting("ATTACKS.md");
}

TEST(FaultTableFile, NamesTestsThatExist)
{
    expectExisting("FAULTS.md");
}

}  // namespace
}  // namespace boresight::system_test
