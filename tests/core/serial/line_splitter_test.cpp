// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial/line_splitter.h"

#include <gmock/gmock.h>

#include <vector>

namespace boresight {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> linesOf(LineSplitter& splitter, std::string_view bytes)
{
    std::vector<std::string> lines;
    splitter.add(bytes, [&lines](std::string_view line) { lines.emplace_back(line); });
    return lines;
}

// REQ-CAN-03 (LineSplitter.*)
TEST(LineSplitter, AnySplitGivesTheSameLines)
{
    const std::string stream = "OK\r\nrcv 0100 11 E\n\n\rERR x\rhalf";
    for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
        LineSplitter splitter;
        auto lines = linesOf(splitter, std::string_view(stream).substr(0, cut));
        const auto rest = linesOf(splitter, std::string_view(stream).substr(cut));
        lines.insert(lines.end(), rest.begin(), rest.end());
        EXPECT_THAT(lines, ElementsAre("OK", "rcv 0100 11 E", "ERR x")) << "cut at " << cut;
    }
}

TEST(LineSplitter, LongestLinePassesALongerOneIsCountedAndTheNextIsWhole)
{
    LineSplitter splitter;
    const std::string longest(LineSplitter::kLongestLine, 'x');
    EXPECT_THAT(linesOf(splitter, longest + "\n"), ElementsAre(longest));
    EXPECT_THAT(linesOf(splitter, longest + "y"), IsEmpty());
    EXPECT_THAT(linesOf(splitter, std::string(1000000, 'z')), IsEmpty());
    EXPECT_EQ(splitter.overlongLines(), 0U);
    EXPECT_THAT(linesOf(splitter, "tail\nOK\n"), ElementsAre("OK"));
    EXPECT_EQ(splitter.overlongLines(), 1U);
}

TEST(LineSplitter, ClearForgetsTheHalfLine)
{
    LineSplitter splitter;
    EXPECT_THAT(linesOf(splitter, "rcv 01"), IsEmpty());
    splitter.clear();
    EXPECT_THAT(linesOf(splitter, "OK\n"), ElementsAre("OK"));
}

}  // namespace
}  // namespace boresight
