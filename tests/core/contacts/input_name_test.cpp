// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contacts/input_name.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::contacts {
namespace {

InputName inputNamed(const std::string& text)
{
    const auto name = parseInput(text);
    EXPECT_TRUE(name) << text;
    return name.value_or(InputName{});
}

// REQ-ENDSWITCH-01: The input of a switch is a pin of a moteus, a topic of the MQTT broker, or one of the lines CTS,
// DSR, DCD and RI of a serial port. Paths begin with /. A pin has the numbers of the configuration of its board.
TEST(InputName, IsAPinATopicOrALine)
{
    EXPECT_EQ(inputNamed("").kind, InputKind::None);
    EXPECT_EQ(inputNamed("moteus:1:aux1.0"),
              (InputName{.kind = InputKind::Pin, .pin = {.board = 1, .port = 1, .number = 0}}));
    EXPECT_EQ(inputNamed("moteus:126:aux2.4"),
              (InputName{.kind = InputKind::Pin, .pin = {.board = 126, .port = 2, .number = 4}}));
    EXPECT_EQ(inputNamed("mqtt:shack/end"), (InputName{.kind = InputKind::Mqtt, .place = QStringLiteral("shack/end")}));
    EXPECT_EQ(inputNamed("cts:/dev/ttyUSB0"),
              (InputName{.kind = InputKind::Cts, .place = QStringLiteral("/dev/ttyUSB0")}));
    EXPECT_EQ(inputNamed("dsr:/dev/ttyUSB0").kind, InputKind::Dsr);
    EXPECT_EQ(inputNamed("dcd:/dev/ttyUSB0").kind, InputKind::Dcd);
    EXPECT_EQ(inputNamed("ri:/dev/ttyUSB0").kind, InputKind::Ri);
    EXPECT_TRUE(inputNamed("ri:/dev/ttyUSB0").isLine());
    EXPECT_FALSE(inputNamed("mqtt:a").isLine());
}

// REQ-ENDSWITCH-01
TEST(InputName, RefusesAllElse)
{
    for (const char* const text :
         {"moteus:",          "moteus:1",        "moteus:1:aux1",    "moteus:1:aux1.",    "moteus:1:aux1.5",
          "moteus:1:aux3.0",  "moteus:1:aux0.0", "moteus:0:aux1.0",  "moteus:127:aux1.0", "moteus:1:aux1.-1",
          "moteus:1:aux1.0 ", "moteus::aux1.0",  "moteus:1:gpio1.0", "moteus:1.0:aux1",   "mqtt:",
          "mqtt:a/#",         "mqtt:$SYS/a",     "cts:ttyUSB0",      "CTS:/dev/ttyUSB0",  "file:/run/end",
          "dtr:/dev/ttyUSB0", "aux1.0",          "mqtt:a\nb"}) {
        EXPECT_FALSE(parseInput(text)) << text;
    }
    EXPECT_FALSE(parseInput("mqtt:" + std::string(1000, 'a')));
}

// REQ-ENDSWITCH-02: A message about a contact is on or off, in any case, or 1, 0, true or false. Everything else is
// refused, and is no reading.
TEST(InputName, AMessageIsOnOrOff)
{
    for (const char* const text : {"on", "ON", " On\r\n", "1", "true", "TRUE"}) {
        EXPECT_EQ(readContact(text), Result<bool>(true)) << text;
    }
    for (const char* const text : {"off", "OFF", "\toff", "0", "false"}) {
        EXPECT_EQ(readContact(text), Result<bool>(false)) << text;
    }
    for (const char* const text : {"", " ", "2", "on off", "pressed", "{\"state\":\"on\"}", "nan", "offf"}) {
        EXPECT_FALSE(readContact(text)) << text;
    }
    EXPECT_FALSE(readContact(std::string(100000, 'o')));
}

}  // namespace
}  // namespace boresight::contacts
