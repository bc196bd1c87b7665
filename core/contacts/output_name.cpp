// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contacts/output_name.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"

#include <QProcess>

#include <algorithm>
#include <array>
#include <utility>

namespace boresight::contacts {
namespace {

constexpr std::size_t kLongest = 1000;  // bytes

constexpr std::array kKinds{std::pair{"file:", OutputKind::File}, std::pair{"mqtt:", OutputKind::Mqtt},
                            std::pair{"command:", OutputKind::Command}, std::pair{"dtr:", OutputKind::Dtr},
                            std::pair{"rts:", OutputKind::Rts}};

Result<OutputName> atPath(OutputKind kind, const QString& path)
{
    return path.startsWith(QLatin1Char('/')) && !path.endsWith(QLatin1Char('/'))
               ? Result<OutputName>(OutputName{.kind = kind, .place = path})
               : failure(ErrorCode::InvalidInput, Text::tr("a path from / on is expected after the colon"));
}

// MQTT reserves topics that begin with '$' for the broker. '+' and '#' are wildcards, which only subscribers may use.
Result<OutputName> onTopic(const QString& topic)
{
    const bool isTopic = !topic.isEmpty() && !topic.startsWith(QLatin1Char('$')) && !topic.contains(QLatin1Char('+')) &&
                         !topic.contains(QLatin1Char('#'));
    return isTopic
               ? Result<OutputName>(OutputName{.kind = OutputKind::Mqtt, .place = topic})
               : failure(ErrorCode::InvalidInput, Text::tr("a topic is expected after the colon, without + # and $"));
}

// The program is started without a shell and without a search in PATH, so its full path is required.
Result<OutputName> byProgram(const QString& line)
{
    QStringList words = QProcess::splitCommand(line);
    if (words.isEmpty() || !words.first().startsWith(QLatin1Char('/'))) {
        return failure(ErrorCode::InvalidInput, Text::tr("the path of a program from / on is expected first"));
    }
    const QString program = words.takeFirst();
    return OutputName{.kind = OutputKind::Command, .place = program, .arguments = words};
}

}  // namespace

Result<OutputName> parseOutput(const std::string& text)
{
    if (text.empty()) {
        return OutputName{};
    }
    if (text.size() > kLongest || hasControlCharacters(text)) {
        return failure(ErrorCode::InvalidInput, Text::tr("one line of at most 1000 bytes is expected"));
    }
    const auto* const found =
        std::ranges::find_if(kKinds, [&](const auto& one) { return text.starts_with(one.first); });
    if (found == kKinds.end()) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("file:PATH, mqtt:TOPIC, command:PROGRAM, dtr:PORT or rts:PORT is expected"));
    }
    const QString place = toQString(std::string_view(text).substr(std::string_view(found->first).size()));
    switch (found->second) {
        case OutputKind::Mqtt:
            return onTopic(place);
        case OutputKind::Command:
            return byProgram(place);
        default:
            return atPath(found->second, place);
    }
}

}  // namespace boresight::contacts
