// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/satellite_mark.h"

#include <gtest/gtest.h>

namespace boresight::orbit {
namespace {

TEST(SatelliteMarks, OfASatelliteWithoutAMarkNothingIsKept)
{
    SatelliteMarks marks;
    EXPECT_FALSE(isFavourite(marks, 25544));
    EXPECT_EQ(noteOf(marks, 25544), "");
    setFavourite(marks, 25544, true);
    setNote(marks, 25544, "145.800 MHz");
    EXPECT_EQ(marks, (SatelliteMarks{{.number = 25544, .favourite = Favourite::On, .note = "145.800 MHz"}}));
    EXPECT_TRUE(isFavourite(marks, 25544));
    setFavourite(marks, 25544, false);
    EXPECT_EQ(noteOf(marks, 25544), "145.800 MHz") << "a note is kept of any satellite";
    setNote(marks, 25544, "");
    EXPECT_TRUE(marks.empty());
}

TEST(SatelliteMarks, EachSatelliteHasItsOwn)
{
    SatelliteMarks marks;
    setNote(marks, 33591, "137.100 MHz");
    setFavourite(marks, 25544, true);
    EXPECT_FALSE(isFavourite(marks, 33591));
    EXPECT_EQ(noteOf(marks, 33591), "137.100 MHz");
    EXPECT_EQ(noteOf(marks, 25544), "");
    setFavourite(marks, 43013, false);
    EXPECT_EQ(marks.size(), 2U);
}

TEST(SatelliteMarks, AnAntennaIsKeptOfASatellite)
{
    SatelliteMarks marks;
    EXPECT_EQ(antennaOf(marks, 25544), "");
    setAntenna(marks, 25544, "70 cm");
    EXPECT_EQ(antennaOf(marks, 25544), "70 cm");
    EXPECT_EQ(antennaOf(marks, 33591), "");
    setAntenna(marks, 25544, "");
    EXPECT_TRUE(marks.empty());
}

}  // namespace
}  // namespace boresight::orbit
