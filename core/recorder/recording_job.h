// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recorder/recording_folder.h"
#include "core/recording/recording.h"

#include <QByteArray>
#include <QString>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

// What the worker of the recorder writes at once: a part of one file. Plain values.
namespace boresight::recorder {

struct RecordingJob
{
    // 10 s at 50 Hz, one block of the file. A longer block would lose more when a byte is damaged.
    static constexpr std::size_t kMostTicks = 500;

    // Of a new file, which this job begins. Empty: the job continues the file of the job before.
    std::optional<recording::Header> begins;
    KeepLimits limits;  // in force when the worker takes the job
    std::optional<plan::PlanVariant> plan;
    std::vector<recording::Tick> ticks;  // at most kMostTicks
    std::vector<recording::Event> events;
    std::vector<recording::Gap> gaps;  // after the ticks
    bool ends = false;
};

// Writes the jobs to files. Each call may block. One thread at a time.
class JobWriter
{
public:
    using Append = std::function<Result<>(const QString& path, const QByteArray& bytes)>;

    JobWriter(QString folder, Append append) : m_folder(std::move(folder)), m_append(std::move(append)) {}

    // Deletes expired recordings when a file begins, and when the disk takes no more bytes. A job that failed may be
    // written again.
    [[nodiscard]] Result<> write(const RecordingJob& job);

private:
    // The path of a new file. It has a number if there is a file of this name.
    [[nodiscard]] QString newPath(const recording::Header& header) const;

    QString m_folder;
    Append m_append;
    QString m_path;  // of the file in writing
    recording::Header m_header;
};

}  // namespace boresight::recorder
