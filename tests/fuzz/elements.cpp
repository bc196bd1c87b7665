// SPDX-License-Identifier: GPL-3.0-or-later
// Element sets: gives any bytes to readElements(). An accepted set is an orbit that SGP4 can compute or refuse.
#include "core/base/control_characters.h"
#include "core/elements/element_check.h"
#include "core/elements/element_reader.h"
#include "core/elements/tle_fields.h"
#include "core/elements/tle_reader.h"
#include "core/orbit/sgp4.h"
#include "tests/fuzz/harness.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace boresight::fuzz {
namespace {

using namespace boresight::orbit;

constexpr std::string_view kTleText =
    "ISS (ZARYA)\n"
    "1 25544U 98067A   24130.36689744  .00016024  00000+0  27777-3 0  9992\n"
    "2 25544  51.6381 147.8590 0003466 150.4670 338.5502 15.51043222452521\n"
    "0 MERIDIAN 7\r\n"
    "1 T0296U 14069A   23022.38518613 -.00000107  00000-0  00000+0 0  9998\r\n"
    "2 T0296  63.5864   1.1841 7150722 273.8090 305.2438  2.00646267 60225\r\n";

constexpr std::string_view kCsvText =
    "OBJECT_NAME,OBJECT_ID,EPOCH,MEAN_MOTION,ECCENTRICITY,INCLINATION,RA_OF_ASC_NODE,ARG_OF_PERICENTER,MEAN_ANOMALY,"
    "EPHEMERIS_TYPE,NORAD_CAT_ID,BSTAR\n"
    "\"A, B\",1998-067A,2024-05-09T08:48:19.938816,15.51043222,.0003466,51.6381,147.859,150.467,338.5502,0,25544,"
    ".27777E-3\n"
    "GEO,2018-090A,2023-01-22T00:00:00,1.0027,.0002,0.02,80,10,200,0,799500123,0\n";

constexpr std::string_view kJsonText =
    "[{\"OBJECT_NAME\":\"ISS\",\"EPOCH\":\"2024-130T08:48:19.9\",\"MEAN_MOTION\":15.5,\"ECCENTRICITY\":\".0003\",\n"
    "\"INCLINATION\":51.6,\"RA_OF_ASC_NODE\":147.8,\"ARG_OF_PERICENTER\":150.4,\"MEAN_ANOMALY\":338.5,\n"
    "\"EPHEMERIS_TYPE\":0,\"NORAD_CAT_ID\":25544,\"BSTAR\":2.7e-4}]\n";

constexpr std::string_view kXmlText =
    "<?xml version=\"1.0\"?>\n<ndm><omm id=\"CCSDS_OMM_VERS\" version=\"2.0\"><body><segment><data>\n"
    "<TIME_SYSTEM>UTC</TIME_SYSTEM><EPOCH>2024-05-09T08:48:19</EPOCH><MEAN_MOTION>2.006</MEAN_MOTION>\n"
    "<ECCENTRICITY>.715</ECCENTRICITY><INCLINATION>63.6</INCLINATION><RA_OF_ASC_NODE>1.2</RA_OF_ASC_NODE>\n"
    "<ARG_OF_PERICENTER>273.8</ARG_OF_PERICENTER><MEAN_ANOMALY>305.2</MEAN_ANOMALY>\n"
    "<NORAD_CAT_ID>40296</NORAD_CAT_ID><BSTAR>0</BSTAR></data></segment></body></omm></ndm>\n";

constexpr std::string_view kKvnText =
    "CCSDS_OMM_VERS = 2.0\nCOMMENT x\nOBJECT_NAME = ISS\nREF_FRAME = TEME\nTIME_SYSTEM = UTC\n"
    "MEAN_ELEMENT_THEORY = SGP4\nEPOCH = 2024-05-09T08:48:19\nMEAN_MOTION = 15.5 [rev/day]\nECCENTRICITY = 0.0003\n"
    "INCLINATION = 51.6 [deg]\nRA_OF_ASC_NODE = 147.8\nARG_OF_PERICENTER = 150.4\nMEAN_ANOMALY = 338.5\n"
    "NORAD_CAT_ID = 25544\nBSTAR = 0.00027\n";

constexpr std::string_view kSatdataText =
    "[Satellite]\nVERSION=1.1\nNAME=ISS\nNICKNAME=ISS\n"
    "TLE1=1 25544U 98067A   24130.36689744  .00016024  00000+0  27777-3 0  9992\n"
    "TLE2=2 25544  51.6381 147.8590 0003466 150.4670 338.5502 15.51043222452521\nSTATUS=1\n";

// Corrects the checksum of each line that has one. In Gpredict's files the line follows a key.
void sumLines(std::string& text)
{
    constexpr std::string_view kKey = "TLE1=";
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line = std::string_view(text).substr(begin, end - begin);
        if (line.starts_with("TLE") && line.size() > kKey.size()) {
            begin += kKey.size();
            line.remove_prefix(kKey.size());
        }
        if ((line.starts_with("1 ") || line.starts_with("2 ")) && line.size() >= kTleColumns) {
            const int sum = tleChecksum(line);
            text[begin + kTleColumns - 1] = static_cast<char>('0' + sum);
        }
        begin = end + 1;
    }
}

