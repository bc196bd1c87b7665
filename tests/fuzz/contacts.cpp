// SPDX-License-Identifier: GPL-3.0-or-later
// Names of inputs and outputs, and messages about a contact: any bytes to their parsers.
#include "core/contacts/input_name.h"
#include "core/contacts/output_name.h"
#include "tests/fuzz/harness.h"

#include <string>

namespace boresight::fuzz {

Grammar grammar()
{
    Grammar grammar;
    grammar.corpus = {
        "moteus:1:aux1.0", "mqtt:shack/end", "cts:/dev/ttyUSB0", "ri:/dev/serial/by-id/usb-x", "file:/run/brake", "on",
        "OFF\n",           " true "};
    grammar.tokens = {"moteus:",
                      ":aux",
                      "aux1.",
                      "aux2",
                      "mqtt:",
                      "cts:",
                      "dsr:",
                      "dcd:",
                      "ri:",
                      "/dev/",
                      "/",
                      ".",
                      ":",
                      "-1",
                      "126",
                      "127",
                      "+",
                      "#",
                      "$",
                      "on",
                      "off",
                      "true",
                      "false",
                      "0",
                      "1",
                      "\n",
                      "\xff",
                      "\"",
                      std::string(1, '\0')};
    grammar.separators = " :./\n";
    grammar.maxLength = 300;
    grammar.persistence = 30;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const std::string text(asText(input));
    if (const auto name = contacts::parseInput(text)) {
        const contacts::BoardPin& pin = name->pin;
        const bool isPin = pin.board >= 1 && pin.board <= 126 && (pin.port == 1 || pin.port == 2) && pin.number >= 0 &&
                           pin.number <= 4;
        require(name->kind != contacts::InputKind::Pin || isPin, "a pin that a board has");
        require(!name->isLine() || name->place.startsWith(QLatin1Char('/')), "the path of a port");
        accept();
    }
    if (const auto name = contacts::parseOutput(text)) {
        const bool hasPlace = name->kind != contacts::OutputKind::None && name->kind != contacts::OutputKind::Pin;
        require(!hasPlace || !name->place.isEmpty(), "an output has a place");
        require(name->kind != contacts::OutputKind::Pin || (name->pin.board >= 1 && name->pin.number <= 4),
                "a pin that a board has");
        accept();
    }
    if (contacts::readContact(text)) {
        require(text.size() < 400, "a word");
        accept();
    }
}

}  // namespace boresight::fuzz
