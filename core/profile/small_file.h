// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QByteArray>
#include <QString>

// Whole small files: profiles and what is imported into them. Blocking.
namespace boresight::profile {

// NoDevice: the file cannot be opened. Io: the file cannot be read, or is larger than the limit.
[[nodiscard]] Result<QByteArray> readFile(const QString& path);

enum class Readers
{
    Anybody,   // or as the file was before
    OnlyOwner  // there is a password in it
};

// All or nothing: a failure leaves the old file untouched.
[[nodiscard]] Result<> writeFile(const QString& path, const QByteArray& bytes, Readers readers = Readers::Anybody);
// Who may read an existing file, so that a copy gets the same rights.
[[nodiscard]] Readers readersOf(const QString& path);

}  // namespace boresight::profile
