// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recorder/pass_recorder.h"

#include "core/base/text.h"

#include <QDeadlineTimer>
#include <QPromise>

#include <algorithm>
#include <utility>

namespace boresight::recorder {

PassRecorder::PassRecorder(const QString& folder, const Clock& clock, QObject* parent, JobWriter::Append append,
                           std::chrono::milliseconds patience)
    : QObject(parent),
      m_clock(clock),
      m_writer(std::make_shared<JobWriter>(folder, std::move(append))),
      m_patience(patience),
      m_pool(std::make_unique<QThreadPool>())
{
    m_pool->setMaxThreadCount(1);
    m_pool->setExpiryTimeout(-1);
    m_pool->setThreadPriority(QThread::NormalPriority);  // lower than that of the station thread
}

PassRecorder::~PassRecorder()
{
    blockSignals(true);  // receivers of the signals may be half destroyed
    end();
    const QDeadlineTimer limit(m_patience);
    const auto isDone = [this, &limit] { return m_pool->waitForDone(static_cast<int>(limit.remainingTime())); };
    bool isPoolDone = isDone();
    m_retryAt.reset();
    while (isPoolDone && !m_retryAt && !isIdle() && (m_writing || !limit.hasExpired())) {
        finishWriting();
        if (!isIdle() && !m_retryAt && !limit.hasExpired()) {
            startWriting();
        }
        isPoolDone = isDone();
    }
    if (!isPoolDone) {
        (void)m_pool.release();  // its thread waits for the disk, and deleting it would wait for ever
    }
}

void PassRecorder::begin(const recording::Header& header)
{
    end();
    m_isRefused = isCrowded();
    if (m_isRefused) {
        return;
    }
    m_header = header;
    openFile();
}

bool PassRecorder::isCrowded() const
{
    const auto begins = [](const auto& job) { return job->begins.has_value(); };
    return std::ranges::count_if(m_jobs, begins) >= std::ptrdiff_t{kMostFiles};
}

void PassRecorder::describe(const recording::Header& header)
{
    if (!m_header) {
        return;
    }
    const int part = m_header->part;
    const UtcTime began = m_header->began;
    m_header = header;
    m_header->part = part;
    m_header->began = began;
    // The worker may read the first job.
    const auto last = m_jobs.rend() - (m_writing ? 1 : 0);
    const auto beginning = std::find_if(m_jobs.rbegin(), last, [](const auto& job) { return job->begins.has_value(); });
    if (beginning != last) {
        (*beginning)->begins = *m_header;
    }
}

void PassRecorder::end()
{
    if (m_header) {
        closeFile();
        m_header.reset();
        m_plan.reset();
    }
}

void PassRecorder::openFile()
{
    m_inFile = 0;
    RecordingJob& first = addJob();
    first.begins = *m_header;
    first.plan = m_plan;
}

RecordingJob& PassRecorder::addJob()
{
    m_begun = m_clock.now();
    return *m_jobs.emplace_back(std::make_shared<RecordingJob>());
}

void PassRecorder::closeFile()
{
    closeGap();
    collecting().ends = true;
}

// The newest job, if the worker does not have it. Else a new one, which continues the file.
RecordingJob& PassRecorder::collecting()
{
    return isCollecting() ? *m_jobs.back() : addJob();
}

void PassRecorder::add(const recording::Tick& tick)
{
    if (!m_header) {
        return;
    }
    if (m_waiting >= kMostWaiting) {
        m_gap = m_gap.value_or(recording::Gap{.from = tick.utc, .to = tick.utc});
        m_gap->to = tick.utc;
        ++m_gap->ticks;
        ++m_lost;
        return;
    }
    closeGap();
    if (m_inFile >= kFileTicks) {
        closeFile();
        ++m_header->part;
        m_header->began = tick.utc;
        openFile();
    }
    const bool isFull = collecting().ticks.size() >= RecordingJob::kMostTicks;
    (isFull ? addJob() : collecting()).ticks.push_back(tick);
    ++m_inFile;
    ++m_waiting;
}

void PassRecorder::closeGap()
{
    if (m_gap) {
        collecting().gaps.push_back(*std::exchange(m_gap, std::nullopt));
    }
}

void PassRecorder::add(const recording::Event& event)
{
    if (m_header && m_waitingEvents < kMostEvents) {
        collecting().events.push_back(event);
        ++m_waitingEvents;
    }
}

void PassRecorder::notePlan(const plan::PlanVariant& plan)
{
    if (m_header) {
        m_plan = plan;
        collecting().plan = plan;
    }
}

bool PassRecorder::isDue() const
{
    if (m_jobs.empty() || (m_retryAt && m_clock.now() < *m_retryAt)) {
        return false;
    }
    return m_jobs.size() > 1 || m_jobs.front()->ends || m_clock.now() - m_begun >= kBlock;
}

void PassRecorder::tick()
{
    if (m_writing && m_writing->isFinished()) {
        finishWriting();
    }
    if (!m_writing && isDue()) {
        startWriting();
    }
    const bool isSlow = m_clock.now() - m_writingSince >= kSlow;
    const bool isFull = m_gap && m_waiting >= kMostWaiting;
    if (m_writing && (isSlow || isFull || (m_isRefused && isCrowded()))) {
        tellTrouble(Text::tr("the disk does not answer"));
    }
}

// The shared promise keeps the answer valid even if this object was destroyed meanwhile.
void PassRecorder::startWriting()
{
    const auto promise = std::make_shared<QPromise<Result<>>>();
    m_writing = promise->future();
    m_writingSince = m_clock.now();
    m_jobs.front()->limits = m_limits;
    m_pool->start([promise, writer = m_writer, job = std::shared_ptr<const RecordingJob>(m_jobs.front())] {
        promise->start();
        promise->addResult(writer->write(*job));
        promise->finish();
    });
}

void PassRecorder::finishWriting()
{
    if (!m_writing) {
        return;
    }
    const Result<> outcome = std::exchange(m_writing, std::nullopt)->result();
    if (!outcome) {
        m_retryAt = m_clock.now() + kRetry;
        tellTrouble(outcome.error().text);
        return;
    }
    m_retryAt.reset();
    m_waiting -= m_jobs.front()->ticks.size();
    m_waitingEvents -= m_jobs.front()->events.size();
    m_jobs.pop_front();
    tellTrouble({});
}

void PassRecorder::tellTrouble(const QString& reason)
{
    if (m_trouble != reason) {
        m_trouble = reason;
        Q_EMIT troubled(reason);
    }
}

}  // namespace boresight::recorder

#include "moc_pass_recorder.cpp"