void checkProblems(const ElementList& list, int lines)
{
    require(list.problems.size() <= ElementList::kMostProblems, "no more problems are kept than promised");
    for (const ElementProblem& problem : list.problems) {
        require(problem.line >= 1 && problem.line <= lines, "a problem is in a line of the text");
        require(!problem.reason.isEmpty() && problem.reason.size() < 300, "a problem has a short reason");
        require(!hasControlCharacters(problem.reason.toStdString()), "a reason is one printable line");
    }
}

void checkOrbit(const ElementSet& set)
{
    constexpr double kLeastRadius = 6378.0;  // km: a satellite below has decayed
    const Sgp4 orbit(set);
    for (const double minutes : {0.0, 1440.0, -100'000.0}) {
        const OrbitResult state = orbit.propagate(minutes);
        require(
            !state || (std::isfinite(dot(state->velocity, state->velocity)) && length(state->position) > kLeastRadius),
            "a place is above the ground, or there is a fault");
        require(state || !describe(state.error()).isEmpty(), "a fault has its words");
    }
}

void checkSet(const ElementSet& set)
{
    require(elementProblem(set).isEmpty(), "an accepted set is an orbit");
    for (const std::string& text : {set.name, set.designator}) {
        require(nameOf(text) == text || text.size() > 60, "a name is printable UTF-8");
        require(!hasControlCharacters(text) && text.size() < 200, "a name is one short line");
    }
    require(set.classification >= 'A' && set.classification <= 'Z', "a classification is a letter");
    require(set.epoch.day > 2'430'000.0 && set.epoch.day < 2'530'000.0, "an epoch is of the space age");
    checkOrbit(set);
}

std::string withLongLineEnds(std::string_view text)
{
    std::string changed;
    for (const char character : text) {
        changed += character == '\n' ? "\r\n" : std::string(1, character);
    }
    return changed;
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    for (const std::string_view text : {kTleText, kCsvText, kJsonText, kXmlText, kKvnText, kSatdataText}) {
        grammar.corpus.emplace_back(text);
    }
    grammar.tokens = {"1 ",
                      "2 ",
                      "0 ",
                      "\n",
                      "\r\n",
                      "U",
                      "A0000",
                      "I0000",
                      "00000-0",
                      "+",
                      "-",
                      "e",
                      ".",
                      ",",
                      "\"",
                      "\"\"",
                      "[deg]",
                      "[",
                      "]",
                      "{",
                      "}",
                      ":",
                      "<omm>",
                      "</omm>",
                      "<![CDATA[",
                      "&lt;",
                      "&a;",
                      "<!--",
                      "COMMENT",
                      "=",
                      "null",
                      "nan",
                      "1e400",
                      "1e-9",
                      "999999999",
                      "4",
                      "TEME",
                      "GCRF",
                      "UTC",
                      "TAI",
                      "SGP4",
                      "Z",
                      "T",
                      "366",
                      "2016-12-31T23:59:60",
                      "\xef\xbb\xbf",
                      "\xff",
                      "\x1b"};
    grammar.separators = " ,;\n\"<>:=";
    grammar.maxLength = 1536;
    grammar.persistence = 30;
    grammar.repair = sumLines;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const std::string_view text = asText(input);
    // in XML, LF and CR both end a line
    const auto endsLine = [](char character) { return character == '\n' || character == '\r'; };
    const auto lines = static_cast<int>(std::ranges::count_if(text, endsLine)) + 1;
    const ElementList list = readElements(text);
    checkProblems(list, lines);
    std::ranges::for_each(list.sets, checkSet);
    if (elementForm(text) == ElementForm::Tle) {
        require(readTle(withLongLineEnds(text)).sets == list.sets, "line ends of both kinds mean the same");
    }
    if (!list.sets.empty() && list.problems.empty()) {
        accept();
    }
}

}  // namespace boresight::fuzz
