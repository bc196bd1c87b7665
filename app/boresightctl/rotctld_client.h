// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"
#include "core/units/sky.h"

#include <QDeadlineTimer>
#include <QJsonObject>
#include <QTcpSocket>

#include <chrono>

// Asks a station as a client of its rotctld server, one question after the other. All answers together take at most
// kPatience. It blocks, so it is for programs that do nothing else meanwhile. Error codes: Refused, or NoAnswer if
// nobody answers.
namespace boresight::ctl {

inline constexpr std::chrono::seconds kPatience{2};

class RotctldClient
{
public:
    [[nodiscard]] Result<> connect(const profile::ListenAddress& station);

    // On success: where the mount goes instead of this direction, as the station words it. Empty: it goes there, or the
    // server does not report it.
    [[nodiscard]] Result<QString> pointTo(const SkyPointing& direction);
    [[nodiscard]] Result<> park();
    // Ends the motion. The protocol has no STOP that latches.
    [[nodiscard]] Result<> hold();
    // The keys of station_report.h that the protocol can report.
    [[nodiscard]] Result<QJsonObject> status();

private:
    [[nodiscard]] Result<QByteArray> ask(const QByteArray& command);
    [[nodiscard]] Result<QString> order(const QByteArray& command);
    [[nodiscard]] QString outcome();

    QTcpSocket m_socket;
    QDeadlineTimer m_deadline{kPatience};
    QString m_name;  // "127.0.0.1:4533"
};

}  // namespace boresight::ctl
