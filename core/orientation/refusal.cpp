// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/refusal.h"

namespace boresight::orientation {

std::string toText(const Refused& refused)
{
    const std::string& field = refused.field;
    switch (refused.reason) {
        case Refusal::WrongChecksum:
            return "checksum";
        case Refusal::NoChecksum:
            return "no checksum";
        case Refusal::BadChecksum:
            return "checksum is not hexadecimal";
        case Refusal::Truncated:
            return "truncated";
        case Refusal::TooLong:
            return "too long";
        case Refusal::FieldCount:
            return field.empty() ? "field count" : field + " is missing";
        case Refusal::Unit:
            return "unit";
        case Refusal::NotANumber:
            return field + " is not a number";
        case Refusal::NotFinite:
            return field + " is not finite";
        case Refusal::OutOfRange:
            return field + " out of range";
        case Refusal::Retained:
            return "kept by the broker, not live";
        case Refusal::NotJson:
            break;
    }
    return "no JSON";
}

}  // namespace boresight::orientation
