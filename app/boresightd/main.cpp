// SPDX-License-Identifier: GPL-3.0-or-later
// boresightd: the station without a window. The main thread is the station thread.
#include "app/fitted_box.h"
#include "app/log_output.h"
#include "app/options.h"
#include "app/service_notify.h"
#include "app/unix_signals.h"
#include "core/base/version.h"
#include "core/local_socket/local_command.h"
#include "core/station/mount_factory.h"
#include "core/station/station.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QThreadPool>

#include <cstdio>

namespace {

using namespace boresight;

int complain(const QString& text)
{
    app::printError(QStringLiteral("boresightd: ") + text);
    return 2;
}

void announce(const QString& listening)
{
    std::printf("rotctld listening on %s\n", qPrintable(listening));
    std::fflush(stdout);
    app::notifyService("READY=1");
}

Result<app::Options> readOptions()
{
    return app::readOptions(QCoreApplication::arguments(),
                            QStringLiteral("Boresight without a window: rotctld server for an antenna mount."))
        .map_error([](const app::NoStart& problem) { return problem.error; });
}

// Without --profile, the window may have made another mount the current one since the start.
Result<profile::Profile> readAgain(const app::Options& started)
{
    return readOptions().and_then([&](const app::Options& now) -> Result<profile::Profile> {
        if (!started.isFirstStart() && QFileInfo(now.profilePath) != QFileInfo(started.profilePath)) {
            return failure(
                ErrorCode::Refused,
                QStringLiteral("boresightd runs with %1. The current mount is another one: restart boresightd")
                    .arg(started.profilePath));
        }
        return now.profile;
    });
}

// Reads the file on another thread: a slow disk must not keep the drives waiting. `started` must outlive the reader.
void reload(Station& station, const app::Options& started, QThreadPool& reader)
{
    app::notifyService("RELOADING=1");
    reader.start([&station, &started] {
        const auto read = readAgain(started);
        const auto take = [&station, read] {
            station.reload(read);
            app::notifyService("READY=1");
        };
        QMetaObject::invokeMethod(&station, take, Qt::QueuedConnection);
    });
}

// A simulated control box needs a travel of its own.
app::Options fitted(app::Options options)
{
    options.profile = app::fittedToBox(options.simulation, options.profile);
    return options;
}

int run(QCoreApplication& application, const app::Options& options)
{
    const SystemClock clock;
    const MountFactory mounts(options.profile, clock);
    const Simulation simulation = options.simulationFor(options.profile);
    Station station(options.profile, mounts.make(options.profile, {options.stateDir, simulation, options.standingAt}),
                    options.stateDir, clock);
    station.setSensorMaker(mounts.sensors(options.profile, simulation));
    station.setFaults(mounts.faults(options.profile, simulation));
    station.serveShell(local::runtimeFolder());
    station.wantRealTime();
    QThreadPool reader;
    app::ServiceWatchdog watchdog;
    QObject::connect(&station, &Station::ticked, &application, [&watchdog, &clock] { watchdog.feed(clock.now()); });
    app::UnixSignals signals(app::HangUp::Reloads);
    QObject::connect(&signals, &app::UnixSignals::reloadRequested, &station, [&] { reload(station, options, reader); });
    QObject::connect(&station, &Station::started, &application, [&](const QString& listening, const QString& problem) {
        if (listening.isEmpty()) {
            application.exit(complain(problem));
        } else {
            announce(listening);
        }
    });
    QObject::connect(&signals, &app::UnixSignals::endRequested, &station, [&] {
        app::notifyService("STOPPING=1");
        station.shutDown();
    });
    QObject::connect(&station, &Station::finished, &application, &QCoreApplication::quit);
    QMetaObject::invokeMethod(&station, &Station::start, Qt::QueuedConnection);
    return application.exec();
}

}  // namespace

int main(int argc, char** argv)
{
    app::logToStandardError();
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("boresightd"));
    QCoreApplication::setApplicationVersion(QString::fromUtf8(kVersion.data(), kVersion.size()));
    const auto options = readOptions();
    return options ? run(application, fitted(*options)) : complain(options.error().text);
}
