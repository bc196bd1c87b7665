// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/local_socket/local_command.h"

#include "core/base/text.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <utility>

namespace boresight::local {
namespace {

constexpr std::array kWords{std::pair{LocalCommand::Take, "take"}, std::pair{LocalCommand::Release, "release"},
                            std::pair{LocalCommand::Stop, "stop"}, std::pair{LocalCommand::ResetStop, "reset-stop"}};
const QByteArray kAgreed = "ok";
const QByteArray kRefused = "error: ";

}  // namespace

QByteArray wordOf(LocalCommand command)
{
    return std::ranges::find(kWords, command, [](const auto& one) { return one.first; })->second;
}

Result<LocalCommand> parseCommand(const QByteArray& line)
{
    const QByteArray word = line.trimmed();
    const auto* const found = std::ranges::find_if(kWords, [&word](const auto& one) { return word == one.second; });
    if (found == kWords.end()) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("This is no command. The commands are take, release, stop and reset-stop."));
    }
    return found->first;
}

QByteArray answerLine(const Result<>& answer)
{
    return (answer ? kAgreed : kRefused + answer.error().text.simplified().toUtf8()) + '\n';
}

Result<> parseAnswer(const QByteArray& line)
{
    const QByteArray answer = line.trimmed();
    if (answer == kAgreed) {
        return {};
    }
    if (answer.startsWith(kRefused)) {
        return failure(ErrorCode::Refused, QString::fromUtf8(answer.mid(kRefused.size())));
    }
    return failure(ErrorCode::Protocol, Text::tr("The answer is neither \"ok\" nor \"error\"."));
}

QString runtimeFolder()
{
    return qEnvironmentVariable("XDG_RUNTIME_DIR");
}

QString socketPath(const QString& runtimeFolder, std::uint16_t port)
{
    return QStringLiteral("%1/boresight/%2.sock").arg(runtimeFolder).arg(port);
}

QString socketToAsk(const QString& userFolder, const QString& serviceFolder, std::uint16_t port)
{
    const QString own = userFolder.isEmpty() ? QString() : socketPath(userFolder, port);
    if (!own.isEmpty() && QFileInfo::exists(own)) {
        return own;
    }
    // Whether its socket is there only root can see.
    const QString service = socketPath(serviceFolder, port);
    return QFileInfo::exists(QFileInfo(service).path()) ? service : own;
}

}  // namespace boresight::local
