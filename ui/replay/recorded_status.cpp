// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/recorded_status.h"

#include "core/messages/state_word.h"
#include "ui/kit/axes.h"

#include <algorithm>
#include <array>

namespace boresight::ui {

namespace {

constexpr std::array kStates{StationState::Disconnected, StationState::Standby,   StationState::Hold,
                             StationState::Slew,         StationState::Track,     StationState::Jog,
                             StationState::Parked,       StationState::Calibrate, StationState::Stopped,
                             StationState::Fault};
constexpr std::chrono::minutes kReplayTrail{15};
constexpr UtcTime::duration kReplayTrailStep = std::chrono::milliseconds(100);

StationState stateOf(const QString& word)
{
    const auto* const found =
        std::ranges::find_if(kStates, [&](StationState state) { return protocolWord(state) == word; });
    return found == kStates.end() ? StationState::Disconnected : *found;
}

std::optional<Angle> part(const std::optional<SkyPointing>& direction, Axis axis)
{
    return direction ? std::optional(axis == Axis::Azimuth ? direction->azimuth : direction->elevation) : std::nullopt;
}

AxisStatus axisStatus(const recording::Tick& tick, Axis axis, std::chrono::milliseconds age)
{
    const recording::AxisTick& one = tick.axis(axis);
    return {.actual = one.actual,
            .rate = one.rate,
            .age = age,
            .commanded = one.commanded,
            .commandedRate = one.commandedRate,
            .target = one.target,
            .beam = {.actual = part(tick.actual, axis),
                     .commanded = part(tick.commanded, axis),
                     .target = part(tick.target, axis)},
            .busVoltage = one.busVoltage,
            .boardTemperature = one.boardTemperature,
            .motorTemperature = one.motorTemperature,
            .torque = one.torque,
            .current = one.current,
            .power = one.power,
            .turnKnown = true};
}

// Whether the mount had drives that can be read.
bool hasDrive(const recording::Tick& tick)
{
    return std::ranges::any_of(tick.axes, [](const recording::AxisTick& axis) {
        return axis.torque || axis.current || axis.busVoltage || axis.boardTemperature;
    });
}

}  // namespace

SteadyTime steadyTimeOf(UtcTime utc)
{
    return SteadyTime(std::chrono::duration_cast<SteadyTime::duration>(utc.time_since_epoch()));
}

std::shared_ptr<const profile::Profile> recordedProfile(const recording::Header& header)
{
    auto profile = std::make_shared<profile::Profile>();
    profile->mount.name = header.mount.toStdString();
    profile->mount.beamWidth = header.beamWidth;
    if (header.site) {
        profile->site.known = true;
        profile->site.latitude = header.site->latitude;
        profile->site.longitude = header.site->longitude;
    }
    return profile;
}

StationStatus recordedStatus(const ReplayTape& tape, const std::shared_ptr<const profile::Profile>& profile,
                             UtcTime utc)
{
    const recording::Header& header = tape.header();
    StationStatus status;
    status.utc = utc;
    status.simulated = header.isSimulated;
    status.profile = profile;
    const recording::Tick* const tick = tape.tickAt(utc);
    if (tick == nullptr) {
        return status;
    }
    const auto age = std::chrono::duration_cast<std::chrono::milliseconds>(utc - tick->utc);
    status.state = stateOf(header.stateWord(tick->state));
    status.azimuth = axisStatus(*tick, Axis::Azimuth, age);
    status.elevation = axisStatus(*tick, Axis::Elevation, age);
    status.actual = tick->actual;
    status.commanded = tick->commanded;
    status.target = tick->target;
    status.targetText = header.target;
    status.aimed = tick->target.has_value();
    status.sensor.direction = tick->sensor;
    status.wind.speed = tick->wind;
    if (tape.way()) {
        status.tracked = TrackedTarget{.name = header.target, .number = header.number, .isUp = true, .way = tape.way()};
    }
    if (hasDrive(*tick)) {
        status.drives.emplace();
    }
    return status;
}

TickSample recordedSample(const recording::Tick& tick)
{
    TickSample sample{.time = steadyTimeOf(tick.utc)};
    for (const Axis axis : kAxes) {
        const recording::AxisTick& one = tick.axis(axis);
        sample.axes[axisIndex(axis)] = {.commanded = one.commanded,
                                        .actual = one.actual,
                                        .torque = one.torque,
                                        .current = one.current,
                                        .busVoltage = one.busVoltage,
                                        .boardTemperature = one.boardTemperature,
                                        .motorTemperature = one.motorTemperature};
    }
    return sample;
}

std::vector<SeenPlace> recordedTrail(const ReplayTape& tape, UtcTime utc)
{
    std::vector<SeenPlace> places;
    const std::size_t until = tape.ticksUntil(utc);
    for (std::size_t i = tape.ticksUntil(utc - kReplayTrail); i < until; ++i) {
        const recording::Tick& tick = tape.ticks()[i];
        if (tick.actual && (places.empty() || i + 1 == until || tick.utc - places.back().utc >= kReplayTrailStep)) {
            places.push_back({.direction = *tick.actual, .utc = tick.utc});
        }
    }
    return places;
}

}  // namespace boresight::ui
