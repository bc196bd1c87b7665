// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/pointing/antenna.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <vector>

// The commands that a program of the same user may send to a running station through its local socket: one line to the
// station, and back "ok" with the lines of the answer, or "error: REASON". Both ends use this file. Only `track` and
// `schedule-arm` lead to motions, and `antenna` while a target is tracked. Pure, any thread.
namespace boresight::local {

enum class LocalCommand
{
    Take,
    Release,
    Stop,
    ResetStop,
    OverrideWind,
    UseNewTime,
    Track,
    Satellites,
    Antennas,
    UseAntenna,
    ScheduleList,  // the plan, as JSON
    ScheduleArm,
    ScheduleDisarm,
    ScheduleReport,     // of the passes so far, as JSON
    ScheduleRehearse,   // begins the rehearsal
    ScheduleRehearsal,  // its progress or its result, as JSON
    Status,             // what the station is doing, as JSON
    Transmit,           // whether the transmitter may transmit, as JSON
    Simulate,           // shows a fault on a simulated mount
    TypeLine,           // to the control box of the mount, as it is
    ConsoleLines,       // the typed lines and the answers of the control box, as JSON
    ProtocolLogOn,      // begins the protocol log
    ProtocolLogOff,     // ends it; its lines stay
    ProtocolLines       // the lines of the protocol log after a number, some at a time
};

struct LocalRequest
{
    LocalCommand command = LocalCommand::Stop;
    // The target of Track, the name of UseAntenna, the fault of Simulate, the line of TypeLine, or the number for
    // ProtocolLines, as typed: UTF-8 without LF.
    QByteArray target = {};

    bool operator==(const LocalRequest&) const = default;
};

// The lines after "ok", each with its LF: the name of the tracked target, the satellites, the antennas, or the report
// about the station, the schedule or the transmit output, or the fault that begins, or lines of the protocol log. Empty
// for other commands.
using LocalAnswer = Result<QByteArray>;

// The longest line of a command, without its LF. A path has up to 4096 bytes.
inline constexpr qsizetype kLongestLine = 4352;

// For example "reset-stop".
[[nodiscard]] QByteArray wordOf(LocalCommand command);
// The bytes to send, with the LF.
[[nodiscard]] QByteArray requestLine(const LocalRequest& request);
// `line` has no LF.
[[nodiscard]] Result<LocalRequest> parseRequest(const QByteArray& line);

// The whole text of the answer.
[[nodiscard]] QByteArray answerText(const LocalAnswer& answer);
// Errors: Refused with the reason of the station, or Protocol if the answer is unreadable.
[[nodiscard]] LocalAnswer parseAnswer(const QByteArray& text);

// A satellite that the station knows. Its line in the answer has number, epoch and name, separated by tabs.
struct KnownSatellite
{
    std::int64_t number = 0;
    UtcTime epoch{};
    QString name;  // may be empty

    bool operator==(const KnownSatellite&) const = default;
};
[[nodiscard]] QByteArray satelliteLine(const KnownSatellite& satellite);
// Error: Protocol, if a line has another form.
[[nodiscard]] Result<std::vector<KnownSatellite>> parseSatellites(const QByteArray& lines);

// An antenna of the mount. Its line in the answer has "1" if the antenna is in use or else "0", the beam width and the
// offsets across and up in degrees, and the name, separated by tabs.
struct KnownAntenna
{
    pointing::Antenna antenna;
    bool isInUse = false;

    bool operator==(const KnownAntenna&) const = default;
};
[[nodiscard]] QByteArray antennaLine(const KnownAntenna& antenna);
// Error: Protocol, if a line has another form.
[[nodiscard]] Result<std::vector<KnownAntenna>> parseAntennas(const QByteArray& lines);

// $XDG_RUNTIME_DIR. Empty if the system has none for this user.
[[nodiscard]] QString runtimeFolder();
// The folder above that of the system service (packaging/systemd). Only root may use its socket.
inline const QString kServiceRuntimeFolder = QStringLiteral("/run");
// For example "/run/user/1000/boresight/4533.sock" for "/run/user/1000" and the port of the station's rotctld server.
[[nodiscard]] QString socketPath(const QString& runtimeFolder, std::uint16_t port);
// The socket to use: that of a station of this user if it exists. Otherwise that of the service if it runs. Otherwise
// the one that a station of this user would have. Empty: there is no runtime folder.
[[nodiscard]] QString socketToAsk(const QString& userFolder, const QString& serviceFolder, std::uint16_t port);

}  // namespace boresight::local
