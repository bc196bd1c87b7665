// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/foreign_protocol.h"

#include <algorithm>
#include <array>

namespace boresight::rotctld {
namespace {

using namespace std::string_view_literals;

struct Opening
{
    std::string_view bytes;
    std::string_view protocol;
};

// The first bytes of other protocols. A blank after a word belongs to it, because `P` and `D` are rotctld commands.
constexpr std::array kOpenings{
    Opening{"GET "sv, "HTTP"},
    Opening{"POST "sv, "HTTP"},
    Opening{"PUT "sv, "HTTP"},
    Opening{"HEAD "sv, "HTTP"},
    Opening{"OPTIONS "sv, "HTTP"},
    Opening{"DELETE "sv, "HTTP"},
    Opening{"PATCH "sv, "HTTP"},
    Opening{"CONNECT "sv, "HTTP"},
    Opening{"TRACE "sv, "HTTP"},
    Opening{"PROPFIND "sv, "HTTP"},
    Opening{"PRI * "sv, "HTTP"},
    Opening{"DESCRIBE "sv, "RTSP"},
    Opening{"SETUP "sv, "RTSP"},
    Opening{"INVITE "sv, "SIP"},
    Opening{"REGISTER "sv, "SIP"},
    Opening{"\x16\x03"sv, "TLS"},
    Opening{"SSH-"sv, "SSH"},
    Opening{"\x03\0\0"sv, "RDP"},
    Opening{"EHLO "sv, "mail"},
    Opening{"HELO "sv, "mail"},
    Opening{"\xff\xfb"sv, "telnet options"},
    Opening{"\xff\xfd"sv, "telnet options"},
    Opening{"SA SE"sv, "Easycomm"},
};

bool isDigit(char byte)
{
    return byte >= '0' && byte <= '9';
}

bool isLineEnd(std::string_view rest)
{
    return rest.empty() || rest.front() == '\r' || rest.front() == '\n';
}

// "AZ EL", "AZ123.4 EL45.0", "ML", "VE": two letters, then a number, a blank or the end of the line.
bool isEasycomm(std::string_view line)
{
    const std::string_view word = line.substr(0, 2);
    const std::string_view rest = line.substr(std::min(line.size(), std::size_t{2}));
    if (word == "AZ" || word == "EL") {
        return isLineEnd(rest) || isDigit(rest.front()) || " +-."sv.find(rest.front()) != std::string_view::npos;
    }
    constexpr std::array kBareWords{"ML"sv, "MR"sv, "MU"sv, "MD"sv, "SA"sv, "SE"sv, "VE"sv};
    return !rest.empty() && isLineEnd(rest) && std::ranges::find(kBareWords, word) != kBareWords.end();
}

// "W123 045", "M123", "C2", "C": GS-232 ends its lines with a carriage return.
bool isGs232(std::string_view line)
{
    if (line.starts_with('C')) {
        const std::string_view rest = line.substr(line.starts_with("C2") ? 2 : 1);
        return !rest.empty() && isLineEnd(rest);
    }
    const bool pointing = line.starts_with('W') || line.starts_with('M');
    return pointing && line.size() >= 4 && isDigit(line[1]) && isDigit(line[2]) && isDigit(line[3]) &&
           (line[0] == 'W' || isLineEnd(line.substr(4)));
}

// "Host: …", "User-Agent: …": a header whose request line is missing.
bool isHeader(std::string_view line)
{
    const std::size_t colon = line.find(": ");
    constexpr std::size_t kShortestName = 4;
    return colon != std::string_view::npos && colon >= kShortestName &&
           std::ranges::all_of(line.substr(0, colon), [](char byte) {
               return (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z') || byte == '-';
           });
}

}  // namespace

std::optional<std::string_view> foreignProtocolIn(std::string_view line)
{
    for (const Opening& opening : kOpenings) {
        if (line.starts_with(opening.bytes)) {
            return opening.protocol;
        }
    }
    if (isEasycomm(line)) {
        return "Easycomm";
    }
    if (isGs232(line)) {
        return "GS-232";
    }
    return isHeader(line) ? std::optional("HTTP"sv) : std::nullopt;
}

}  // namespace boresight::rotctld
