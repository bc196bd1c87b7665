// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/record_table.h"

#include <gtest/gtest.h>

namespace boresight::ctl {
namespace {

// REQ-CTL-02: Tables are CSV, JSON or columns. A name may contain the separators. A missing number is an empty cell,
// and null in JSON.
TEST(RecordTable, IsCsvJsonOrColumns)
{
    const RecordTable table{.columns = {{"name"}, {"az", true}, {"flags"}},
                            .rows = {{"A, \"B\"\\", "1.50", "-"}, {"Łódź\x01", "", "AL"}, {"", "-12.25", ""}}};
    EXPECT_EQ(table.text(TableFormat::Csv),
              "name,az,flags\n"
              "\"A, \"\"B\"\"\\\",1.50,-\n"
              "Łódź\x01,,AL\n"
              ",-12.25,\n");
    EXPECT_EQ(table.text(TableFormat::Json),
              "[\n"
              "{\"name\": \"A, \\\"B\\\"\\\\\", \"az\": 1.50, \"flags\": \"-\"},\n"
              "{\"name\": \"Łódź\\u0001\", \"az\": null, \"flags\": \"AL\"},\n"
              "{\"name\": \"\", \"az\": -12.25, \"flags\": \"\"}\n"
              "]\n");
    EXPECT_EQ(table.text(TableFormat::Table),
              "name         az  flags\n"
              "A, \"B\"\\    1.50  -\n"
              "Łódź\x01            AL\n"
              "         -12.25\n");
}

// REQ-CTL-02
TEST(RecordTable, WithoutRowsHasItsNames)
{
    const RecordTable table{.columns = {{"name"}, {"az", true}}, .rows = {}};
    EXPECT_EQ(table.text(TableFormat::Csv), "name,az\n");
    EXPECT_EQ(table.text(TableFormat::Json), "[\n]\n");
    EXPECT_EQ(table.text(TableFormat::Table), "name  az\n");
}

}  // namespace
}  // namespace boresight::ctl
