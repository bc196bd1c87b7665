// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/recorded_tick.h"

#include "core/base/text.h"
#include "core/base/version.h"
#include "core/messages/state_word.h"
#include "core/units/angle_between.h"

namespace boresight {
namespace {

template <class State>
QStringList wordsUntil(State last, QString (*wordOf)(State))
{
    QStringList words;
    for (int i = 0; i <= static_cast<int>(last); ++i) {
        words.append(wordOf(static_cast<State>(i)));
    }
    return words;
}

recording::AxisTick recordedAxis(const AxisStatus& status, const AxisSample& sample)
{
    return {.actual = sample.actual,
            .commanded = sample.commanded,
            .target = status.target,
            .rate = status.rate,
            .commandedRate = status.commandedRate,
            .torque = sample.torque,
            .current = sample.current,
            .busVoltage = sample.busVoltage,
            .power = status.power,
            .boardTemperature = sample.boardTemperature,
            .motorTemperature = sample.motorTemperature,
            .state = static_cast<int>(status.state)};
}

recording::EventKind recordedKind(LogKind kind)
{
    switch (kind) {
        case LogKind::MotionStart:
            return recording::EventKind::MotionStart;
        case LogKind::Alarm:
            return recording::EventKind::Alarm;
        case LogKind::Event:
            break;
    }
    return recording::EventKind::Event;
}

recording::EventLevel recordedLevel(Severity severity)
{
    switch (severity) {
        case Severity::Alarm:
            return recording::EventLevel::Alarm;
        case Severity::Warning:
            return recording::EventLevel::Warning;
        case Severity::Advisory:
            break;
    }
    return recording::EventLevel::Advisory;
}

}  // namespace

recording::Tick recordedTick(const StationStatus& status, const TickSample& sample, const SensorStatus& sensor,
                             UtcTime utc)
{
    recording::Tick tick{.utc = utc,
                         .state = static_cast<int>(status.state),
                         .actual = status.actual,
                         .commanded = status.commanded,
                         .target = status.target,
                         .sensor = sensor.direction,
                         .wind = status.wind.isSilent ? std::nullopt : status.wind.speed,
                         .axes = {recordedAxis(status.azimuth, sample.axes[index(Axis::Azimuth)]),
                                  recordedAxis(status.elevation, sample.axes[index(Axis::Elevation)])}};
    if (status.actual && status.target) {
        tick.error = angleBetween(*status.actual, *status.target);
    }
    return tick;
}

recording::Event recordedEvent(const LogEntry& entry, Seconds ahead)
{
    return {.utc = entry.utc - std::chrono::round<UtcTime::duration>(ahead),
            .kind = recordedKind(entry.kind),
            .level = recordedLevel(entry.severity),
            .source = entry.source,
            .text = entry.text};
}

recording::Header recordedHeader(const StationStatus& status, bool simulated)
{
    const profile::Profile& profile = *status.profile;
    recording::Header header{.program = QStringLiteral("Boresight ") + QLatin1String(kVersion),
                             .mount = toQString(profile.mount.name),
                             .isSimulated = simulated,
                             .beamWidth = antennaOf(status).beamWidth,
                             .began = status.utc,
                             .stateWords = wordsUntil<StationState>(StationState::Fault, protocolWord),
                             .axisWords = wordsUntil<AxisState>(AxisState::Missing, word)};
    if (profile.site.known) {
        header.site = profile.site.place();
    }
    if (status.tracked) {
        header.target = status.tracked->name;
        header.number = status.tracked->number;
    } else if (status.clientTarget) {
        header.target = status.clientTarget->name;
    }
    if (status.commander.kind == SourceKind::Client) {
        header.client = status.commander.name;
    }
    return header;
}

}  // namespace boresight
