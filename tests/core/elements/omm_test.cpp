// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/element_reader.h"
#include "core/elements/omm_csv.h"
#include "core/elements/omm_json.h"
#include "core/elements/omm_kvn.h"
#include "core/elements/omm_xml.h"
#include "core/elements/tle_reader.h"
#include "core/orbit/sgp4.h"
#include "tests/fakes/reference_data.h"

#include <gmock/gmock.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace boresight;
using namespace boresight::orbit;
using namespace boresight::fakes;
using testing::HasSubstr;

namespace {

using OmmTexts = std::vector<std::pair<std::string, std::string>>;

OmmTexts goodOmm()
{
    return {{"OBJECT_NAME", "VANGUARD 1"},
            {"OBJECT_ID", "1958-002B"},
            {"CENTER_NAME", "EARTH"},
            {"REF_FRAME", "TEME"},
            {"TIME_SYSTEM", "UTC"},
            {"MEAN_ELEMENT_THEORY", "SGP4"},
            {"EPOCH", "2020-10-13T04:52:48.47"},
            {"MEAN_MOTION", "10.84869164"},
            {"ECCENTRICITY", ".1845686"},
            {"INCLINATION", "34.2443"},
            {"RA_OF_ASC_NODE", "225.5254"},
            {"ARG_OF_PERICENTER", "162.2516"},
            {"MEAN_ANOMALY", "205.2356"},
            {"EPHEMERIS_TYPE", "0"},
            {"CLASSIFICATION_TYPE", "U"},
            {"NORAD_CAT_ID", "799500123"},
            {"ELEMENT_SET_NO", "999"},
            {"REV_AT_EPOCH", "21814"},
            {"BSTAR", "-.22483E-4"},
            {"MEAN_MOTION_DOT", "-1.6E-7"},
            {"MEAN_MOTION_DDOT", "0"}};
}

OmmTexts with(OmmTexts texts, const std::string& key, const std::string& value)
{
    for (auto& [name, text] : texts) {
        text = name == key ? value : text;
    }
    return texts;
}

std::string asJson(const OmmTexts& texts)
{
    std::string json;
    for (const auto& [key, value] : texts) {
        json += (json.empty() ? "{\"" : ",\"") + key + "\":\"" + value + "\"";
    }
    return json + "}";
}

std::string asKvn(const OmmTexts& texts)
{
    std::string kvn = "CCSDS_OMM_VERS = 2.0\nCOMMENT a comment\nCREATION_DATE = \nORIGINATOR = \n\n";
    for (const auto& [key, value] : texts) {
        kvn += key + " = " + value + (key == "INCLINATION" ? " [deg]\n" : "\n");
    }
    return kvn;
}

std::string asXml(const OmmTexts& texts)
{
    std::string xml = "<omm id=\"CCSDS_OMM_VERS\" version=\"2.0\"><body><data>\n";
    for (const auto& [key, value] : texts) {
        xml += "<" + key + ">" + value + "</" + key + ">\n";
    }
    return xml + "</data></body></omm>\n";
}

std::string csvLine(const OmmTexts& texts, bool isHeader)
{
    std::string line;
    for (const auto& [key, value] : texts) {
        line += (line.empty() ? "" : ",") + (isHeader ? key : key == "OBJECT_NAME" ? "\"" + value + "\"" : value);
    }
    return line + "\r\n";
}

std::string inForm(ElementForm form, const std::vector<OmmTexts>& records)
{
    std::string text = form == ElementForm::Csv   ? csvLine(goodOmm(), true)
                       : form == ElementForm::Xml ? "<?xml version=\"1.0\"?>\n<ndm>\n"
                                                  : std::string();
    for (std::size_t i = 0; i < records.size(); ++i) {
        text += form == ElementForm::Csv   ? csvLine(records[i], false)
                : form == ElementForm::Xml ? asXml(records[i])
                : form == ElementForm::Kvn ? asKvn(records[i])
                                           : (i == 0 ? "[" : ",\n") + asJson(records[i]);
    }
    return text + (form == ElementForm::Json ? "]" : form == ElementForm::Xml ? "</ndm>" : "");
}

constexpr ElementForm kOmmForms[] = {ElementForm::Json, ElementForm::Csv, ElementForm::Xml, ElementForm::Kvn};

}  // namespace

