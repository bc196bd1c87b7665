// SPDX-License-Identifier: GPL-3.0-or-later
//
// rotctld_load [--seconds N] NAME=TARGET [NAME=TARGET]
//
// Measures rotctld servers, one or two side by side. TARGET is HOST:PORT of a running server on the loopback, or a
// command line that starts one (server.h says how the port is found). Prints a table; the ratio is first to second.

#include "core/base/numbers.h"
#include "tests/bench/scenarios.h"
#include "tests/fakes/text_of.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace {

using boresight::bench::Better;
using boresight::bench::Figure;

struct Contestant
{
    std::string name;
    std::string target;
    std::vector<Figure> figures;
};

struct Arguments
{
    std::chrono::seconds duration{3};
    std::vector<Contestant> contestants;
};

constexpr const char* kUsage = "usage: rotctld_load [--seconds 1…60] NAME=TARGET [NAME=TARGET]\n";

std::optional<Arguments> parseArguments(std::span<char*> words)
{
    Arguments arguments;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view word = words[i];
        const std::size_t equals = word.find('=');
        if (word == "--seconds" && i + 1 < words.size()) {
            const auto seconds = boresight::parseInteger(words[++i]);
            if (!seconds || *seconds < 1 || *seconds > 60) {
                return std::nullopt;
            }
            arguments.duration = std::chrono::seconds(*seconds);
        } else if (equals != std::string_view::npos && !word.starts_with('-')) {
            arguments.contestants.push_back({.name = std::string(word.substr(0, equals)),
                                             .target = std::string(word.substr(equals + 1)),
                                             .figures = {}});
        } else {
            return std::nullopt;
        }
    }
    const std::size_t count = arguments.contestants.size();
    return count == 1 || count == 2 ? std::optional(arguments) : std::nullopt;
}

std::string number(double value)
{
    if (std::isnan(value)) {
        return "-";
    }
    return boresight::formatFixed(value, std::abs(value) < 100 && value != std::floor(value) ? 2 : 0);
}

std::string ratio(const Figure& first, const Figure& second)
{
    if (std::isnan(first.value) || std::isnan(second.value) || second.value == 0) {
        return "";
    }
    const bool ahead = (first.better == Better::Higher) == (first.value >= second.value);
    return boresight::formatFixed(first.value / second.value, 2) + (ahead ? "  better" : "  worse");
}

// Pads by displayed characters, not by bytes: in UTF-8 the unit µs has more bytes than characters.
std::string padded(const std::string& text, std::size_t width)
{
    std::size_t shown = 0;
    for (const char byte : text) {
        shown += (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
    }
    return text + std::string(shown < width ? width - shown : 0, ' ');
}

void printTable(const std::vector<Contestant>& contestants)
{
    std::printf("%s", padded("", 50).c_str());
    for (const Contestant& contestant : contestants) {
        std::printf("%14s", contestant.name.c_str());
    }
    std::printf("%s\n", contestants.size() == 2 ? "   ratio" : "");
    for (std::size_t row = 0; row < contestants.front().figures.size(); ++row) {
        const Figure& first = contestants.front().figures[row];
        std::printf("%s", padded(first.name, 50).c_str());
        for (const Contestant& contestant : contestants) {
            std::printf("%14s", number(contestant.figures[row].value).c_str());
        }
        if (contestants.size() == 2) {
            std::printf("   %s", ratio(first, contestants.back().figures[row]).c_str());
        }
        std::printf("\n");
    }
}

}  // namespace

int main(int argc, char** argv)
{
    auto arguments = parseArguments(std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
    if (!arguments) {
        std::fputs(kUsage, stderr);
        return 2;
    }
    std::vector<std::string> targets;
    for (const Contestant& contestant : arguments->contestants) {
        targets.push_back(contestant.target);
    }
    const auto figures = boresight::bench::measureServers(targets, arguments->duration);
    if (!figures) {
        std::fprintf(stderr, "rotctld_load: %s\n", textOf(figures.error()).c_str());
        return 1;
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        arguments->contestants[i].figures = (*figures)[i];
    }
    printTable(arguments->contestants);
    return 0;
}
