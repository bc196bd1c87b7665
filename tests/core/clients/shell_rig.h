// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/clients/protocol_log.h"
#include "core/clients/station_shell.h"
#include "core/elements/julian_date.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/wait_until.h"

#include <QLocalSocket>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace boresight {

// Sends a line to the local socket, and returns the whole answer.
inline std::string askShell(const QString& path, const QByteArray& line)
{
    QLocalSocket socket;
    socket.connectToServer(path);
    socket.write(line);
    EXPECT_TRUE(fakes::waitUntil([&socket] { return socket.state() == QLocalSocket::UnconnectedState; }));
    return socket.readAll().toStdString();
}

// A mount that may move, and the shell that controls it.
struct ShellRig : StationRig
{
    ShellRig()
    {
        run(Seconds(0.5));
        control.clientCame(kClient, "10.0.0.7");
        shell.setRuntimeFolder(runtime.path());
        shell.open(kPort);
    }

    std::string answerTo(const QByteArray& line) { return askShell(local::socketPath(runtime.path(), kPort), line); }

    static std::vector<local::KnownAntenna> antennas()
    {
        return {{.antenna = {}, .isInUse = true}, {.antenna = {.name = "70 cm", .beamWidth = 20_deg, .up = 3_deg}}};
    }

    static constexpr std::uint16_t kPort = 4533;
    QTemporaryDir runtime;
    QString asked;  // the name of a file or a rotctld
    StationTables::Then answer;
    StationFollow::Then found;
    TransmitStatus transmit;
    ProtocolLog protocol{clock};
    ClockStatus watched;
    std::optional<TrackedTarget> tracked;
    std::optional<budget::ErrorBudget> errorBudget;
    std::vector<Alarm> alarms;
    std::optional<QStringList> console;
    std::optional<ThirdAxisStatus> third;
    std::shared_ptr<const std::vector<orbit::ElementSet>> known =
        std::make_shared<const std::vector<orbit::ElementSet>>(std::vector<orbit::ElementSet>{
            {.name = "ISS (ZARYA)", .number = 25544, .epoch = orbit::julianDate(UtcTime(std::chrono::days(20000)))}});
    StationShell shell{
        {.ask = [this](const Request& request, const Source& by) { return ask(request, by); },
         .mayShellCommand = [this] { return control.mayShellCommand(); },
         .readTable =
             [this](const QString& path, StationTables::Then then) {
                 asked = path;
                 answer = std::move(then);
             },
         .findRotator =
             [this](const QString& name, StationFollow::Then then) {
                 asked = name;
                 found = std::move(then);
             },
         .satellites = [this] { return known; },
         .antennas = [] { return antennas(); },
         .status =
             [this] {
                 StationStatus status = control.status();
                 status.clock = watched;
                 status.tracked = tracked ? tracked : status.tracked;
                 status.errorBudget = errorBudget;
                 status.alarms = alarms;
                 status.console = console;
                 status.thirdAxis = third;
                 return status;
             },
         .transmit = [this] { return transmit; },
         .protocolLines = [this](std::uint64_t after, std::size_t limit) { return protocol.oldest(after, limit); }},
        log,
        clock,
        nullptr};
};

}  // namespace boresight
