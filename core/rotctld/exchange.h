// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <cstddef>
#include <string_view>

// One line or datagram of a client, what became of it, and the answer: for the protocol log. The views are valid during
// the call that passes it. Station thread.
namespace boresight::rotctld {

struct Exchange
{
    std::string_view line = {};     // as received, without its line end
    std::size_t size = 0;           // of the line in bytes, if `line` is only its beginning
    std::string_view command = {};  // its name in the protocol, for a line that asks nothing of the mount; may be empty
    std::string_view answer = {};   // as sent; may be empty
    Result<> result = {};           // InvalidInput: the line was not understood
    QString became = {};            // the changed target, as text; empty if unchanged
    bool odd = false;               // one of the odd commands of the client, or of another protocol
};

}  // namespace boresight::rotctld
