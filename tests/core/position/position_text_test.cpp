// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/position/position_text.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::position {
namespace {

using namespace std::chrono_literals;

PositionText read(std::string_view text)
{
    const auto position = readPosition(text);
    EXPECT_TRUE(position) << text;
    return position.value_or(PositionText{});
}

// REQ-POSITION-01: A position is a line with degrees north, degrees east and metres, optionally followed by the time of
// day.
TEST(PositionText, IsALine)
{
    const PositionText plain = read("38.757,-9.117,1200");
    EXPECT_NEAR(plain.site.latitude.degrees(), 38.757, 1e-12);
    EXPECT_NEAR(plain.site.longitude.degrees(), -9.117, 1e-12);
    EXPECT_EQ(plain.site.heightMetres, 1200.0);
    EXPECT_FALSE(plain.time);
    EXPECT_TRUE(plain.name.isEmpty());
    EXPECT_NEAR(read(" 38.757 ,\t350.883, 1200 \r\n").site.longitude.degrees(), -9.117, 1e-9);
    EXPECT_EQ(read("38.757,-9.117,1200,12:06:04").time, 12h + 6min + 4s);
    EXPECT_EQ(read("38.757,-9.117,1200,12:06:04.25Z").time, 12h + 6min + 4250ms);
    EXPECT_EQ(read("-38.757,-9.117,-30.5,2026-11-27T23:59:59.999Z").time, 23h + 59min + 59999ms);
}

// As radiosonde_auto_rx sends it, to UDP port 55673: the fields that are used here, and some that are not.
// REQ-POSITION-02: A position is a JSON object as radiosonde_auto_rx and Horus send it by UDP, with latitude,
// longitude, altitude, and optionally callsign and time. The names lat, lon and alt are accepted as well.
TEST(PositionText, IsAnObjectOfAutoRx)
{
    const PositionText sonde = read(
        R"({"type": "PAYLOAD_SUMMARY", "station": "HOME", "callsign": "V2850795", "latitude": 46.2590563,
            "longitude": 13.1551694, "altitude": 1001.84319, "speed": 72.185796, "heading": 124.94138,
            "time": "12:06:04", "comment": "Radiosonde", "model": "RS41-SG", "freq": "403.9990 MHz", "temp": -65.4,
            "frame": 6031, "sats": 9, "snr": 11.3, "fest": [-2250.0, 2625.0], "vel_v": 5.62612})");
    EXPECT_EQ(sonde, (PositionText{.site = {.latitude = Angle::fromDegrees(46.2590563),
                                            .longitude = Angle::fromDegrees(13.1551694),
                                            .heightMetres = 1001.84319},
                                   .name = QStringLiteral("V2850795"),
                                   .time = 12h + 6min + 4s}));
    const PositionText brief = read(R"({"lat":"46.5","lon":-13,"alt":0,"time":"soon"})");
    EXPECT_EQ(brief, (PositionText{.site = {.latitude = 46.5_deg, .longitude = -13_deg}}));
}

// REQ-POSITION-03: An incomplete position is refused: half a line, numbers out of range, text in place of a number,
// another object. 0, 0 is refused, because a receiver without a GPS fix sends it.
TEST(PositionText, AllElseIsRefused)
{
    for (const char* const text : {"",
                                   "\n",
                                   "38.757",
                                   "38.757,-9.117",
                                   "38.757,-9.117,",
                                   "38.757,-9.117,1200,",
                                   "38.757,-9.117,1200,soon",
                                   "38.757,-9.117,1200,12:06:04,1",
                                   "38.757 -9.117 1200",
                                   "90.001,0,0",
                                   "-90.001,0,0",
                                   "1,-180.001,0",
                                   "1,360.001,0",
                                   "1,1,2000001",
                                   "1,1,-1001",
                                   "nan,1,1",
                                   "1,inf,1",
                                   "1e400,1,1",
                                   "0x10,1,1",
                                   "0,0,100",
                                   "1,1,1,24:00:00",
                                   "1,1,1,12:60:00",
                                   "1,1,1,12:00:60",
                                   "{}",
                                   "{\"latitude\":1,\"longitude\":1}",
                                   "{\"latitude\":1,\"longitude\":1,\"altitude\":null}",
                                   "{\"latitude\":91,\"longitude\":1,\"altitude\":1}",
                                   "{\"latitude\":0,\"longitude\":0,\"altitude\":0}",
                                   "[1,1,1]",
                                   "{\"latitude\":1,",
                                   "{\"latitude\":\"x\",\"longitude\":1,\"altitude\":1}"}) {
        EXPECT_FALSE(readPosition(text)) << text;
    }
    EXPECT_FALSE(readPosition("1,1,1" + std::string(kLongestPosition, ' ')));
}

// REQ-POSITION-04: An object whose type is not PAYLOAD_SUMMARY is refused: Horus programs send the position of the
// chase car as "GPS" to the same port.
TEST(PositionText, TheCarIsNotTheBalloon)
{
    for (const char* const type : {"\"GPS\"", "\"payload\"", "1", "null"}) {
        const auto car = readPosition(
            std::string(R"({"latitude":46.5,"longitude":13.1,"altitude":210,"speed":14.2,"type":)") + type + "}");
        ASSERT_FALSE(car) << type;
        EXPECT_EQ(car.error().text, QStringLiteral("the object is not a PAYLOAD_SUMMARY"));
    }
}

// REQ-POSITION-03
TEST(PositionText, ANameIsOneShortLine)
{
    const std::string text =
        R"({"latitude":1,"longitude":1,"altitude":1,"callsign":" a\n)" + std::string(100, 'b') + "\"}";
    EXPECT_EQ(read(text).name, QStringLiteral("a ") + QString(38, QLatin1Char('b')));
    EXPECT_EQ(read(R"({"latitude":1,"longitude":1,"altitude":1,"callsign":"a\u001bb"})").name, QStringLiteral("a?b"));
}

}  // namespace
}  // namespace boresight::position
