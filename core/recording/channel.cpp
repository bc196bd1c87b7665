// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/channel.h"

#include "core/base/text.h"
#include "core/recording/column.h"

#include <algorithm>
#include <cmath>
#include <ratio>
#include <type_traits>
#include <utility>

namespace boresight::recording {
namespace {

constexpr double kAngleSteps = 10'000.0;
constexpr double kRateSteps = 1'000.0;
constexpr double kTimeSteps = 10'000.0;
// A double holds larger whole numbers only with gaps.
constexpr double kLargestWhole = 9'007'199'254'740'992.0;

using TimeStep = std::chrono::duration<std::int64_t, std::ratio<1, 10'000>>;

double recordedSeconds(UtcTime utc)
{
    return Seconds(std::chrono::round<TimeStep>(utc.time_since_epoch())).count();
}

UtcTime utcOfRecorded(double seconds)
{
    // The clock counts nanoseconds in 64 bits, which is enough until the year 2262.
    constexpr double kLatest = 9.2e9;
    const double within = std::clamp(seconds, -kLatest, kLatest);
    return UtcTime(std::chrono::duration_cast<UtcTime::duration>(TimeStep(std::llround(within * kTimeSteps))));
}

// The part of a tick that a channel is in, made when it is written.
struct WholeTick
{
    static const Tick& of(const Tick& tick) { return tick; }
    static Tick& of(Tick& tick) { return tick; }
};

template <std::size_t Number>
struct AxisOfTick
{
    static const AxisTick& of(const Tick& tick) { return tick.axes[Number]; }
    static AxisTick& of(Tick& tick) { return tick.axes[Number]; }
};

double plainNumber(double value)
{
    return value;
}
double plainNumber(int value)
{
    return value;
}
double plainNumber(Angle value)
{
    return value.degrees();
}
double plainNumber(AngularRate value)
{
    return value.degrees();
}

void setNumber(std::optional<double>& to, double value)
{
    to = value;
}
void setNumber(std::optional<int>& to, double value)
{
    constexpr double kMost = 1e9;
    to = static_cast<int>(std::lround(std::clamp(value, -kMost, kMost)));
}
void setNumber(std::optional<Angle>& to, double value)
{
    to = Angle::fromDegrees(value);
}
void setNumber(std::optional<AngularRate>& to, double value)
{
    to = AngularRate::fromDegrees(value);
}

template <class Part, auto Member>
Channel<Tick> channelOf(std::string name, std::string unit, double perUnit)
{
    return {.name = std::move(name),
            .unit = std::move(unit),
            .perUnit = perUnit,
            .get = [](const Tick& tick) -> std::optional<double> {
                const auto& value = Part::of(tick).*Member;
                return value ? std::optional(plainNumber(*value)) : std::nullopt;
            },
            .set = [](Tick& tick, double value) { setNumber(Part::of(tick).*Member, value); }};
}

template <auto Direction, auto Member>
Channel<Tick> directionChannel(std::string name, double perUnit)
{
    return {.name = std::move(name),
            .unit = "deg",
            .perUnit = perUnit,
            .get = [](const Tick& tick) -> std::optional<double> {
                const auto& direction = tick.*Direction;
                return direction ? std::optional(((*direction).*Member).degrees()) : std::nullopt;
            },
            .set =
                [](Tick& tick, double value) {
                    auto& direction = tick.*Direction;
                    direction = direction.value_or(SkyPointing{});
                    (*direction).*Member = Angle::fromDegrees(value);
                }};
}

template <auto Direction>
void addDirection(std::vector<Channel<Tick>>& all, const std::string& name, double perUnit)
{
    all.push_back(directionChannel<Direction, &SkyPointing::azimuth>(name + ".azimuth", perUnit));
    all.push_back(directionChannel<Direction, &SkyPointing::elevation>(name + ".elevation", perUnit));
}

template <std::size_t Number>
void addAxis(std::vector<Channel<Tick>>& all, const std::string& name)
{
    using Part = AxisOfTick<Number>;
    all.push_back(channelOf<Part, &AxisTick::actual>(name + ".actual", "deg", kAngleSteps));
    all.push_back(channelOf<Part, &AxisTick::commanded>(name + ".commanded", "deg", kAngleSteps));
    all.push_back(channelOf<Part, &AxisTick::target>(name + ".target", "deg", kAngleSteps));
    all.push_back(channelOf<Part, &AxisTick::rate>(name + ".rate", "deg/s", kRateSteps));
    all.push_back(channelOf<Part, &AxisTick::commandedRate>(name + ".commanded_rate", "deg/s", kRateSteps));
    all.push_back(channelOf<Part, &AxisTick::torque>(name + ".torque", "Nm", 1'000.0));
    all.push_back(channelOf<Part, &AxisTick::current>(name + ".current", "A", 1'000.0));
    all.push_back(channelOf<Part, &AxisTick::busVoltage>(name + ".voltage", "V", 100.0));
    all.push_back(channelOf<Part, &AxisTick::power>(name + ".power", "W", 10.0));
    all.push_back(channelOf<Part, &AxisTick::boardTemperature>(name + ".board_temperature", "degC", 10.0));
    all.push_back(channelOf<Part, &AxisTick::motorTemperature>(name + ".motor_temperature", "degC", 10.0));
    all.push_back(channelOf<Part, &AxisTick::state>(name + ".state", "word", 1.0));
}

std::vector<Channel<Tick>> makeTickChannels()
{
    std::vector<Channel<Tick>> all;
    all.push_back({.name = "utc",
                   .unit = "s",
                   .perUnit = kTimeSteps,
                   .get = [](const Tick& tick) { return std::optional(recordedSeconds(tick.utc)); },
                   .set = [](Tick& tick, double value) { tick.utc = utcOfRecorded(value); }});
    all.push_back(channelOf<WholeTick, &Tick::state>("state", "word", 1.0));
    addDirection<&Tick::actual>(all, "actual", kAngleSteps);
    addDirection<&Tick::commanded>(all, "commanded", kAngleSteps);
    addDirection<&Tick::target>(all, "target", kAngleSteps);
    all.push_back(channelOf<WholeTick, &Tick::error>("error", "deg", kAngleSteps));
    addDirection<&Tick::sensor>(all, "sensor", 100.0);
    all.push_back(channelOf<WholeTick, &Tick::wind>("wind", "m/s", 100.0));
    addAxis<0>(all, "azimuth");
    addAxis<1>(all, "elevation");
    return all;
}

template <auto Group, auto Member>
Channel<plan::PlannedMoment> momentChannel(std::string name, std::string unit, double perUnit)
{
    return {.name = std::move(name),
            .unit = std::move(unit),
            .perUnit = perUnit,
            .get = [](const plan::PlannedMoment& moment) -> std::optional<double> {
                return ((moment.*Group).*Member).degrees();
            },
            .set =
                [](plan::PlannedMoment& moment, double value) {
                    auto& part = (moment.*Group).*Member;
                    part = std::remove_cvref_t<decltype(part)>::fromDegrees(value);
                }};
}

std::vector<Channel<plan::PlannedMoment>> makePlanChannels()
{
    using Moment = plan::PlannedMoment;
    return {{.name = "utc",
             .unit = "s",
             .perUnit = kTimeSteps,
             .get = [](const Moment& moment) { return std::optional(recordedSeconds(moment.utc)); },
             .set = [](Moment& moment, double value) { moment.utc = utcOfRecorded(value); }},
            momentChannel<&Moment::target, &SkyPointing::azimuth>("target.azimuth", "deg", kAngleSteps),
            momentChannel<&Moment::target, &SkyPointing::elevation>("target.elevation", "deg", kAngleSteps),
            momentChannel<&Moment::axes, &AxisPosition::azimuth>("axes.azimuth", "deg", kAngleSteps),
            momentChannel<&Moment::axes, &AxisPosition::elevation>("axes.elevation", "deg", kAngleSteps),
            momentChannel<&Moment::rates, &AxisRates::azimuth>("rates.azimuth", "deg/s", kRateSteps),
            momentChannel<&Moment::rates, &AxisRates::elevation>("rates.elevation", "deg/s", kRateSteps),
            {.name = "error",
             .unit = "deg",
             .perUnit = kAngleSteps,
             .get = [](const Moment& moment) { return std::optional(moment.error.degrees()); },
             .set = [](Moment& moment, double value) { moment.error = Angle::fromDegrees(value); }},
            {.name = "hidden",
             .unit = "",
             .perUnit = 1.0,
             .get = [](const Moment& moment) { return std::optional(moment.isHidden ? 1.0 : 0.0); },
             .set = [](Moment& moment, double value) { moment.isHidden = value != 0.0; }}};
}

// A number that no column can hold counts as unknown.
std::optional<std::int64_t> asWhole(const std::optional<double>& value, double perUnit)
{
    const double steps = value.value_or(0.0) * perUnit;
    return value && std::abs(steps) < kLargestWhole ? std::optional<std::int64_t>(std::llround(steps)) : std::nullopt;
}

template <class Row>
QByteArray bytesOf(std::span<const Row> rows, const std::vector<Channel<Row>>& channels)
{
    QByteArray bytes;
    appendVarint(bytes, rows.size());
    Column column(rows.size());
    for (const Channel<Row>& channel : channels) {
        std::ranges::transform(rows, column.begin(),
                               [&](const Row& row) { return asWhole(channel.get(row), channel.perUnit); });
        appendColumn(bytes, column);
    }
    return bytes;
}

template <class Row>
std::optional<std::vector<Row>> takeRows(ByteSource& source, const std::vector<WrittenChannel>& written,
                                         const std::vector<Channel<Row>>& channels, std::uint64_t most)
{
    const auto count = source.varint();
    if (!count || *count > most) {
        return std::nullopt;
    }
    std::vector<Row> rows(static_cast<std::size_t>(*count));
    for (const WrittenChannel& one : written) {
        const auto column = takeColumn(source, rows.size());
        if (!column) {
            return std::nullopt;
        }
        const auto known = std::ranges::find(channels, one.name.toStdString(), &Channel<Row>::name);
        for (std::size_t i = 0; known != channels.end() && i < rows.size(); ++i) {
            if (const auto& value = (*column)[i]) {
                known->set(rows[i], static_cast<double>(*value) / one.perUnit);
            }
        }
    }
    return source.atEnd() ? std::optional(std::move(rows)) : std::nullopt;
}

}  // namespace

const std::vector<Channel<Tick>>& tickChannels()
{
    static const std::vector<Channel<Tick>> all = makeTickChannels();
    return all;
}

const std::vector<Channel<plan::PlannedMoment>>& planChannels()
{
    static const std::vector<Channel<plan::PlannedMoment>> all = makePlanChannels();
    return all;
}

QByteArray rowBytes(std::span<const Tick> ticks)
{
    return bytesOf(ticks, tickChannels());
}

QByteArray rowBytes(std::span<const plan::PlannedMoment> moments)
{
    return bytesOf(moments, planChannels());
}

std::optional<std::vector<Tick>> takeTicks(ByteSource& source, const std::vector<WrittenChannel>& channels,
                                           std::uint64_t most)
{
    return takeRows(source, channels, tickChannels(), std::min(most, kMostRows));
}

std::optional<std::vector<plan::PlannedMoment>> takeMoments(ByteSource& source,
                                                            const std::vector<WrittenChannel>& channels)
{
    return takeRows(source, channels, planChannels(), kMostRows);
}

}  // namespace boresight::recording
