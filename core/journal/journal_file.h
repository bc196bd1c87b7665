// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/newest_writer.h"
#include "core/base/program_lock.h"
#include "core/base/result.h"
#include "core/journal/mount_journal.h"

#include <QObject>
#include <QString>

// The journal file of a mount, STATE_DIR/NAME.memory.json, and the generation before it in ….previous. One of the two
// is complete at every moment: a file is replaced only by renaming a complete file that is on the disk. Lives on the
// station thread. Saving never blocks it.
namespace boresight::journal {

struct LoadedJournal
{
    MountJournal journal;
    QString problem;  // a sentence for the operator; empty if the newest file was read
};

class JournalFile final : public QObject
{
    Q_OBJECT

public:
    JournalFile(const QString& stateDir, const QString& mountName, QObject* parent = nullptr);

    [[nodiscard]] const QString& path() const { return m_path; }

    // Locks this journal against other programs for the life of this object. Call it before load(). Busy: another
    // program uses it. Denied: this user lacks the permission, so a program of another user may use it. In a place
    // where nothing can be written no lock is needed.
    [[nodiscard]] Result<> claim();

    // Blocking, so call it once before the station's event loop runs. A file that cannot be read is renamed, and the
    // generation before it is used. Its records do not prove where the axes are, because the axes may have moved since.
    [[nodiscard]] LoadedJournal load();

    void save(const MountJournal& journal);

    // Waits until the newest value is on the disk and returns the result. For the end of the program, after the event
    // loop.
    Result<> flush();

Q_SIGNALS:
    void saved();
    void saveFailed(const QString& reason);

private:
    QString m_path;
    ProgramLock m_lock;
    NewestWriter m_writer{this};
};

}  // namespace boresight::journal
