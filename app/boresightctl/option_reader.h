// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/subcommand.h"
#include "core/base/result.h"

#include <optional>
#include <string>

namespace boresight::ctl {

// Options and their values one after the other: "--name value", "--name=value", "--name".
class OptionReader
{
public:
    explicit OptionReader(Arguments arguments) : m_arguments(arguments) {}

    [[nodiscard]] bool atEnd() const { return m_arguments.empty(); }

    // The option without its dashes; what it may take as a value is then waiting.
    [[nodiscard]] Result<std::string> takeName();
    // Nothing if the next argument is an option itself. A negative number is a value.
    [[nodiscard]] std::optional<std::string> takeValue();

    [[nodiscard]] bool hasUnusedValue() const { return m_joined.has_value(); }

private:
    Arguments m_arguments;
    std::optional<std::string> m_joined;  // behind "="
};

}  // namespace boresight::ctl
