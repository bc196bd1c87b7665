// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/result.h"

#include <QString>

// Keeps what a program uses from other programs of any user. The kernel holds the lock and ends it with the program,
// however the program ends. Any thread.
namespace boresight {

class ProgramLock
{
public:
    ProgramLock() = default;

    // Makes the file if it is not there and leaves it there afterwards: it holds nothing but the name of the program.
    // Busy: another program has the lock, and the text is its name, as "boresightd (process 1234)". Denied: this user
    // may not. Io: there can be no lock in this place.
    [[nodiscard]] static Result<ProgramLock> take(const QString& path);

private:
    explicit ProgramLock(FileDescriptor file) : m_file(std::move(file)) {}

    FileDescriptor m_file;
};

// Locks an open file or device until it is closed. Busy: another one has locked it; the text is its name.
[[nodiscard]] Result<> lockDescriptor(int descriptor);

}  // namespace boresight
