// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/reply_format.h"

namespace boresight::rotctld {

int rprtCode(const Error& error)
{
    switch (error.code) {
        case ErrorCode::InvalidInput:
        case ErrorCode::OutOfRange:  // not Hamlib 4.6's -21: SDRangel's table of texts ends at 18
            return -1;
        case ErrorCode::NoAnswer:
        case ErrorCode::NoDevice:
        case ErrorCode::Io:
            return -6;
        case ErrorCode::Protocol:
            return -8;
        case ErrorCode::Refused:
        case ErrorCode::Busy:
        case ErrorCode::Denied:
            return -9;
        case ErrorCode::NotAvailable:
            return -11;
    }
    return -7;
}

ReplyWriter::ReplyWriter(const Command& command, std::string& reply) : m_command(command), m_reply(reply)
{
    if (command.extended && command.spec->ending != Ending::Silent) {
        m_reply.append(command.spec->name).append(":");
        for (std::size_t i = 0; i < command.argumentCount; ++i) {
            m_reply.append(" ").append(command.arguments[i]);
        }
        m_reply += command.separator;
    }
    m_bodyStart = m_reply.size();
}

void ReplyWriter::value(std::string_view text)
{
    if (m_command.extended) {
        m_reply.append(m_command.spec->labels[m_nextLabel]).append(": ");
    }
    ++m_nextLabel;
    line(text);
}

void ReplyWriter::line(std::string_view text)
{
    m_reply.append(text);
    m_reply += m_command.extended ? m_command.separator : '\n';
}

void ReplyWriter::text(std::string_view lines)
{
    m_reply.append(lines);
}

void ReplyWriter::finish(const Result<>& outcome)
{
    if (!outcome) {
        m_reply.resize(m_bodyStart);  // a failed command has no values
    } else if (m_command.spec->ending == Ending::Silent ||
               (m_command.spec->ending == Ending::Values && !m_command.extended)) {
        return;
    }
    m_reply.append("RPRT ").append(std::to_string(outcome ? 0 : rprtCode(outcome.error()))).append("\n");
}

}  // namespace boresight::rotctld
