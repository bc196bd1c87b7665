// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/rotctld/command_parser.h"

#include <cstddef>
#include <string>
#include <string_view>

// Writes the answer to one command in the form the client asked for: default (values or RPRT) or extended (header,
// labelled values, RPRT, with the client's separator). Pure.
namespace boresight::rotctld {

// The number that a client receives: 0 done, else negative (README.md has the table).
[[nodiscard]] int rprtCode(const Error& error);

class ReplyWriter
{
public:
    // Appends to `reply`, which must outlive this and `command`.
    ReplyWriter(const Command& command, std::string& reply);

    void value(std::string_view text);  // under the command's next label
    void line(std::string_view text);   // unlabelled, ended by the separator
    void text(std::string_view lines);  // as it is

    void finish(const Result<>& outcome);

private:
    const Command& m_command;
    std::string& m_reply;
    std::size_t m_nextLabel = 0;
    std::size_t m_bodyStart = 0;
};

}  // namespace boresight::rotctld