// REQ-ORBIT-05: OMM is read as JSON, CSV, XML and KVN, with catalogue numbers of 9 digits. The form is detected from
// the text.
TEST(Omm, AllFormsGiveTheSameSet)
{
    for (const ElementForm form : kOmmForms) {
        const std::string text = inForm(form, {goodOmm(), with(goodOmm(), "NORAD_CAT_ID", "5")});
        EXPECT_EQ(elementForm(text), form);
        const ElementList list = readElements(text);
        EXPECT_TRUE(list.problems.empty()) << list.problems.front().reason.toStdString();
        ASSERT_EQ(list.sets.size(), 2U) << text;
        const ElementSet& set = list.sets.front();
        EXPECT_EQ(set.name, "VANGUARD 1");
        EXPECT_EQ(set.designator, "1958-002B");
        EXPECT_EQ(set.number, 799500123);
        EXPECT_EQ(list.sets.back().number, 5);
        EXPECT_EQ(set.epoch.day, 2459135.5);
        EXPECT_NEAR(set.epoch.fraction * 86400.0, 17568.47, 1e-6);
        EXPECT_EQ(set.revolutionsPerDay, 10.84869164);
        EXPECT_EQ(set.eccentricity, 0.1845686);
        EXPECT_NEAR(set.inclination.degrees(), 34.2443, 1e-12);
        EXPECT_NEAR(set.meanAnomaly.degrees(), 205.2356, 1e-12);
        EXPECT_EQ(set.bstar, -0.22483e-4);
        EXPECT_EQ(set.meanMotionDot, -1.6e-7);
        EXPECT_EQ(set.revolution, 21814);
    }
}

// REQ-ORBIT-05
TEST(Omm, ACsvNameMayHoldCommasAndQuotes)
{
    const OmmTexts named = with(goodOmm(), "OBJECT_NAME", "A \"\"B\"\", C");
    const ElementList list = readElements(csvLine(goodOmm(), true) + csvLine(named, false));
    ASSERT_EQ(list.sets.size(), 1U);
    EXPECT_EQ(list.sets.front().name, "A \"B\", C");
    EXPECT_EQ(elementForm("BSTAR,\"MEAN_MOTION\"\n"), ElementForm::Csv);
    EXPECT_EQ(elementForm("\xEF\xBB\xBF\r\nBSTAR,MEAN_MOTION\r\n"), ElementForm::Csv);
}

// REQ-ORBIT-05
TEST(Omm, JsonNumbersNeedNoQuotes)
{
    std::string json = asJson(goodOmm());
    for (const auto& [key, value] : goodOmm()) {
        const bool isNumber = value.find_first_not_of("0123456789.-E") == std::string::npos && value.front() != '.';
        const std::string quotedValue = "\"" + value + "\"";
        if (isNumber && value.find("-.") == std::string::npos) {
            json.replace(json.find(quotedValue), quotedValue.size(), value);
        }
    }
    const ElementList list = readElements(json);
    ASSERT_EQ(list.sets.size(), 1U) << json;
    EXPECT_EQ(list.sets, readElements(asJson(goodOmm())).sets);
}

// REQ-ORBIT-05
TEST(Omm, XmlMayHaveNamespaces)
{
    std::string xml = asXml(goodOmm());
    for (const std::string name : {"omm", "EPOCH"}) {
        for (const std::string begin : {"<", "</"}) {
            const std::size_t at = xml.find(begin + name);
            xml.replace(at, begin.size(), begin + "ndm:");
        }
    }
    const ElementList list = readElements("<ndm:ndm xmlns:ndm=\"urn:ccsds\">" + xml + "</ndm:ndm>");
    ASSERT_EQ(list.sets.size(), 1U) << xml;
    EXPECT_EQ(list.sets, readElements(asXml(goodOmm())).sets);
}

// REQ-ORBIT-05
TEST(Omm, KvnNeedsNoHeadAndKeepsBracketsOfAName)
{
    const std::string kvn = asKvn(with(goodOmm(), "OBJECT_NAME", "COSMOS [DEB]"));
    const ElementList list = readElements("COMMENT x\n" + kvn.substr(kvn.find("OBJECT_NAME")));
    ASSERT_EQ(list.sets.size(), 1U);
    EXPECT_EQ(list.sets.front().name, "COSMOS [DEB]");
}

