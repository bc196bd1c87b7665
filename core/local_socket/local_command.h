// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/pointing/antenna.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <vector>

// What a program of the same user may ask of a running station by its local socket: one line to the station, and back
// "ok" with the lines of the answer, or "error: REASON". Both ends use this. Of the commands only `track`,
// `schedule-arm`, and `antenna` while something is tracked, lead to motions. Pure, any thread.
namespace boresight::local {

enum class LocalCommand
{
    Take,
    Release,
    Stop,
    ResetStop,
    OverrideWind,
    Track,
    Satellites,
    Antennas,
    UseAntenna,
    ScheduleList,  // the plan, as JSON
    ScheduleArm,
    ScheduleDisarm,
    ScheduleReport,     // of the passes so far, as JSON
    ScheduleRehearse,   // begin
    ScheduleRehearsal,  // how far it is, or what came of it, as JSON
    Status,             // what the station does, as JSON
    Transmit            // whether the transmitter may transmit, as JSON
};

struct LocalRequest
{
    LocalCommand command = LocalCommand::Stop;
    QByteArray target = {};  // of Track and the name of UseAntenna, as typed: UTF-8 without LF

    bool operator==(const LocalRequest&) const = default;
};

// The lines that follow "ok", each with its LF: the name of the target that is tracked, the satellites, the antennas,
// or what is told of the station, the schedule or the transmit output. Else empty.
using LocalAnswer = Result<QByteArray>;

// Of a command, without its LF: a path has up to 4096 bytes.
inline constexpr qsizetype kLongestLine = 4352;

// "reset-stop"
[[nodiscard]] QByteArray wordOf(LocalCommand command);
// What is sent, with its LF.
[[nodiscard]] QByteArray requestLine(const LocalRequest& request);
// `line` is without its LF.
[[nodiscard]] Result<LocalRequest> parseRequest(const QByteArray& line);

// All that is sent back.
[[nodiscard]] QByteArray answerText(const LocalAnswer& answer);
// Refused, with the reason of the station, or Protocol.
[[nodiscard]] LocalAnswer parseAnswer(const QByteArray& text);

// A satellite that the station knows, as a line of the answer: number, epoch and name with a tab between.
struct KnownSatellite
{
    std::int64_t number = 0;
    UtcTime epoch{};
    QString name;  // may be empty

    bool operator==(const KnownSatellite&) const = default;
};
[[nodiscard]] QByteArray satelliteLine(const KnownSatellite& satellite);
// Protocol, if a line is no such line.
[[nodiscard]] Result<std::vector<KnownSatellite>> parseSatellites(const QByteArray& lines);

// An antenna of the mount, as a line of the answer: "1" if it is in use else "0", beam width, offsets across and up in
// degrees, and the name, with a tab between.
struct KnownAntenna
{
    pointing::Antenna antenna;
    bool isInUse = false;

    bool operator==(const KnownAntenna&) const = default;
};
[[nodiscard]] QByteArray antennaLine(const KnownAntenna& antenna);
// Protocol, if a line is no such line.
[[nodiscard]] Result<std::vector<KnownAntenna>> parseAntennas(const QByteArray& lines);

// $XDG_RUNTIME_DIR; empty where the system has none for this user.
[[nodiscard]] QString runtimeFolder();
// The socket of the system service (packaging/systemd). Root may use it.
inline const QString kServiceRuntimeFolder = QStringLiteral("/run");
// "/run/user/1000/boresight/4533.sock" of "/run/user/1000" and the port of the station's rotctld server.
[[nodiscard]] QString socketPath(const QString& runtimeFolder, std::uint16_t port);
// Where to ask: at the socket of a station of this user, else at that of the service where one runs, else at the socket
// that a station of this user would have. Empty: there is no folder for any.
[[nodiscard]] QString socketToAsk(const QString& userFolder, const QString& serviceFolder, std::uint16_t port);

}  // namespace boresight::local
