// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/diagnostics_saver.h"

#include "ui/kit/file_dialog.h"

#include <QDir>

namespace boresight::ui {

void DiagnosticsSaver::askWhere(QWidget& owner, UtcTime now, const Gather& gather)
{
    QFileDialog* const dialog =
        askForFile(owner, tr("Save diagnostics"), QFileDialog::AcceptSave, {tr("Archive (*.tar.gz)")});
    dialog->setDirectory(QDir::home());
    dialog->selectFile(diagnostics::proposedName(now));
    connect(dialog, &QFileDialog::fileSelected, this, [this, gather](const QString& path) {
        const auto [snapshot, telemetry] = gather();
        save(path, snapshot, telemetry);
    });
}

void DiagnosticsSaver::save(const QString& path, const diagnostics::Snapshot& snapshot,
                            const TelemetryExcerpt& telemetry)
{
    const auto work = [path, snapshot, telemetry] {
        auto files = diagnostics::collect(snapshot);
        files.push_back({.file = {.name = QStringLiteral("telemetry.csv"), .bytes = toCsv(telemetry)},
                         .about = QStringLiteral("What both axes and drives did in the last 5 minutes, each 20 ms.")});
        return diagnostics::writeBundle(path, files, snapshot.when);
    };
    m_files.run(this, work, [this, path](const Result<>& written) {
        if (written) {
            Q_EMIT saved(path);
        } else {
            Q_EMIT failed(written.error().text);
        }
    });
}

}  // namespace boresight::ui

#include "moc_diagnostics_saver.cpp"
