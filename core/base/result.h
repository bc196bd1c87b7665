// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <tl/expected.hpp>
#include <utility>

// How our own functions say that something did not work: a code for the program, a sentence for the operator.
// tl::expected stands in for std::expected until the compiler floor is g++ 13; only this file changes then.
namespace boresight {

enum class ErrorCode
{
    InvalidInput,  // the text or number makes no sense: not a number, unknown key, wrong type
    OutOfRange,    // well formed, but outside what is permitted
    Refused,       // the station does not do this now: stop latched, operator holds authority, fault
    NotAvailable,  // this mount or program does not have it
    NoDevice,      // the device, interface or file is absent
    NoAnswer,      // the device is there but stays silent; data too old
    Denied,        // permission missing
    Busy,          // somebody else holds it
    Protocol,      // the other side says something we cannot read
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
