// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld/command_parser.h"

#include <string_view>

// Guesses the program of a client. Clients do not send their name, so the way they write commands decides. Only for the
// screen and the log. No behaviour depends on it. Pure.
namespace boresight::rotctld {

class ClientProgram
{
public:
    void observe(const Command& command);
    [[nodiscard]] std::string_view name() const { return m_name; }  // empty while unknown

private:
    [[nodiscard]] std::string_view byPointing(const Command& command) const;

    std::string_view m_name;
    bool m_askedPosition = false;
};

}  // namespace boresight::rotctld
