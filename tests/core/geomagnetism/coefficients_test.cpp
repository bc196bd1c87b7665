// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/coefficients.h"

#include "core/geomagnetism/coefficient_file.h"
#include "tests/core/geomagnetism/synthetic_model.h"
#include "tests/fakes/text_of.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <fstream>

using namespace boresight;
using namespace boresight::geomagnetism;

namespace {

const std::string kHeader = "    2030.0            WMM-2030     12/10/2029";

std::string goodText()
{
    return coefficientText({{{1, 0}, {{-29351.8, 0.0}, {12.0, 0.0}}},
                            {{1, 1}, {{-1410.8, 4545.4}, {9.7, -21.5}}},
                            {{12, 12}, {{-0.7, 0.2}, {-0.1, -0.1}}}},
                           kHeader);
}

// The good text with one place changed.
std::string spoiled(const std::string& from, const std::string& to)
{
    std::string text = goodText();
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string refusal(const std::string& text)
{
    const auto read = parseCoefficients(text);
    return read ? "taken" : textOf(read.error());
}

}  // namespace

// REQ-GEOMAGNETISM-01 (Coefficients.*): A file that is not exactly a model of degree 12 is refused with its line.
// Checked are header, order of the terms, numbers, end lines and completeness.
TEST(Coefficients, AreReadAsTheyStand)
{
    const auto read = parseCoefficients(goodText());
    ASSERT_TRUE(read) << textOf(read.error());
    EXPECT_EQ(read->name, "WMM-2030");
    EXPECT_EQ(read->epoch, 2030.0);
    EXPECT_EQ(read->main[termIndex(1, 0)], (Term{-29351.8, 0.0}));
    EXPECT_EQ(read->main[termIndex(1, 1)], (Term{-1410.8, 4545.4}));
    EXPECT_EQ(read->change[termIndex(1, 1)], (Term{9.7, -21.5}));
    EXPECT_EQ(read->main[termIndex(12, 12)], (Term{-0.7, 0.2}));
    EXPECT_EQ(read->change[termIndex(12, 12)], (Term{-0.1, -0.1}));
    EXPECT_EQ(read->main[termIndex(7, 3)], Term{});
}

TEST(Coefficients, LineEndsOfAnySystemDo)
{
    std::string other;
    for (const char c : goodText()) {
        other += c == '\n' ? std::string("\r\n") : std::string(1, c);
    }
    EXPECT_EQ(parseCoefficients(other), parseCoefficients(goodText()));
    std::string unended = goodText();
    unended.pop_back();
    EXPECT_EQ(parseCoefficients(unended), parseCoefficients(goodText()));
    EXPECT_EQ(parseCoefficients(goodText() + "\n\n"), parseCoefficients(goodText()));
}

TEST(Coefficients, WhatIsSpoiledIsRefusedWithItsLine)
{
    const std::pair<std::string, std::string> wrong[] = {
        {"", "The file ends without a line of nines."},
        {spoiled(kHeader, "not a model"), "line 1: This is not the header of a magnetic model."},
        {spoiled("2030.0", "MMXXX"), "line 1: This is not the header"},
        {spoiled("2030.0", "203.0"), "line 1: This is not the header"},
        {spoiled(kHeader + "\n", ""), "line 1: This is not the header"},
        {spoiled("1 1  -1410.8", "1 2  -1410.8"), "line 3: The term n = 1, m = 1 must come here."},
        {spoiled("1 1  -1410.8  4545.4  9.7  -21.5\n", ""), "line 3: The term n = 1, m = 1 must come here."},
        {spoiled("9.7  -21.5", "9.7"), "line 3: The line has 5 numbers instead of 6"},
        {spoiled("9.7  -21.5", "9.7  -21.5 1"), "line 3: The line has 7 numbers instead of 6"},
        {spoiled("4545.4", "4545,4"), "line 3: \"4545,4\" is not a number"},
        {spoiled("4545.4", "nan"), "line 3: \"nan\" is not a number"},
        {spoiled("-29351.8  0.0", "-29351.8  5.0"), "line 2: In a term with m = 0, h must be 0."},
        {spoiled("12 12  -0.7  0.2  -0.1  -0.1\n", ""), "line 91: The term n = 12, m = 12 is missing."},
        {spoiled("9999", "13 0 1.0 0.0 0.0 0.0\n9999"), "line 92: A line of nines must follow degree 12."},
        {goodText() + "1 0 1.0 0.0 0.0 0.0\n", "line 94: A line of nines must follow"},
        {goodText().substr(0, goodText().find("9999")), "The file ends without a line of nines."},
    };
    for (const auto& [text, reason] : wrong) {
        EXPECT_TRUE(refusal(text).starts_with(reason)) << refusal(text) << "\n instead of\n" << reason;
    }
}

// A file that is cut anywhere, such as an incomplete download, is refused unless only its end lines are shorter.
TEST(Coefficients, AFileThatBreaksOffIsRefused)
{
    const std::string text = goodText();
    const auto nines = text.find("9999");
    for (std::size_t length = 0; length < nines; ++length) {
        EXPECT_FALSE(parseCoefficients(text.substr(0, length))) << length;
    }
}

// REQ-GEOMAGNETISM-01
TEST(CoefficientFile, ErrorsNameTheFile)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("spoiled.cof"));
    std::ofstream(path.toStdString()) << spoiled("4545.4", "x");
    EXPECT_EQ(textOf(readCoefficients(path).error()), path.toStdString() + ": line 3: \"x\" is not a number.");
    std::ofstream(path.toStdString()) << goodText();
    EXPECT_EQ(readCoefficients(path), parseCoefficients(goodText()));
    std::ofstream(path.toStdString()) << std::string(100000, ' ');
    EXPECT_EQ(readCoefficients(path).error().code, ErrorCode::InvalidInput);
    const auto absent = readCoefficients(folder.filePath(QStringLiteral("absent.cof")));
    EXPECT_EQ(absent.error().code, ErrorCode::Io);
    EXPECT_NE(textOf(absent.error()).find("absent.cof cannot be read"), std::string::npos);
}
