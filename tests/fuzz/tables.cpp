// SPDX-License-Identifier: GPL-3.0-or-later
// REQ-TABLES-914 (Fuzz.tables): Any bytes are read as a tracking table, or refused with file, line and a short
// printable reason. An accepted table gives directions, and nothing outside its rows.
#include "tests/fuzz/harness.h"
#include "tests/fuzz/table_promises.h"

namespace boresight::fuzz {

Grammar grammar()
{
    Grammar grammar;
    grammar.corpus = {"2026-12-24T00:00:00Z,10.5,20\n2026-12-24T00:01:00Z,349.5,20.25\n2026-12-24T00:02:00Z,340,-3\n",
                      "# Moon\r\n\r\n2026-12-24 00:00:00 10 20\r\n2026-12-24 00:30:00 -10.5 +60\r\n",
                      "t_utc,az_deg,el_deg,range_km\n2026-358T00:00:00.5,0,-1,400.5\n2026-358T00:00:30.5,0,1,300\n",
                      "1798070400 100 80\n1798070460.25 200 85\n1798080000 10 5\n1798080010 11 6\n",
                      "2016-12-31T23:59:59 10 0\n2016-12-31T23:59:60 11 1\n2017-01-01T00:00:00 12 2\n"};
    grammar.tokens = {"nan",
                      "inf",
                      "1e308",
                      "1e-308",
                      "-0.0",
                      "360",
                      "-360",
                      "90",
                      "-90",
                      "90.0001",
                      "+00:00",
                      "Z",
                      "T",
                      ":60",
                      "366",
                      "#",
                      "\"",
                      "\r\n",
                      "\n",
                      "\t",
                      ";;",
                      ",,",
                      "az el",
                      "<",
                      "2199",
                      "1957",
                      "1e8",
                      "7e9",
                      "e",
                      "\xff",
                      "\xef\xbb\xbf",
                      "\x1b",
                      "CCSDS_OEM_VERS = 2.0"};
    grammar.separators = " ,;\n\t:-";
    grammar.maxLength = 1024;
    grammar.persistence = 30;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    feedTable(asText(input));
}

}  // namespace boresight::fuzz
