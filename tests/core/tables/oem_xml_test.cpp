// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/oem_xml.h"

#include "core/tables/table_reader.h"
#include "tests/core/tables/oem_text.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

namespace boresight::tables {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// Based on the XML example of CCSDS 502.0-B (annex G), with the Earth as its centre, and the same message as KVN.
const std::string kXml = R"(<?xml version="1.0" encoding="UTF-8"?>
<oem xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
     xsi:noNamespaceSchemaLocation="https://sanaregistry.org/r/ndmxml/ndmxml-1.0-master.xsd"
     id="CCSDS_OEM_VERS" version="2.0">
  <header>
    <COMMENT>THIS IS A COMMENT</COMMENT>
    <CREATION_DATE>1996-11-04T17:22:31</CREATION_DATE>
    <ORIGINATOR>NASA/JPL</ORIGINATOR>
  </header>
  <body>
    <segment>
      <metadata>
        <OBJECT_NAME>EXPLORER &amp; 1</OBJECT_NAME>
        <OBJECT_ID>1996-062A</OBJECT_ID>
        <CENTER_NAME>EARTH</CENTER_NAME>
        <REF_FRAME>J2000</REF_FRAME>
        <TIME_SYSTEM>UTC</TIME_SYSTEM>
        <START_TIME>1996-12-18T12:00:00.331</START_TIME>
        <USEABLE_START_TIME>1996-12-18T12:00:30.331</USEABLE_START_TIME>
        <USEABLE_STOP_TIME>1996-12-18T12:01:50.331</USEABLE_STOP_TIME>
        <STOP_TIME>1996-12-18T12:02:00.331</STOP_TIME>
        <INTERPOLATION>HERMITE</INTERPOLATION>
        <INTERPOLATION_DEGREE>3</INTERPOLATION_DEGREE>
      </metadata>
      <data>
        <COMMENT>Produced by <b>nobody</b></COMMENT>
        <stateVector>
          <EPOCH>1996-12-18T12:00:00.331</EPOCH>
          <X units="km">2789.6</X><Y units="km">-280.0</Y><Z units="km">-6746.8</Z>
          <X_DOT units="km/s">4.73372</X_DOT><Y_DOT units="km/s">-2.49586</Y_DOT><Z_DOT units="km/s">-1.04195</Z_DOT>
        </stateVector>
        <stateVector>
          <EPOCH>1996-12-18T12:01:00.331</EPOCH>
          <Z_DOT>-1.86043</Z_DOT><X> 3083.4 </X><Y>-428.1</Y><Z>-6592.2</Z>
          <X_DOT>4.41572</X_DOT><Y_DOT>-2.51586</Y_DOT>
          <X_DDOT>0.001</X_DDOT><Y_DDOT>0</Y_DDOT><Z_DDOT>0</Z_DDOT>
        </stateVector>
        <stateVector>
          <EPOCH>1996-12-18T12:02:00.331</EPOCH>
          <X>3345.1</X><Y>-575.9</Y><Z>-6450.3</Z><X_DOT>4.1</X_DOT><Y_DOT>-2.6</Y_DOT><Z_DOT>-2.3</Z_DOT>
        </stateVector>
        <covarianceMatrix><EPOCH>1996-12-18T12:00:00.331</EPOCH><CX_X>0.316</CX_X></covarianceMatrix>
      </data>
    </segment>
  </body>
</oem>
)";

const std::string kKvn = R"(CCSDS_OEM_VERS = 2.0
CREATION_DATE = 1996-11-04T17:22:31
ORIGINATOR = NASA/JPL
META_START
OBJECT_NAME = EXPLORER & 1
OBJECT_ID = 1996-062A
CENTER_NAME = EARTH
REF_FRAME = J2000
TIME_SYSTEM = UTC
USEABLE_START_TIME = 1996-12-18T12:00:30.331
USEABLE_STOP_TIME = 1996-12-18T12:01:50.331
INTERPOLATION = HERMITE
INTERPOLATION_DEGREE = 3
META_STOP
1996-12-18T12:00:00.331 2789.6 -280.0 -6746.8 4.73372 -2.49586 -1.04195
1996-12-18T12:01:00.331 3083.4 -428.1 -6592.2 4.41572 -2.51586 -1.86043
1996-12-18T12:02:00.331 3345.1 -575.9 -6450.3 4.1 -2.6 -2.3
)";

// The message without its XML declaration, from <oem to </oem>.
std::string message()
{
    return kXml.substr(kXml.find("<oem"));
}

std::string xmlRefusal(const std::string& text)
{
    const auto table = readTable(text, QStringLiteral("a.xml"));
    return table ? "accepted" : textOf(table.error());
}

