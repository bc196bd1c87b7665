// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/rotctld/command_parser.h"

#include <cstddef>
#include <string>
#include <string_view>

// Writes the reply to one command in the form that the client asked for: default (values or RPRT) or extended (header,
// labelled values, RPRT, with the separator of the client). Pure.
namespace boresight::rotctld {

// The RPRT code for the client: 0 for success, otherwise negative (table in README.md).
[[nodiscard]] int rprtCode(const Error& error);

class ReplyWriter
{
public:
    // Appends to `reply`. Both references must outlive this.
    ReplyWriter(const Command& command, std::string& reply);

    void value(std::string_view text);  // with the next label of the command
    void line(std::string_view text);   // without label, with the separator at its end
    void text(std::string_view lines);  // unchanged

    void finish(const Result<>& outcome);

private:
    const Command& m_command;
    std::string& m_reply;
    std::size_t m_nextLabel = 0;
    std::size_t m_bodyStart = 0;
};

}  // namespace boresight::rotctld
