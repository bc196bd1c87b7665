// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/result.h"

#include <QString>

// Locks something against use by other programs of any user. The kernel holds the lock and releases it when the program
// ends in any way. Any thread.
namespace boresight {

class ProgramLock
{
public:
    ProgramLock() = default;

    // Creates the file if it is missing and leaves it afterwards. The file contains only the name of the program. Busy:
    // another program has the lock, and the text is its name, for example "boresightd (process 1234)". Denied: this
    // user lacks the permission. Io: no lock is possible in this place.
    [[nodiscard]] static Result<ProgramLock> take(const QString& path);

private:
    explicit ProgramLock(FileDescriptor file) : m_file(std::move(file)) {}

    FileDescriptor m_file;
};

// Locks an open file or device until it is closed. Busy: another program has locked it, and the text is its name.
[[nodiscard]] Result<> lockDescriptor(int descriptor);

}  // namespace boresight