// REQ-TABLES-926: An OEM in XML, alone or inside <ndm>, gives the same table as the message in KVN.
TEST(OemXml, IsWhatTheSameMessageIsAsKvn)
{
    const auto kvn = readTable(kKvn, QStringLiteral("a.oem"));
    ASSERT_TRUE(kvn) << textOf(kvn.error());
    for (const std::string& text : {kXml, "\xEF\xBB\xBF" + kXml, message(), "<ndm>" + message() + "</ndm>",
                                    "<ndm><MESSAGE_ID>1</MESSAGE_ID>" + message() + "</ndm>"}) {
        const auto xml = readTable(text, QStringLiteral("a.xml"));
        ASSERT_TRUE(xml) << textOf(xml.error());
        EXPECT_EQ(**xml, **kvn);
    }
}

// REQ-TABLES-927: A damaged OEM in XML is refused with the line, the error and what to do, as in KVN: a file that is
// cut anywhere, rows without a value or with two values, elements in a wrong place, and more than one message.
TEST(OemXml, NamesTheLineOfAMistake)
{
    EXPECT_EQ(xmlRefusal(changed(kXml, ">EARTH<", ">MARS<")),
              "a.xml:24: The centre is \"MARS\". Boresight reads only orbits with CENTER_NAME = EARTH.");
    EXPECT_EQ(xmlRefusal(changed(kXml, "<Z units=\"km\">-6746.8</Z>", "")), "a.xml:31: The row has no <Z>.");
    EXPECT_EQ(xmlRefusal(changed(kXml, "<Y_DDOT>0</Y_DDOT>", "")), "a.xml:37: The row has no <Y_DDOT>.");
    EXPECT_THAT(xmlRefusal(changed(kXml, "2789.6", "2789600")), StartsWith("a.xml:31: The position is 2.78961e+06 km"));
    EXPECT_EQ(xmlRefusal(changed(kXml, "2789.6", "nan")), "a.xml:31: \"nan\" is not a number.");
    EXPECT_EQ(xmlRefusal(changed(kXml, "2789.6", "2789.6 1 2 3")),
              "a.xml:29: X is \"2789.6 1 2 3\". It must be one value.");
    EXPECT_EQ(xmlRefusal(changed(kXml, "<Y units", "<X>1</X><Y units")),
              "a.xml:29: The element <X> has no place here in an OEM.");
    EXPECT_EQ(xmlRefusal(changed(kXml, "<data>", "<rows>")),
              "a.xml:25: The element <rows> has no place here in an OEM.");
    const std::size_t begin = kXml.find("<metadata>");
    const std::size_t end = kXml.find("</metadata>") + 11;
    EXPECT_THAT(xmlRefusal(kXml.substr(0, begin) + kXml.substr(end)),
                HasSubstr("The element <data> has no place here"));
    EXPECT_THAT(xmlRefusal(changed(kXml, "version=\"2.0\"", "")), HasSubstr("The version \"\" of OEM is not known."));
    EXPECT_THAT(xmlRefusal("<ndm>" + message() + message() + "</ndm>"), HasSubstr("The file has a second <oem>."));
    EXPECT_EQ(xmlRefusal("\n<opm/>"), "a.xml:2: The file has an element <opm>. Boresight tracks only <oem>.");
    EXPECT_THAT(xmlRefusal("<ndm></ndm>"), HasSubstr("The file has no META_START and no rows."));
    EXPECT_THAT(xmlRefusal(kXml + "<a>"), HasSubstr("This is not valid XML: "));
    EXPECT_THAT(xmlRefusal("<oem version=\"2.0\">\r\r\r\n</o>"), StartsWith("a.xml:2: "));
    for (std::size_t size = 40; size < kXml.rfind("</oem>") + 6; size += 3) {
        EXPECT_THAT(xmlRefusal(kXml.substr(0, size)), StartsWith("a.xml:")) << size;
    }
}

// REQ-TABLES-928: An OEM in XML that would fill the memory is refused: deeply nested elements, or entities that expand.
TEST(OemXml, RefusesWhatFillsTheMemory)
{
    std::string nested = "<a>";
    for (int i = 0; i < 40; ++i) {
        nested += nested.size() < 3000 ? nested : std::string();
    }
    EXPECT_THAT(xmlRefusal(changed(kXml, "THIS IS", nested)),
                HasSubstr("This is not valid XML: More than 32 elements stand inside one another."));
    const std::string entities =
        "<!DOCTYPE oem [<!ENTITY a \"0123456789\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">"
        "<!ENTITY c \"&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;\"><!ENTITY d \"&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;\">]>";
    EXPECT_THAT(xmlRefusal(entities + changed(message(), "NASA/JPL", "&d;&d;")), HasSubstr("entity expansion limit"));
}

}  // namespace
}  // namespace boresight::tables
