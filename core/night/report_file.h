// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/newest_writer.h"
#include "core/night/pass_file.h"
#include "core/schedule/night_report.h"

#include <QObject>
#include <QString>

#include <optional>

// The file of the night report, STATE_DIR/NAME.night.toml: read once when the program starts, written after each pass.
// Saving never blocks the station thread, on which this object lives. The destructor waits until the newest report is
// on the disk. A file that cannot be read is never overwritten. Beside it is the file of the present pass (PassFile),
// NAME.night.toml.pass.
namespace boresight {

class ReportFile final : public QObject
{
    Q_OBJECT

public:
    // An empty path: kept in memory only. Blocks while it reads.
    explicit ReportFile(const QString& path, QObject* parent = nullptr);

    [[nodiscard]] const schedule::NightReport& report() const { return m_report; }
    // Why the file could not be read, or could not be written the last time. Empty: no problem.
    [[nodiscard]] const QString& problem() const { return m_problem.isEmpty() ? m_pass.problem() : m_problem; }
    void keep(const schedule::NightReport& report);

    // Stores the pass that is being tracked. Its end is stored before the report that contains the pass.
    void keepPass(const schedule::PassRecord& pass);
    // A stored pass that the report does not contain, because the program was killed or the power failed.
    [[nodiscard]] std::optional<schedule::PassRecord> lostPass() const;

private:
    void load();

    QString m_path;
    schedule::NightReport m_report;
    QString m_problem;
    bool m_unreadable = false;
    PassFile m_pass;
    NewestWriter m_writer{this};
};

// The path for a mount. A simulated mount has its own file.
[[nodiscard]] QString reportPath(const QString& stateDir, const QString& mountName, bool simulated);

}  // namespace boresight