// REQ-ORBIT-06: Each bad OMM record is reported with its line and the reason, in every form, and the others are used.
TEST(Omm, EachBadRecordIsReportedAndTheOthersAreUsed)
{
    const std::map<std::string, std::pair<std::string, std::string>> wrong{
        {"CENTER_NAME", {"MARS", "CENTER_NAME is MARS. SGP4 needs EARTH."}},
        {"REF_FRAME", {"GCRF", "SGP4 needs TEME."}},
        {"TIME_SYSTEM", {"TAI", "SGP4 needs UTC."}},
        {"MEAN_ELEMENT_THEORY", {"SGP4-XP", "SGP4 needs SGP4."}},
        {"EPHEMERIS_TYPE", {"4", "EPHEMERIS_TYPE is 4."}},
        {"EPOCH", {"yesterday", "EPOCH is \"yesterday\". This cannot be read."}},
        {"MEAN_MOTION", {"", "MEAN_MOTION is missing."}},
        {"ECCENTRICITY", {"1", "eccentricity is 1. It must be"}},
        {"INCLINATION", {"-1", "inclination is -1"}},
        {"RA_OF_ASC_NODE", {"1e9", "must be from -360"}},
        {"MEAN_ANOMALY", {"nan", "MEAN_ANOMALY is \"nan\""}},
        {"BSTAR", {"0x1", "BSTAR is \"0x1\""}},
        {"NORAD_CAT_ID", {"1234567890", "from 0 to 999999999"}},
        {"REV_AT_EPOCH", {"many", "REV_AT_EPOCH is \"many\""}}};
    for (const ElementForm form : kOmmForms) {
        for (const auto& [key, value] : wrong) {
            const ElementList list =
                readElements(inForm(form, {goodOmm(), with(goodOmm(), key, value.first), goodOmm()}));
            EXPECT_EQ(list.sets.size(), 2U) << key;
            ASSERT_EQ(list.problems.size(), 1U) << key << static_cast<int>(form);
            EXPECT_THAT(list.problems.front().reason.toStdString(), HasSubstr(value.second));
            EXPECT_GT(list.problems.front().line, 1);
        }
    }
}

// REQ-ORBIT-06
TEST(Omm, WhatIsCutCostsNoOtherRecord)
{
    for (const ElementForm form : kOmmForms) {
        const std::string whole = inForm(form, {goodOmm(), goodOmm()});
        const std::string last = inForm(form, {goodOmm()});
        for (std::size_t end = last.size() + 8; end < whole.size() - 30; end += 7) {
            const ElementList list = readElements(whole.substr(0, end));
            EXPECT_GE(list.sets.size(), 1U) << whole.substr(0, end);
            EXPECT_GE(list.sets.size() + list.problems.size(), 2U) << whole.substr(0, end);
        }
    }
}

// REQ-ORBIT-06
TEST(Omm, BrokenFormsAreReportedWithTheirLine)
{
    const auto first = [](const ElementList& list) {
        return list.problems.empty()
                   ? std::string("none")
                   : std::to_string(list.problems.front().line) + " " + list.problems.front().reason.toStdString();
    };
    EXPECT_THAT(first(readOmmJson("[\n{\"a\":}\n]")), testing::StartsWith("2 This is not a JSON object"));
    EXPECT_EQ(first(readOmmJson("[1]\n")), "1 \"1]\" is not an element set in JSON.");
    EXPECT_EQ(readOmmJson("[{\"a\":\"b\n}, " + asJson(goodOmm()) + "]").sets.size(), 1U);
    EXPECT_THAT(first(readOmmXml("<a>\n<omm>\n</b>")), testing::StartsWith("3 This is not valid XML"));
    EXPECT_THAT(first(readOmmXml("<?xm\x1b ?>")), testing::Not(HasSubstr("\x1b")));
    EXPECT_EQ(first(readOmmXml("<a></a>")), "1 The XML has no element <omm>.");
    EXPECT_EQ(first(readOmmCsv("MEAN_MOTION,BSTAR\n1\n")), "2 The line has 1 values. The header has 2.");
    EXPECT_EQ(first(readOmmCsv("MEAN_MOTION,BSTAR\n\"1,2\n")), "2 A text in double quotes does not end in its line.");
    EXPECT_EQ(first(readOmmKvn("OBJECT_NAME = A\nnonsense\n")),
              "2 \"nonsense\" is not a line of the form KEY = value.");
    EXPECT_EQ(first(readElements("")), "none");
}

