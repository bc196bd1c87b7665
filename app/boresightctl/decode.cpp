// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/subcommand.h"
#include "core/base/hex.h"
#include "core/base/numbers.h"
#include "core/base/result.h"
#include "core/base/text.h"
#include "core/can/bus_frame.h"
#include "core/moteus/describe.h"

#include <algorithm>

namespace boresight::ctl {
namespace {

Result<std::uint32_t> readId(std::string_view text)
{
    const bool prefixed = text.starts_with("0x") || text.starts_with("0X");
    const std::optional<std::int64_t> id = parseInteger(prefixed ? text.substr(2) : text, 16);
    if (!id) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("\"%1\" is not a CAN identifier: expected hexadecimal like 8001 or 0x8001")
                           .arg(toQString(text)));
    }
    if (*id < 0 || *id > kMaxExtendedId) {
        return failure(
            ErrorCode::OutOfRange,
            QStringLiteral("identifier %1 is outside 0…1fffffff: a CAN identifier has 29 bits").arg(toQString(text)));
    }
    return static_cast<std::uint32_t>(*id);
}

Result<std::vector<std::uint8_t>> readBytes(const std::string& digits)
{
    const auto* const isDigit = "0123456789abcdefABCDEF";
    if (const std::size_t bad = digits.find_first_not_of(isDigit); bad != std::string::npos) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("'%1' at place %2 of the data is not a hexadecimal digit")
                           .arg(toQString(digits.substr(bad, 1)), QString::number(bad + 1)));
    }
    const auto bytes = parseHex(digits);
    if (!bytes) {
        return failure(
            ErrorCode::InvalidInput,
            QStringLiteral("the data has %1 digits, an odd number. Each byte has two digits").arg(digits.size()));
    }
    if (bytes->size() > kMaxCanPayload) {
        return failure(ErrorCode::OutOfRange,
                       QStringLiteral("the data has %1 bytes: a CAN-FD frame carries 64 at most").arg(bytes->size()));
    }
    return *bytes;
}

// The data may come in several pieces, as in logs: "11 00 1f" as one argument or as three.
Result<CanFrame> readFrame(Arguments arguments)
{
    std::string digits;
    for (const std::string& piece : arguments.subspan(1)) {
        digits += piece;
    }
    std::erase(digits, ' ');
    return readId(arguments.front()).and_then([&](std::uint32_t id) {
        return readBytes(digits).map([&](const std::vector<std::uint8_t>& bytes) {
            CanFrame frame{.id = id, .extended = id > kMaxStandardId};
            frame.setPayload(bytes);
            return frame;
        });
    });
}

ExitStatus runDecode(Arguments arguments)
{
    if (arguments.empty()) {
        return usageError(kDecodeCommand, QStringLiteral("write the identifier and the data of a frame"));
    }
    const Result<CanFrame> frame = readFrame(arguments);
    if (!frame) {
        return usageError(kDecodeCommand, frame.error().text);
    }
    print(moteus::describe(*frame));
    return kDone;
}

}  // namespace

const Subcommand kDecodeCommand{
    .name = "decode",
    .arguments = "ID [HEX …]",
    .summary = "Explain a frame of the moteus protocol in words",
    .details = R"(ID is the CAN identifier in hexadecimal, with or without 0x. HEX is the data, with or without blanks.
The first line shows sender and receiver. Then each register, error, tunnel packet and run of padding has one line.

Example:
  boresightctl decode 8001 01 00 0a 0e 20 00 00 80 3e 00 00 00 00 11 00 1f 01
)",
    .run = runDecode};

}  // namespace boresight::ctl
