// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/recorder/recording_job.h"

#include <QFuture>
#include <QObject>
#include <QString>
#include <QThreadPool>

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>

// Records passes into files of a folder. Lives on the station thread, which never waits for the disk: one worker writes
// every kBlock. While the disk does not answer, up to kMostWaiting ticks wait in memory. Further ticks are lost. They
// are counted, and the file has a gap. A failed write is repeated every kRetry.
// More than 15 members: what waits, what is being written, and what was lost.
namespace boresight::recorder {

class PassRecorder final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kBlock{10};  // a power loss costs the last ticks of this time
    static constexpr std::chrono::seconds kRetry{5};
    static constexpr std::chrono::seconds kSlow{20};     // a write that lasts longer is trouble
    static constexpr std::size_t kMostWaiting = 30'000;  // 10 minutes at 50 Hz, 15 MB
    static constexpr std::size_t kMostEvents = 2'000;    // waiting
    static constexpr std::size_t kMostFiles = 20;        // that begin and wait
    static constexpr std::size_t kFileTicks = 180'000;   // an hour at 50 Hz. Then the next file begins
    // At the end of the program the longest wait for the disk, for all jobs together.
    static constexpr std::chrono::milliseconds kPatience{2000};

    // The clock outlives this object. `append` is called on the worker.
    PassRecorder(const QString& folder, const Clock& clock, QObject* parent = nullptr,
                 JobWriter::Append append = appendWhole, std::chrono::milliseconds patience = kPatience);
    // Ends the recording. Writes what waits, at most for `patience`.
    ~PassRecorder() override;

    [[nodiscard]] bool isRecording() const { return m_header.has_value(); }
    // True if nothing waits for the disk.
    [[nodiscard]] bool isIdle() const { return m_jobs.empty(); }
    // For stored recordings, from the next write on.
    void setLimits(const KeepLimits& limits) { m_limits = limits; }
    // Begins a recording. One that runs ends. Nothing begins while too many recordings wait for the disk.
    void begin(const recording::Header& header);
    // Corrects the header of the recording. A file whose beginning is written keeps its header.
    void describe(const recording::Header& header);
    void end();

    // Without a recording these do nothing.
    void add(const recording::Tick& tick);
    void add(const recording::Event& event);
    void notePlan(const plan::PlanVariant& plan);

    // Takes the result of the worker and passes it the next job. Once per tick of the station.
    void tick();

    [[nodiscard]] std::uint64_t lostTicks() const { return m_lost; }  // since the start of the program

Q_SIGNALS:
    // Emitted by tick(): why ticks cannot be stored now. Empty: they are stored again.
    void troubled(const QString& reason);

private:
    using Jobs = std::deque<std::shared_ptr<RecordingJob>>;

    [[nodiscard]] bool isCollecting() const { return m_jobs.size() > (m_writing ? 1U : 0U); }
    [[nodiscard]] RecordingJob& collecting();
    RecordingJob& addJob();
    [[nodiscard]] bool isCrowded() const;
    void openFile();
    void closeFile();
    void closeGap();
    [[nodiscard]] bool isDue() const;
    void startWriting();
    void finishWriting();
    void tellTrouble(const QString& reason);

    const Clock& m_clock;
    std::shared_ptr<JobWriter> m_writer;  // used by the worker while it writes; shared, because it may outlive this
    std::optional<recording::Header> m_header;  // of the recording that runs
    KeepLimits m_limits;
    std::optional<plan::PlanVariant> m_plan;
    Jobs m_jobs;                      // oldest first. While m_writing is set, the worker reads the first one
    std::size_t m_waiting = 0;        // ticks in the jobs
    std::size_t m_waitingEvents = 0;  // events in the jobs
    std::size_t m_inFile = 0;         // ticks of the present file
    std::optional<recording::Gap> m_gap;
    bool m_isRefused = false;  // the last recording did not begin
    std::uint64_t m_lost = 0;
    std::optional<SteadyTime> m_retryAt;
    SteadyTime m_begun{};  // the newest job
    std::optional<QFuture<Result<>>> m_writing;
    SteadyTime m_writingSince{};
    std::chrono::milliseconds m_patience;
    QString m_trouble;
    std::unique_ptr<QThreadPool> m_pool;  // one thread
};

}  // namespace boresight::recorder