// Qt's reader keeps each open element. 60 MB of open elements took 3.5 GB, and the program crashed.
// REQ-ORBIT-06
TEST(Omm, XmlOfTooManyLevelsIsNotReadOn)
{
    std::string xml = "<ndm>\n";
    for (int i = 0; i < 100; ++i) {
        xml += "<a>\n";
    }
    const ElementList list = readElements(xml + asXml(goodOmm()));
    EXPECT_TRUE(list.sets.empty());
    ASSERT_EQ(list.problems.size(), 1U);
    EXPECT_EQ(list.problems[0].line, 33);
    EXPECT_EQ(list.problems[0].reason.toStdString(),
              "This is not valid XML: More than 32 elements stand inside one another.");
}

// 1 MB of opening brackets neither stalls the program nor overflows the stack.
// REQ-ORBIT-06
TEST(Omm, DeepNestingDoesNoHarm)
{
    const std::size_t many = 200'000;
    std::string xml;
    std::string json = "[";
    for (std::size_t i = 0; i < many; ++i) {
        xml += "<omm>";
        json += "{\"a\":";
    }
    EXPECT_FALSE(readElements(xml).problems.empty());
    EXPECT_FALSE(readElements(json).problems.empty());
    EXPECT_FALSE(readElements(std::string(many, '[') + "x").problems.empty());
    EXPECT_EQ(readElements("MEAN_MOTION,\n" + std::string(many, ',')).problems.front().reason.toStdString(),
              "The line has 1000 values. The header has 2.");
}

// REQ-ORBIT-07: TLE, CSV and JSON of one satellite agree to 2e-6 km after 1.5 days.
TEST(OmmReference, FormatsAgree)
{
    const std::string name = "omm_stations_2024-05-09";
    if (!hasReference(name + ".tle") || !hasReference(name + ".csv") || !hasReference(name + ".json")) {
        GTEST_SKIP() << "no " << referencePath(name) << ".tle, .csv and .json (CelesTrak)";
    }
    const ElementList tle = readElements(referenceText(name + ".tle"));
    const ElementList csv = readElements(referenceText(name + ".csv"));
    const ElementList json = readElements(referenceText(name + ".json"));
    ASSERT_GT(tle.sets.size(), 20U);
    ASSERT_EQ(csv.sets.size(), tle.sets.size());
    ASSERT_EQ(json.sets.size(), tle.sets.size());
    EXPECT_TRUE(tle.problems.empty() && csv.problems.empty() && json.problems.empty());
    for (std::size_t i = 0; i < tle.sets.size(); ++i) {
        EXPECT_EQ(csv.sets[i], json.sets[i]);
        EXPECT_EQ(csv.sets[i].name, tle.sets[i].name);
        EXPECT_EQ(csv.sets[i].number, tle.sets[i].number);
        EXPECT_EQ(csv.sets[i].designator, tle.sets[i].designator);
        const JulianDate later{tle.sets[i].epoch.day + 1.5, tle.sets[i].epoch.fraction};
        const OrbitResult byTle = Sgp4(tle.sets[i]).propagate(later);
        const OrbitResult byOmm = Sgp4(csv.sets[i]).propagate(later);
        ASSERT_TRUE(byTle && byOmm);
        EXPECT_LT(length(byTle->position - byOmm->position), 2e-6) << tle.sets[i].name;
    }
}

// REQ-ORBIT-05
TEST(OmmReference, ThePublishedXmlIsRead)
{
    if (!hasReference("omm_sample.xml")) {
        GTEST_SKIP() << "no " << referencePath("omm_sample.xml");
    }
    const ElementList list = readElements(referenceText("omm_sample.xml"));
    ASSERT_EQ(list.sets.size(), 1U);
    EXPECT_EQ(list.sets.front().name, "VANGUARD 1");
    EXPECT_EQ(list.sets.front().number, 5);
}
