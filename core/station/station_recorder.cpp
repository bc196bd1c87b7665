// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_recorder.h"

#include "core/alarms/catalogue.h"
#include "core/base/file_name.h"
#include "core/station/recorded_tick.h"

#include <algorithm>

namespace boresight {
namespace {

// The newest lines of the log before a recording are its first events: they say why the mount moves. Older lines belong
// to something else.
constexpr std::uint64_t kEntriesBefore = 5;
constexpr std::chrono::seconds kOldestBefore{60};
constexpr qint64 kMegabyte = 1'000'000;

// The mount is on a moving target, or on its way to one. The way to a fixed place is no pass. It may look like the way
// to a target for a moment, so it begins no recording.
bool followsTarget(const StationStatus& status, bool isRecording)
{
    const bool isMoving = status.tracked && status.tracked->skyRate;
    const bool isOnTheWay = status.state == StationState::Slew && status.aimed && !status.slew;
    return status.state == StationState::Track || ((isMoving || isRecording) && isOnTheWay);
}

}  // namespace

QString recordingsPath(const QString& stateDir, const QString& mountName, bool simulated)
{
    return QStringLiteral("%1/recordings/%2%3")
        .arg(stateDir, safeFileName(mountName), simulated ? QStringLiteral(".simulated") : QString());
}

StationRecorder::StationRecorder(const QString& folder, const profile::InForce& profile, bool simulated,
                                 StationControl& control, const StationSensor& sensor, const Clock& clock,
                                 const EventLog& log, QObject* parent)
    : QObject(parent),
      m_profile(profile),
      m_simulated(simulated),
      m_control(control),
      m_sensor(sensor),
      m_clock(clock),
      m_log(log),
      m_recorder(folder, clock, this)
{
    connect(&m_recorder, &recorder::PassRecorder::troubled, this, &StationRecorder::showTrouble);
}

// The status while the mount follows a moving target, also on its way to the target. The status takes longer than the
// state, so the state is looked at first.
std::optional<StationStatus> StationRecorder::followed() const
{
    const StationState state = m_control.state();
    const bool mayFollow = state == StationState::Track || state == StationState::Slew;
    if (m_profile->record.passes == profile::RecordPasses::Off || !(mayFollow || m_recorder.isRecording())) {
        return std::nullopt;
    }
    return m_control.briefStatus();
}

void StationRecorder::tick()
{
    keepWithinLimits();
    const auto status = followed();
    const bool follows = status && followsTarget(*status, m_recorder.isRecording());
    if (follows) {
        m_followed = m_clock.now();
        beginOrDescribe(*status);
    }
    if (const auto sample = m_control.sample(); status && sample && m_recorder.isRecording()) {
        const auto since = std::chrono::round<UtcTime::duration>(m_clock.now() - sample->time);
        m_recorder.add(recordedTick(*status, *sample, m_sensor.status(), status->utc - since));
        recordPlan(*status);
        recordEvents(*status);
    }
    if (m_recorder.isRecording() && (!status || m_clock.now() - m_followed >= kAfter)) {
        m_recorder.end();
    }
    m_recorder.tick();
}

// Another target has another recording. A client's target may become known after its first points.
void StationRecorder::beginOrDescribe(const StationStatus& status)
{
    const recording::Header header = recordedHeader(status, m_simulated);
    const bool isSame = m_target == header.target || m_target.isEmpty() || header.target.isEmpty();
    if (!m_recorder.isRecording() || !isSame) {
        m_recorder.begin(header);
        m_target = header.target;
        m_point.clear();
        m_plan.reset();
        m_lastEntry = lastEntryBefore();
    } else if (m_target != header.target && m_target.isEmpty()) {
        m_target = header.target;
        m_recorder.describe(header);
    }
}

// The number of the newest line of the log that is too old for a recording that begins now.
std::uint64_t StationRecorder::lastEntryBefore() const
{
    std::uint64_t last = m_log.lastNumber() - std::min(m_log.lastNumber(), kEntriesBefore);
    for (const LogEntry& entry : m_log.since(last, kEntriesBefore)) {
        // A line from before the clock was set back may look like one of the future.
        if (abs(m_clock.computerUtc() - entry.utc) >= kOldestBefore) {
            last = entry.number;
        }
    }
    return last;
}

// While nothing sets the clock, the ages of the recordings are unknown.
void StationRecorder::keepWithinLimits()
{
    const auto& keep = m_profile->record;
    recorder::KeepLimits limits{.age = std::nullopt, .bytes = keep.keepMegabytes * kMegabyte};
    if (m_clock.synchronised()) {
        limits.age = std::chrono::days(keep.keepDays);
    }
    m_recorder.setLimits(limits);
}

void StationRecorder::recordPlan(const StationStatus& status)
{
    const plan::SharedVariant plan = status.tracked ? status.tracked->plan : nullptr;
    if (plan && plan != m_plan) {
        m_plan = plan;
        m_recorder.notePlan(*plan);
    }
}

// The lines of the log, and each new point of the client that moves the mount.
void StationRecorder::recordEvents(const StationStatus& status)
{
    if (m_log.lastNumber() != m_lastEntry) {
        for (const LogEntry& entry : m_log.since(m_lastEntry, EventLog::kCapacity)) {
            m_recorder.add(recordedEvent(entry, m_clock.ahead()));
        }
        m_lastEntry = m_log.lastNumber();
    }
    if (status.commander.kind == SourceKind::Client && status.targetText != m_point) {
        m_point = status.targetText;
        m_recorder.add(recording::Event{.utc = status.utc,
                                        .kind = recording::EventKind::ClientLine,
                                        .source = status.commander.name,
                                        .text = m_point});
    }
}

void StationRecorder::showTrouble(const QString& reason)
{
    const AlarmKey key = alarmEntry("record.not-stored");
    if (reason.isEmpty()) {
        m_control.alarms().clear(key);
    } else {
        m_control.alarms().raise(key, {reason});
    }
}

}  // namespace boresight

#include "moc_station_recorder.cpp"
