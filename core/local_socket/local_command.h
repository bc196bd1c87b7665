// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QByteArray>
#include <QString>

#include <cstdint>

// What a program of the same user may ask of a running station by its local socket: one line to the station, one line
// back, "ok" or "error: REASON". Both ends use this. None of the commands starts a motion. Pure, any thread.
namespace boresight::local {

enum class LocalCommand
{
    Take,
    Release,
    Stop,
    ResetStop
};

// Of a command, without its LF.
inline constexpr qsizetype kLongestLine = 256;

// "reset-stop"
[[nodiscard]] QByteArray wordOf(LocalCommand command);
// `line` is without its LF.
[[nodiscard]] Result<LocalCommand> parseCommand(const QByteArray& line);

// With its LF.
[[nodiscard]] QByteArray answerLine(const Result<>& answer);
// Refused, with the reason of the station, or Protocol.
[[nodiscard]] Result<> parseAnswer(const QByteArray& line);

// $XDG_RUNTIME_DIR; empty where the system has none for this user.
[[nodiscard]] QString runtimeFolder();
// Of the service of the system (packaging/systemd), whose socket root may ask.
inline const QString kServiceRuntimeFolder = QStringLiteral("/run");
// "/run/user/1000/boresight/4533.sock" of "/run/user/1000" and the port of the station's rotctld server.
[[nodiscard]] QString socketPath(const QString& runtimeFolder, std::uint16_t port);
// Where to ask: at the socket of a station of this user, else at that of the service where one runs, else at the socket
// that a station of this user would have. Empty: there is no folder for any.
[[nodiscard]] QString socketToAsk(const QString& userFolder, const QString& serviceFolder, std::uint16_t port);

}  // namespace boresight::local
