// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contacts/output_name.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::contacts {
namespace {

OutputName named(const std::string& text)
{
    const auto name = parseOutput(text);
    EXPECT_TRUE(name) << text;
    return name.value_or(OutputName{});
}

// REQ-TRANSMIT-01: The output is a file, a topic of the MQTT broker, a program with its arguments, or the line DTR or
// RTS of a serial port. Paths begin with /. There is no shell, and double quotes keep an argument with spaces together.
TEST(OutputName, IsAFileATopicAProgramOrALine)
{
    EXPECT_EQ(named("").kind, OutputKind::None);
    EXPECT_EQ(named("file:/run/boresight/transmit"),
              (OutputName{.kind = OutputKind::File, .place = QStringLiteral("/run/boresight/transmit")}));
    EXPECT_EQ(named("mqtt:shack/transmit"),
              (OutputName{.kind = OutputKind::Mqtt, .place = QStringLiteral("shack/transmit")}));
    EXPECT_EQ(named("dtr:/dev/ttyUSB0"),
              (OutputName{.kind = OutputKind::Dtr, .place = QStringLiteral("/dev/ttyUSB0")}));
    EXPECT_EQ(named("rts:/dev/serial/by-id/usb-x"),
              (OutputName{.kind = OutputKind::Rts, .place = QStringLiteral("/dev/serial/by-id/usb-x")}));
    EXPECT_EQ(named("command:/usr/bin/ptt --line 2 \"a b\" ; rm"),
              (OutputName{.kind = OutputKind::Command,
                          .place = QStringLiteral("/usr/bin/ptt"),
                          .arguments = {QStringLiteral("--line"), QStringLiteral("2"), QStringLiteral("a b"),
                                        QStringLiteral(";"), QStringLiteral("rm")}}));
}

// REQ-BRAKE-46: A brake output may be a pin of a moteus. The board, the port and the pin must exist. The transmit
// output may not be such a pin, and no end switch may have the same one.
TEST(OutputName, IsAPinOfABoard)
{
    EXPECT_EQ(named("moteus:3:aux2.4"),
              (OutputName{.kind = OutputKind::Pin, .pin = {.board = 3, .port = 2, .number = 4}}));
    for (const char* const text :
         {"moteus:", "moteus:0:aux1.0", "moteus:1:aux3.0", "moteus:1:aux1.5", "moteus:1:aux1"}) {
        EXPECT_FALSE(parseOutput(text)) << text;
    }
}

// REQ-TRANSMIT-01
TEST(OutputName, RefusesAllElse)
{
    for (const char* const text : {"/run/transmit", "file:", "file:transmit", "file:/run/", "mqtt:", "mqtt:a/#",
                                   "mqtt:+/a", "mqtt:$SYS/a", "command:", "command:ptt on", "command: ", "dtr:ttyUSB0",
                                   "DTR:/dev/ttyUSB0", "rts", "gpio:17", "file:/run/a\nb"}) {
        EXPECT_FALSE(parseOutput(text)) << text;
    }
    EXPECT_FALSE(parseOutput("file:/" + std::string(1000, 'a')));
    EXPECT_FALSE(parseOutput(std::string("file:/run/a\0b", 13)));
}

}  // namespace
}  // namespace boresight::contacts
