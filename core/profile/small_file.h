// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QByteArray>
#include <QString>

// Reads and writes whole small files: profiles and the files that are imported into them. Blocking.
namespace boresight::profile {

// NoDevice: the file cannot be opened. Io: the file cannot be read, or is larger than the limit.
[[nodiscard]] Result<QByteArray> readFile(const QString& path);

enum class Readers
{
    Anybody,   // the rights of an existing file stay as they are
    OnlyOwner  // the file contains a password
};

// All or nothing: a failure leaves the old file untouched.
[[nodiscard]] Result<> writeFile(const QString& path, const QByteArray& bytes, Readers readers = Readers::Anybody);
// The readers of an existing file. A copy of the file is written with the same rights.
[[nodiscard]] Readers readersOf(const QString& path);

}  // namespace boresight::profile
