// SPDX-License-Identifier: GPL-3.0-or-later
// REQ-TABLES-925 (Fuzz.oem): Any bytes are read as an OEM, or refused with file, line and a short printable reason. An
// accepted OEM gives directions, or none with a reason, and nothing outside its usable times.
#include "tests/fuzz/harness.h"
#include "tests/fuzz/table_promises.h"

#include <string>

namespace boresight::fuzz {
namespace {

std::string oemText(const std::string& frame, const std::string& system, const std::string& more)
{
    return "CCSDS_OEM_VERS = 2.0\nCOMMENT x\nCREATION_DATE = 2026-12-23T12:00:00\nORIGINATOR = TEST\nMETA_START\n"
           "OBJECT_NAME = TEST ONE\nOBJECT_ID = 1998-067A\nCENTER_NAME = EARTH\nREF_FRAME = " +
           frame + "\nTIME_SYSTEM = " + system +
           "\nSTART_TIME = 2026-12-24T00:00:00\nSTOP_TIME = 2026-12-24T00:04:00\n" + more +
           "META_STOP\n"
           "2026-12-24T00:00:00 7000.0 0.0 10.0 0.0 7.5 0.1\n"
           "2026-12-24T00:01:00 6985.3 449.7 16.0 -0.48 7.48 0.1\n"
           "2026-358T00:02:00.5 6941.2 897.5 22.0 -0.96 7.44 0.1 1e-3 0 0\n"
           "2026-12-24T00:04:00 6766.1 1773.7 33.0 -1.9 7.25 0.1\n";
}

std::string xmlText()
{
    std::string text =
        "<ndm><oem id=\"CCSDS_OEM_VERS\" "
        "version=\"2.0\"><header><COMMENT>x</COMMENT></header><body><segment>\n<metadata>"
        "<OBJECT_NAME>A</OBJECT_NAME><CENTER_NAME>EARTH</CENTER_NAME><REF_FRAME>GCRF</REF_FRAME>"
        "<TIME_SYSTEM>UTC</TIME_SYSTEM></metadata><data>\n";
    for (const char* const row : {"00:00</EPOCH><X>7000.0</X><Y>0</Y>", "01:00</EPOCH><X>6985.3</X><Y>449.7</Y>"}) {
        text += std::string("<stateVector><EPOCH>2026-12-24T00:") + row +
                "<Z>9</Z><X_DOT>0</X_DOT><Y_DOT>7.5</Y_DOT><Z_DOT>0</Z_DOT></stateVector>\n";
    }
    return text + "<covarianceMatrix><CX_X>1</CX_X></covarianceMatrix></data></segment></body></oem></ndm>";
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    grammar.corpus = {
        oemText("ITRF2014", "UTC", "INTERPOLATION = HERMITE\nINTERPOLATION_DEGREE = 7\n"),
        oemText("TEME", "TAI", "USEABLE_START_TIME = 2026-12-24T00:01:00\nUSEABLE_STOP_TIME = 2026-12-24T00:03:00\n"),
        oemText("EME2000", "GPS", "INTERPOLATION = LAGRANGE\nINTERPOLATION_DEGREE = 5\n") +
            "COVARIANCE_START\nEPOCH = 2026-12-24T00:01:00\n1\n2 3\nCOVARIANCE_STOP\n",
        oemText("TOD", "TT", "INTERPOLATION = LINEAR\n"), xmlText()};
    grammar.tokens = {"META_START",
                      "META_STOP",
                      "COVARIANCE_START",
                      "COVARIANCE_STOP",
                      "COMMENT",
                      "HERMITE",
                      "LAGRANGE",
                      "LINEAR",
                      "UTC",
                      "TAI",
                      "GPS",
                      "TT",
                      "TDB",
                      "GCRF",
                      "ITRF",
                      "TEME",
                      "TOD",
                      "MOON",
                      "EARTH",
                      "25",
                      "26",
                      "0",
                      "-1",
                      "nan",
                      "inf",
                      "1e308",
                      "7000",
                      "-7000",
                      "2000000",
                      "6000",
                      "100",
                      "2016-12-31T23:59:60",
                      "1957",
                      "2199",
                      "=",
                      "<",
                      "\r\n",
                      "\n",
                      "\xff",
                      "\x1b",
                      "1e-300",
                      "REF_FRAME_EPOCH = 2026-12-24T00:00:00\n"};
    grammar.separators = " \n=:-.";
    grammar.maxLength = 2048;
    grammar.persistence = 30;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    feedTable(asText(input));
}

}  // namespace boresight::fuzz
