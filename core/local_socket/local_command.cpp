// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/local_socket/local_command.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <QFileInfo>
#include <QList>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>

namespace boresight::local {
namespace {

constexpr std::array kWords{std::pair{LocalCommand::Take, "take"},
                            std::pair{LocalCommand::Release, "release"},
                            std::pair{LocalCommand::Stop, "stop"},
                            std::pair{LocalCommand::ResetStop, "reset-stop"},
                            std::pair{LocalCommand::OverrideWind, "override-wind"},
                            std::pair{LocalCommand::UseNewTime, "use-new-time"},
                            std::pair{LocalCommand::Satellites, "satellites"},
                            std::pair{LocalCommand::Antennas, "antennas"},
                            std::pair{LocalCommand::UseAntenna, "antenna"},
                            std::pair{LocalCommand::ScheduleList, "schedule-list"},
                            std::pair{LocalCommand::ScheduleArm, "schedule-arm"},
                            std::pair{LocalCommand::ScheduleDisarm, "schedule-disarm"},
                            std::pair{LocalCommand::ScheduleReport, "schedule-report"},
                            std::pair{LocalCommand::ScheduleRehearse, "schedule-rehearse"},
                            std::pair{LocalCommand::ScheduleRehearsal, "schedule-rehearsal"},
                            std::pair{LocalCommand::Status, "status"},
                            std::pair{LocalCommand::Transmit, "transmit"},
                            std::pair{LocalCommand::Simulate, "simulate"},
                            std::pair{LocalCommand::TypeLine, "console"},
                            std::pair{LocalCommand::ConsoleLines, "console-lines"},
                            std::pair{LocalCommand::ProtocolLogOn, "protocol-log-on"},
                            std::pair{LocalCommand::ProtocolLogOff, "protocol-log-off"},
                            std::pair{LocalCommand::ProtocolLines, "protocol-lines"},
                            std::pair{LocalCommand::Track, "track"}};
constexpr int kDecimals = 6;  // of a degree, as in the profile
const QByteArray kAgreed = "ok\n";
const QByteArray kRefused = "error: ";

bool takesTarget(LocalCommand command)
{
    return command == LocalCommand::Track || command == LocalCommand::UseAntenna || command == LocalCommand::Simulate ||
           command == LocalCommand::TypeLine || command == LocalCommand::ProtocolLines;
}

std::optional<KnownAntenna> antennaOf(const QByteArray& line)
{
    const QList<QByteArray> fields = line.split('\t');
    if (fields.size() != 5) {
        return std::nullopt;
    }
    const auto width = parseFinite(fields[1].toStdString());
    const auto across = parseFinite(fields[2].toStdString());
    const auto up = parseFinite(fields[3].toStdString());
    if (!width || !across || !up || (fields[0] != "0" && fields[0] != "1")) {
        return std::nullopt;
    }
    return KnownAntenna{.antenna = {.name = fields[4].toStdString(),
                                    .beamWidth = Angle::fromDegrees(*width),
                                    .across = Angle::fromDegrees(*across),
                                    .up = Angle::fromDegrees(*up)},
                        .isInUse = fields[0] == "1"};
}

// `read` returns the value of one line. Empty: the line has another form.
template <class Value, class Read>
Result<std::vector<Value>> parseLines(const QByteArray& lines, Read read, const QString& problem)
{
    std::vector<Value> values;
    for (qsizetype from = 0; from < lines.size();) {
        const qsizetype end = lines.indexOf('\n', from);
        const std::optional<Value> value = read(lines.mid(from, end - from));
        if (end < 0 || !value) {
            return failure(ErrorCode::Protocol, problem);
        }
        values.push_back(*value);
        from = end + 1;
    }
    return values;
}

std::optional<KnownSatellite> satelliteOf(const QByteArray& line)
{
    const QList<QByteArray> fields = line.split('\t');
    if (fields.size() != 3) {
        return std::nullopt;
    }
    const auto number = parseInteger(fields[0].toStdString());
    const auto milliseconds = parseInteger(fields[1].toStdString());
    if (!number || !milliseconds) {
        return std::nullopt;
    }
    return KnownSatellite{.number = *number,
                          .epoch = UtcTime(std::chrono::milliseconds(*milliseconds)),
                          .name = QString::fromUtf8(fields[2])};
}

}  // namespace

QByteArray wordOf(LocalCommand command)
{
    return std::ranges::find(kWords, command, [](const auto& one) { return one.first; })->second;
}

QByteArray requestLine(const LocalRequest& request)
{
    return wordOf(request.command) + (request.target.isEmpty() ? QByteArray() : ' ' + request.target) + '\n';
}

Result<LocalRequest> parseRequest(const QByteArray& line)
{
    const QByteArray text = line.trimmed();
    const QByteArray word = text.split(' ').constFirst();
    const auto* const found = std::ranges::find_if(kWords, [&word](const auto& one) { return word == one.second; });
    const bool hasTarget = found != kWords.end() && takesTarget(found->first);
    if (found == kWords.end() || hasTarget == (word == text)) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("This is not a command. The commands are take, release, stop, reset-stop, override-wind, "
                     "use-new-time, satellites, status, transmit, track TARGET, antennas, antenna NAME, "
                     "simulate FAULT, console LINE, console-lines, protocol-log-on, protocol-log-off, "
                     "protocol-lines NUMBER and the commands of the schedule."));
    }
    return LocalRequest{.command = found->first, .target = hasTarget ? text.mid(word.size()).trimmed() : QByteArray()};
}

QByteArray answerText(const LocalAnswer& answer)
{
    return answer ? kAgreed + *answer : kRefused + answer.error().text.simplified().toUtf8() + '\n';
}

LocalAnswer parseAnswer(const QByteArray& text)
{
    if (text.startsWith(kAgreed)) {
        return text.mid(kAgreed.size());
    }
    if (text.startsWith(kRefused)) {
        return failure(ErrorCode::Refused, QString::fromUtf8(text.mid(kRefused.size()).trimmed()));
    }
    return failure(ErrorCode::Protocol, Text::tr("The answer is neither \"ok\" nor \"error\"."));
}

QByteArray satelliteLine(const KnownSatellite& satellite)
{
    const auto epoch = std::chrono::round<std::chrono::milliseconds>(satellite.epoch).time_since_epoch();
    return QByteArray::number(satellite.number) + '\t' + QByteArray::number(qint64{epoch.count()}) + '\t' +
           satellite.name.simplified().toUtf8() + '\n';
}

Result<std::vector<KnownSatellite>> parseSatellites(const QByteArray& lines)
{
    return parseLines<KnownSatellite>(lines, satelliteOf, Text::tr("The list of satellites is not complete."));
}

QByteArray antennaLine(const KnownAntenna& antenna)
{
    const auto number = [](Angle angle) { return QByteArray::fromStdString(formatFixed(angle.degrees(), kDecimals)); };
    const pointing::Antenna& one = antenna.antenna;
    return QByteArray(antenna.isInUse ? "1" : "0") + '\t' + number(one.beamWidth) + '\t' + number(one.across) + '\t' +
           number(one.up) + '\t' + toQString(one.name).simplified().toUtf8() + '\n';
}

Result<std::vector<KnownAntenna>> parseAntennas(const QByteArray& lines)
{
    return parseLines<KnownAntenna>(lines, antennaOf, Text::tr("The list of antennas is not complete."));
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
    // Only root can see the socket itself, so the folder is checked.
    const QString service = socketPath(serviceFolder, port);
    return QFileInfo::exists(QFileInfo(service).path()) ? service : own;
}

}  // namespace boresight::local
