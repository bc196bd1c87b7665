// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/result.h"

#include <QFuture>
#include <QObject>
#include <QString>
#include <QThreadPool>

#include <memory>
#include <optional>

// The event log on disk: one line per entry in STATE_DIR/events.log, UTC first. At kLargest bytes the file becomes
// events.log.1 and a new one begins. Lives on the station thread, which never waits for the disk: one worker writes.
// Entries that are not on the disk yet stay in the EventLog, which keeps EventLog::kCapacity of them. The file says how
// many more were lost. A failed write is repeated every kRetry.
namespace boresight {

class EventFile final : public QObject
{
    Q_OBJECT

public:
    static constexpr qint64 kLargest = 5'000'000;
    static constexpr std::chrono::seconds kRetry{5};
    // At the end of the program the longest wait for a disk that does not answer.
    static constexpr std::chrono::milliseconds kPatience{2000};

    // Log and clock must outlive this object.
    EventFile(const QString& stateDir, const EventLog& log, const Clock& clock, QObject* parent = nullptr);
    // Writes the last entries and waits for that, at most kPatience.
    ~EventFile() override;

    // Takes the result of the worker and passes it the new entries. Once per tick of the station.
    void tick();

Q_SIGNALS:
    // Emitted by tick(), each time that a write fails.
    void failed(const QString& reason);
    void written();

private:
    struct Writer;
    struct Batch;
    struct Outcome
    {
        std::uint64_t lastNumber = 0;  // last entry that is on the disk
        Result<> result;
    };

    [[nodiscard]] Batch nextBatch() const;
    void startWriting(Batch batch);
    void finishWriting();

    const EventLog& m_log;
    const Clock& m_clock;
    // Used by the worker while it writes; shared, because the worker may outlive this object.
    std::shared_ptr<Writer> m_writer;
    std::uint64_t m_lastNumber = 0;  // last entry that is on the disk
    std::optional<SteadyTime> m_retryAt;
    std::optional<QFuture<Outcome>> m_writing;
    std::unique_ptr<QThreadPool> m_pool;  // one thread
};

}  // namespace boresight
