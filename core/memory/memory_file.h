// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/newest_writer.h"
#include "core/base/program_lock.h"
#include "core/base/result.h"
#include "core/memory/mount_memory.h"

#include <QObject>
#include <QString>

// The file that keeps a mount's memory: STATE_DIR/NAME.memory.json, and the generation before it in ….previous. At
// every moment one of the two is whole: each is replaced by renaming a file that is complete and on the disk. Lives on
// the station thread. Saving never blocks it.
namespace boresight::memory {

struct LoadedMemory
{
    MountMemory memory;
    QString problem;  // a sentence for the operator; empty when the newest file was read
};

class MemoryFile final : public QObject
{
    Q_OBJECT

public:
    MemoryFile(const QString& stateDir, const QString& mountName, QObject* parent = nullptr);

    [[nodiscard]] const QString& path() const { return m_path; }

    // Keeps other programs from this journal until the end of this object. Before load(). Busy: another program uses
    // it. Denied: another user's program may. A place where nothing can be written needs no lock.
    [[nodiscard]] Result<> claim();

    // Blocks: once, before the station's loop runs. A file that cannot be read is kept under another name, and the
    // generation before it is taken; what that one says of an axis counts as written while moving, because the axis may
    // have moved since.
    [[nodiscard]] LoadedMemory load();

    void save(const MountMemory& memory);

    // Waits until the newest value is on the disk: at the end of the program, after the loop. Tells how that went.
    Result<> flush();

Q_SIGNALS:
    void saved();
    void saveFailed(const QString& reason);

private:
    QString m_path;
    ProgramLock m_lock;
    NewestWriter m_writer{this};
};

}  // namespace boresight::memory
