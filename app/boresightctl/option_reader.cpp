// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/option_reader.h"

#include "core/base/text.h"

#include <utility>

namespace boresight::ctl {

Result<std::string> OptionReader::takeName()
{
    const std::string argument = m_arguments.front();
    m_arguments = m_arguments.subspan(1);
    m_joined.reset();
    if (!argument.starts_with("--")) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("\"%1\" is not an option. Options begin with --").arg(toQString(argument)));
    }
    const std::size_t equals = argument.find('=');
    if (equals != std::string::npos) {
        m_joined = argument.substr(equals + 1);
    }
    return argument.substr(2, equals - 2);
}

std::optional<std::string> OptionReader::takeValue()
{
    if (m_joined) {
        return std::exchange(m_joined, std::nullopt);
    }
    if (atEnd() || m_arguments.front().starts_with("--")) {
        return std::nullopt;
    }
    const std::string value = m_arguments.front();
    m_arguments = m_arguments.subspan(1);
    return value;
}

}  // namespace boresight::ctl
