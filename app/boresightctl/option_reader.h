// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/subcommand.h"
#include "core/base/result.h"

#include <optional>
#include <string>

namespace boresight::ctl {

// Reads options and their values one after the other: "--name value", "--name=value", "--name".
class OptionReader
{
public:
    explicit OptionReader(Arguments arguments) : m_arguments(arguments) {}

    [[nodiscard]] bool atEnd() const { return m_arguments.empty(); }

    // The name of the next option without its dashes. Call takeValue() next if the option takes a value.
    [[nodiscard]] Result<std::string> takeName();
    // Empty if the next argument is an option. A negative number is a value.
    [[nodiscard]] std::optional<std::string> takeValue();

    [[nodiscard]] bool hasUnusedValue() const { return m_joined.has_value(); }

private:
    Arguments m_arguments;
    std::optional<std::string> m_joined;  // the text after "="
};

}  // namespace boresight::ctl
