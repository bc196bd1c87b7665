// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/subcommand.h"
#include "app/link_scan.h"
#include "app/scan_report.h"
#include "app/unix_signals.h"
#include "core/moteus_mount/link_factory.h"
#include "core/station/adapters.h"

#include <QCoreApplication>

namespace boresight::ctl {
namespace {

using drive_check::FoundController;

ExitStatus fail(const QString& text)
{
    complain(kScanCommand, text);
    return kFoundWrong;
}

ExitStatus report(const std::vector<FoundController>& controllers, const CanLink& link)
{
    if (const QString trouble = link.status().text; !trouble.isEmpty()) {
        complain(kScanCommand, trouble);
    }
    if (controllers.empty()) {
        return fail(app::silenceText(link.name()));
    }
    if (isSimulatedBus(link.name())) {
        printLine(app::simulatedText());
    }
    print(app::table(controllers));
    const QStringList wrong = app::problems(controllers);
    for (const QString& text : wrong) {
        complain(kScanCommand, text);
    }
    return wrong.isEmpty() ? kDone : kFoundWrong;
}

ExitStatus scan(CanLink& link)
{
    const Result<> opened = mayBeScanned(link.name()).and_then([&] { return link.open(); });
    if (!opened) {
        return fail(opened.error().text);
    }
    if (link.status().state != LinkState::Up) {
        return fail(link.status().text);
    }
    app::LinkScan scan(link);
    app::UnixSignals signals;
    ExitStatus status = kFoundWrong;
    QObject::connect(&scan, &app::LinkScan::finished, &scan, [&](const QString& problem) {
        status = problem.isEmpty() ? report(scan.controllers(), link) : fail(problem);
        QCoreApplication::quit();
    });
    QObject::connect(&signals, &app::UnixSignals::endRequested, qApp, &QCoreApplication::quit);
    QMetaObject::invokeMethod(&scan, &app::LinkScan::start, Qt::QueuedConnection);
    QCoreApplication::exec();
    return status;
}

ExitStatus runScan(Arguments arguments)
{
    if (arguments.size() != 1) {
        return usageError(kScanCommand, QStringLiteral("name one bus"));
    }
    const SystemClock clock;
    const Result<std::unique_ptr<CanLink>> link = makeLink(arguments.front(), clock);
    return link ? scan(**link) : usageError(kScanCommand, link.error().text);
}

}  // namespace

const Subcommand kScanCommand{
    .name = "scan",
    .arguments = "BUS",
    .summary = "List every moteus controller on a bus, with its faults",
    .details =
        R"(BUS is fdcanusb:PATH, socketcan:IFACE or simulated. The scan takes up to two seconds. It only reads: nothing moves, and
no watchdog is extended. On a SocketCAN bus it does not disturb a running station. It sends nothing to a USB device that is
not a known adapter. A serial port that does not answer as an adapter receives one question.

Columns: id on the bus, UUID of the board, version of firmware and register map (map), mode, fault, supply voltage,
temperature of the board, position of the output in turns of the drive, and how well this position is known. A line above
the table reports that the boards are simulated: built in, on a pseudo-terminal or on a virtual CAN interface.
Exit status: 0 all in order, 1 no board found, two boards with one id, a fault, an unknown register map or silence.

Example:
  boresightctl scan fdcanusb:/dev/boresight/fdcanusb
)",
    .run = runScan};

}  // namespace boresight::ctl
