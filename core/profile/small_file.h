// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QByteArray>
#include <QString>

// Whole small files: profiles and what is imported into them. Blocking.
namespace boresight::profile {

// NoDevice: it cannot be opened. Io: it is broken, or larger than anything that is read here.
[[nodiscard]] Result<QByteArray> readFile(const QString& path);

enum class Readers
{
    Anybody,   // or as the file was before
    OnlyOwner  // there is a password in it
};

// All or nothing: a failure leaves the old file untouched.
[[nodiscard]] Result<> writeFile(const QString& path, const QByteArray& bytes, Readers readers = Readers::Anybody);
// Who may read a file that is there, for a copy of it.
[[nodiscard]] Readers readersOf(const QString& path);

}  // namespace boresight::profile
