// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recorder/recording_job.h"

#include "core/base/text.h"
#include "core/recording/record_writer.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace boresight::recorder {
namespace {

QByteArray bytesOf(const RecordingJob& job)
{
    QByteArray bytes;
    if (job.plan) {
        bytes += recording::planBlock(*job.plan);
    }
    if (!job.ticks.empty()) {
        bytes += recording::tickBlock(job.ticks);
    }
    for (const recording::Gap& gap : job.gaps) {
        bytes += recording::gapBlock(gap);
    }
    if (!job.events.empty()) {
        bytes += recording::eventBlock(job.events);
    }
    return job.ends ? bytes + recording::fileEnd() : bytes;
}

}  // namespace

QString JobWriter::newPath(const recording::Header& header) const
{
    const QDir folder(m_folder);
    QString path = folder.filePath(recordingName(header.began, header.target));
    for (int number = 2; QFile::exists(path); ++number) {
        path = folder.filePath(recordingName(header.began, QStringLiteral("%1_%2").arg(header.target).arg(number)));
    }
    return path;
}

Result<> JobWriter::write(const RecordingJob& job)
{
    if (job.begins) {
        if (!QDir().mkpath(m_folder)) {
            return failure(ErrorCode::Io, Text::tr("cannot make the folder %1").arg(m_folder));
        }
        deleteExpired(m_folder, job.limits, job.begins->began);
        m_path = newPath(*job.begins);
        m_header = *job.begins;
    }
    // Somebody may have deleted the file meanwhile.
    const bool needsStart = !QFile::exists(m_path);
    const QByteArray bytes = (needsStart ? recording::fileStart(m_header) : QByteArray()) + bytesOf(job);
    const Result<> outcome = m_append(m_path, bytes);
    const bool hasMoreRoom =
        !outcome && deleteExpired(m_folder, job.limits, m_header.began, QFileInfo(m_path).fileName());
    return hasMoreRoom ? m_append(m_path, bytes) : outcome;
}

}  // namespace boresight::recorder
