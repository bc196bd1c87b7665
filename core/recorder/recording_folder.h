// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

// The folder with the recordings of one mount. All functions that touch files may block, so only the worker of the
// recorder calls them.
namespace boresight::recorder {

// For how long and up to what size recordings are kept.
struct KeepLimits
{
    std::optional<std::chrono::days> age = std::chrono::days(30);  // empty: the age deletes nothing
    qint64 bytes = 2'000'000'000;

    bool operator==(const KeepLimits&) const = default;
};

struct StoredRecording
{
    QString name;
    UtcTime began{};
    qint64 bytes = 0;
};

// "20261130T141000Z_NOAA_19.recording". Without a target: "20261130T141000Z.recording".
[[nodiscard]] QString recordingName(UtcTime began, const QString& target);

// The recordings in the folder, oldest first. Files with other names are no recordings.
[[nodiscard]] std::vector<StoredRecording> storedRecordings(const QString& folder);

// The names of those that have to go, oldest first. `stored` has the oldest first. The file `inWriting` never goes, but
// its size counts.
[[nodiscard]] QStringList expired(const std::vector<StoredRecording>& stored, const KeepLimits& limits, UtcTime now,
                                  const QString& inWriting = {});

// Deletes the expired recordings. True: at least one was deleted.
bool deleteExpired(const QString& folder, const KeepLimits& limits, UtcTime now, const QString& inWriting = {});

// Appends all bytes and waits until they are on the disk. After a failure the file has its old size, and a new file is
// gone.
[[nodiscard]] Result<> appendWhole(const QString& path, const QByteArray& bytes);

}  // namespace boresight::recorder
