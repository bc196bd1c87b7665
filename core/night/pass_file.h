// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/newest_writer.h"
#include "core/schedule/night_report.h"

#include <QObject>
#include <QString>

#include <optional>

// The file of the pass that is tracked, or was tracked last. Without it a crash would lose that part of the night
// report. It is small, because it is written many times during a pass. Read once when the program starts. Saving never
// blocks the station thread, on which this object lives. A file that cannot be read is overwritten by the next pass.
namespace boresight {

class PassFile final : public QObject
{
    Q_OBJECT

public:
    // An empty path: nothing is kept. Blocks while it reads. Moves to another thread together with its parent.
    PassFile(const QString& path, QObject* parent);

    // The pass that the previous run of the program stored.
    [[nodiscard]] const std::optional<schedule::NewestPass>& found() const { return m_found; }
    // Why the file could not be read, or could not be written the last time. Empty: no problem.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    void keep(const schedule::NewestPass& newest);

private:
    void load();

    QString m_path;
    std::optional<schedule::NewestPass> m_found;
    QString m_problem;
    NewestWriter m_writer{this};
};

}  // namespace boresight
