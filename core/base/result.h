// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <tl/expected.hpp>
#include <utility>

// The result of a function that may fail: a code for the program and a sentence for the operator. tl::expected is used
// until the oldest compiler is g++ 13. Then only this file changes to std::expected.
namespace boresight {

enum class ErrorCode
{
    InvalidInput,  // the text or number is invalid: not a number, unknown key, wrong type
    OutOfRange,    // well formed, but outside what is permitted
    Refused,       // the station does not do this now: stop latched, operator holds authority, fault
    NotAvailable,  // this mount or program does not have it
    NoDevice,      // the device, interface or file is absent
    NoAnswer,      // the device exists but does not reply; data too old
    Denied,        // permission missing
    Busy,          // somebody else uses it
    Protocol,      // the other side sends something unreadable
    Io,            // reading or writing failed
};

struct Error
{
    ErrorCode code = ErrorCode::Io;
    QString text;  // one sentence: what, where, what to do

    bool operator==(const Error&) const = default;
};

template <class T = void>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> failure(ErrorCode code, QString text)
{
    return tl::unexpected<Error>(Error{code, std::move(text)});
}

}  // namespace boresight
