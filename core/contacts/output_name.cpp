// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contacts/output_name.h"

#include "core/base/text.h"
#include "core/contacts/place_text.h"

#include <QProcess>

#include <algorithm>
#include <array>
#include <utility>

namespace boresight::contacts {
namespace {

constexpr std::array kKinds{std::pair{"file:", OutputKind::File},       std::pair{"mqtt:", OutputKind::Mqtt},
                            std::pair{"command:", OutputKind::Command}, std::pair{"dtr:", OutputKind::Dtr},
                            std::pair{"rts:", OutputKind::Rts},         std::pair{"moteus:", OutputKind::Pin}};

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
    if (const Result<> line = checkLine(text); !line) {
        return tl::unexpected(line.error());
    }
    const auto* const found =
        std::ranges::find_if(kKinds, [&](const auto& one) { return text.starts_with(one.first); });
    if (found == kKinds.end()) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("file:PATH, mqtt:TOPIC, command:PROGRAM, dtr:PORT, rts:PORT or moteus:ID:aux1.PIN is expected"));
    }
    const QString place = toQString(std::string_view(text).substr(std::string_view(found->first).size()));
    const OutputKind kind = found->second;
    if (kind == OutputKind::Command) {
        return byProgram(place);
    }
    if (kind == OutputKind::Pin) {
        return parsePin(place.toStdString()).map([kind](const BoardPin& pin) {
            return OutputName{.kind = kind, .pin = pin};
        });
    }
    return (kind == OutputKind::Mqtt ? checkedTopic(place) : checkedPath(place)).map([kind](const QString& checked) {
        return OutputName{.kind = kind, .place = checked};
    });
}

}  // namespace boresight::contacts
