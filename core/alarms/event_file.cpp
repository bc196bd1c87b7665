// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/event_file.h"

#include "core/base/text.h"

#include <QDateTime>
#include <QFile>
#include <QPromise>

#include <utility>
#include <vector>

namespace boresight {
namespace {

QString line(const LogEntry& entry)
{
    const auto sinceEpoch = std::chrono::duration_cast<std::chrono::milliseconds>(entry.utc.time_since_epoch());
    const QString utc = QDateTime::fromMSecsSinceEpoch(sinceEpoch.count(), Qt::UTC).toString(Qt::ISODateWithMs);
    return utc + QLatin1Char(' ') + plainLine(entry) + QLatin1Char('\n');
}

}  // namespace

// The entries since the last write.
struct EventFile::Batch
{
    std::uint64_t after = 0;  // number of the last entry that is on the disk
    std::vector<LogEntry> entries;
};

// The file, and all calls that may wait for the disk. Called by one thread at a time.
struct EventFile::Writer
{
    explicit Writer(const QString& path) : file(path) {}

    [[nodiscard]] Outcome write(const Batch& batch)
    {
        Outcome outcome{.lastNumber = batch.after, .result = {}};
        for (const LogEntry& entry : batch.entries) {
            outcome.result = append(gapBefore(entry, outcome.lastNumber) + line(entry));
            if (!outcome.result) {
                file.close();  // opens it again: it may have been deleted, or its disk may have come back
                break;
            }
            outcome.lastNumber = entry.number;
        }
        return outcome;
    }

private:
    [[nodiscard]] static QString gapBefore(const LogEntry& entry, std::uint64_t lastNumber)
    {
        if (entry.number == lastNumber + 1) {
            return {};
        }
        LogEntry gap = entry;
        gap.source = QStringLiteral("log");
        gap.text =
            Text::tr("%1 lines were lost: the disk did not store them in time").arg(entry.number - lastNumber - 1);
        return line(gap);
    }

    [[nodiscard]] Result<> append(const QString& text)
    {
        if (file.isOpen() && file.size() > kLargest) {
            rotate();
        }
        if (!file.isOpen() && !file.open(QIODevice::Append | QIODevice::Unbuffered)) {
            return failed();
        }
        const QByteArray bytes = text.toUtf8();
        const qint64 before = file.size();
        if (file.write(bytes) != bytes.size()) {
            const Result<> why = failed();
            file.resize(before);  // removes a half-written line
            return why;
        }
        return {};
    }

    void rotate()
    {
        file.close();
        const QString old = file.fileName() + QStringLiteral(".1");
        QFile::remove(old);
        QFile::rename(file.fileName(), old);
    }

    [[nodiscard]] Result<> failed() const
    {
        return failure(ErrorCode::Io, Text::tr("cannot write %1: %2").arg(file.fileName(), file.errorString()));
    }

    QFile file;
};

EventFile::EventFile(const QString& stateDir, const EventLog& log, const Clock& clock, QObject* parent)
    : QObject(parent),
      m_log(log),
      m_clock(clock),
      m_writer(std::make_shared<Writer>(stateDir + QStringLiteral("/events.log"))),
      m_pool(std::make_unique<QThreadPool>())
{
    m_pool->setMaxThreadCount(1);
    m_pool->setExpiryTimeout(-1);
    m_pool->setThreadPriority(QThread::NormalPriority);  // lower than that of the station thread
}

EventFile::~EventFile()
{
    blockSignals(true);  // receivers of the signals may be half destroyed
    const auto isDone = [this] { return m_pool->waitForDone(static_cast<int>(kPatience.count())); };
    bool isIdle = isDone();
    if (isIdle) {
        finishWriting();
        startWriting(nextBatch());
        isIdle = isDone();
    }
    if (!isIdle) {
        (void)m_pool.release();  // its thread waits for the disk, and deleting it would wait for ever
    }
}

void EventFile::tick()
{
    if (m_writing && m_writing->isFinished()) {
        finishWriting();
    }
    if (m_writing || (m_retryAt && m_clock.now() < *m_retryAt)) {
        return;
    }
    if (Batch batch = nextBatch(); !batch.entries.empty()) {
        startWriting(std::move(batch));
    }
}

EventFile::Batch EventFile::nextBatch() const
{
    return {.after = m_lastNumber, .entries = m_log.since(m_lastNumber, EventLog::kCapacity)};
}

// The shared promise keeps the answer valid even if this object was destroyed meanwhile.
void EventFile::startWriting(Batch batch)
{
    const auto promise = std::make_shared<QPromise<Outcome>>();
    m_writing = promise->future();
    m_pool->start([promise, writer = m_writer, batch = std::move(batch)] {
        promise->start();
        promise->addResult(writer->write(batch));
        promise->finish();
    });
}

void EventFile::finishWriting()
{
    if (!m_writing) {
        return;
    }
    const Outcome outcome = std::exchange(m_writing, std::nullopt)->result();
    m_lastNumber = outcome.lastNumber;
    if (outcome.result) {
        m_retryAt.reset();
        Q_EMIT written();
    } else {
        m_retryAt = m_clock.now() + kRetry;
        Q_EMIT failed(outcome.result.error().text);
    }
}

}  // namespace boresight

#include "moc_event_file.cpp"
