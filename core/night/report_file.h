// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/schedule/night_report.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <memory>

// The file of the night report, STATE_DIR/NAME.night.toml: read once when the program starts, written after each pass.
// Saving never blocks the station thread, on which this lives: one worker writes, and of the reports that come in
// meanwhile the newest wins. A file that cannot be read is never written over.
namespace boresight {

class ReportFile final : public QObject
{
    Q_OBJECT

public:
    // An empty path: kept in memory only. Blocks while it reads.
    explicit ReportFile(const QString& path, QObject* parent = nullptr);
    ~ReportFile() override;  // waits until the newest report is on the disk

    [[nodiscard]] const schedule::NightReport& report() const { return m_report; }
    // Why the file could not be read, or not be written the last time. Empty while all is well.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    void keep(const schedule::NightReport& report);

Q_SIGNALS:
    void written();  // from the worker, to this object

private:
    void load();
    void startWriting();
    void finishWriting();

    QString m_path;
    schedule::NightReport m_report;
    QString m_problem;
    bool m_unreadable = false;
    std::shared_ptr<Result<>> m_outcome =
        std::make_shared<Result<>>();  // of the last writing; the worker's until it ends
    bool m_writing = false;            // finishWriting() is still to come
    bool m_again = false;              // the report has changed meanwhile
    QThreadPool m_writer;              // one thread; last, so that it ends first
};

// Of a mount. A simulated one has its own.
[[nodiscard]] QString reportPath(const QString& stateDir, const QString& mountName, bool simulated);

}  // namespace boresight
