// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recorder/pass_recorder.h"

#include "core/base/text.h"

#include <QPromise>

#include <utility>

namespace boresight::recorder {

PassRecorder::PassRecorder(const QString& folder, const Clock& clock, QObject* parent, JobWriter::Append append)
    : QObject(parent),
      m_clock(clock),
      m_writer(std::make_shared<JobWriter>(folder, std::move(append))),
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
    const auto isDone = [this] { return m_pool->waitForDone(static_cast<int>(kPatience.count())); };
    bool isIdle = isDone();
    m_retryAt.reset();
    while (isIdle && !m_retryAt && (m_writing || !m_jobs.empty())) {
        finishWriting();
        if (!m_jobs.empty() && !m_retryAt) {
            startWriting();
        }
        isIdle = isDone();
    }
    if (!isIdle) {
        (void)m_pool.release();  // its thread waits for the disk, and deleting it would wait for ever
    }
}

void PassRecorder::begin(const recording::Header& header, const KeepLimits& limits)
{
    end();
    m_isRefused = m_jobs.size() >= kMostJobs;
    if (m_isRefused) {
        return;
    }
    m_header = header;
    m_limits = limits;
    openFile();
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
    if (isCollecting() && m_jobs.back()->begins) {
        m_jobs.back()->begins = *m_header;
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
    m_begun = m_clock.now();
    m_jobs.push_back(std::make_shared<RecordingJob>());
    m_jobs.back()->begins = *m_header;
    m_jobs.back()->limits = m_limits;
    m_jobs.back()->plan = m_plan;
}

void PassRecorder::closeFile()
{
    closeGap();
    collecting().ends = true;
}

// The newest job, if the worker does not have it. Else a new one, which continues the file.
RecordingJob& PassRecorder::collecting()
{
    if (!isCollecting()) {
        m_jobs.push_back(std::make_shared<RecordingJob>());
        m_begun = m_clock.now();
    }
    return *m_jobs.back();
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
    collecting().ticks.push_back(tick);
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
    if (m_header && collecting().events.size() < kMostEvents) {
        collecting().events.push_back(event);
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
    const bool isFull = m_gap && m_waiting >= kMostWaiting;
    const bool isCrowded = m_isRefused && m_jobs.size() >= kMostJobs;
    if (m_writing && (isFull || isCrowded)) {
        tellTrouble(Text::tr("the disk does not answer"));
    }
}

// The shared promise keeps the answer valid even if this object was destroyed meanwhile.
void PassRecorder::startWriting()
{
    const auto promise = std::make_shared<QPromise<Result<>>>();
    m_writing = promise->future();
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
