// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recordings/recording_table.h"

#include "app/boresightctl/sky_time.h"
#include "core/base/numbers.h"
#include "core/pass_report/pass_summary.h"
#include "core/plan/pass_plan.h"
#include "core/recording/channel.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace boresight::ctl {
namespace {

using recording::Recording;
using recording::Tick;
using TickChannel = recording::Channel<Tick>;

constexpr std::string_view kWordUnit = "word";
constexpr std::string_view kTimeChannel = "utc";

// "azimuth.rate" in "deg/s" is the column "azimuth_rate_deg_s".
std::string columnName(const TickChannel& channel)
{
    if (channel.name == kTimeChannel) {
        return "t_utc";
    }
    std::string name = channel.unit == kWordUnit ? channel.name : channel.name + '_' + channel.unit;
    std::ranges::replace_if(
        name, [](char c) { return c == '.' || c == '/'; }, '_');
    return name;
}

// A table refers to the names of its columns.
const std::vector<std::string>& tickColumnNames()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> made;
        for (const TickChannel& channel : recording::tickChannels()) {
            made.push_back(columnName(channel));
        }
        return made;
    }();
    return names;
}

std::string wordCell(const Recording& pass, const TickChannel& channel, double value)
{
    const int number = static_cast<int>(value);
    const recording::Header& header = pass.header;
    return (channel.name == "state" ? header.stateWord(number) : header.axisWord(number)).toStdString();
}

std::string tickCell(const Recording& pass, const Tick& tick, const TickChannel& channel)
{
    if (channel.name == kTimeChannel) {
        return skyTimeCell(tick.utc);
    }
    const auto value = channel.get(tick);
    if (!value) {
        return {};
    }
    return channel.unit == kWordUnit ? wordCell(pass, channel, *value)
                                     : formatFixed(*value, static_cast<int>(std::lround(std::log10(channel.perUnit))));
}

std::string recordedDegrees(Angle angle)
{
    return formatFixed(angle.degrees(), 4);
}

std::string kindCell(recording::EventKind kind)
{
    switch (kind) {
        case recording::EventKind::MotionStart:
            return "motion";
        case recording::EventKind::Alarm:
            return "alarm";
        case recording::EventKind::ClientLine:
            return "client";
        case recording::EventKind::Event:
            break;
    }
    return "event";
}

std::string levelCell(recording::EventLevel level)
{
    switch (level) {
        case recording::EventLevel::Alarm:
            return "alarm";
        case recording::EventLevel::Warning:
            return "warning";
        case recording::EventLevel::Advisory:
            break;
    }
    return "advisory";
}

// The error of the beam after its first second on target, as in the report. Empty: no tick has an error.
std::optional<pass_report::ErrorSummary> errorOfBeam(const Recording& pass)
{
    const auto summary = pass_report::summaryOf(pass);
    return summary ? summary->error : std::nullopt;
}

QString directionWords(const std::optional<SkyPointing>& direction)
{
    return direction ? QStringLiteral("azimuth %1, elevation %2")
                           .arg(azimuthText(direction->azimuth, 2), degreesText(direction->elevation, 2))
                     : QStringLiteral("position unknown");
}

QString statusLine(const Recording& pass, const Tick& tick)
{
    QString line = QStringLiteral("%1  %2  %3")
                       .arg(QString::fromStdString(skyTimeText(tick.utc, 1)), pass.header.stateWord(tick.state),
                            directionWords(tick.actual));
    if (tick.target) {
        line += QStringLiteral("  target %1 %2")
                    .arg(azimuthText(tick.target->azimuth, 2), degreesText(tick.target->elevation, 2));
    }
    return tick.error ? line + QStringLiteral("  off by ") + degreesText(*tick.error, 3) : line;
}

QString eventLine(const recording::Event& event)
{
    return QStringLiteral("%1  %2: %3")
        .arg(QString::fromStdString(skyTimeText(event.utc, 1)), event.source, event.text);
}

}  // namespace

RecordTable tickTable(const Recording& pass, std::size_t first, std::size_t count)
{
    const std::vector<TickChannel>& channels = recording::tickChannels();
    RecordTable table;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const bool isText = channels[i].name == kTimeChannel || channels[i].unit == kWordUnit;
        table.columns.push_back({tickColumnNames()[i], !isText});
    }
    const std::span ticks = std::span(pass.ticks).subspan(first, std::min(count, pass.ticks.size() - first));
    for (const Tick& tick : ticks) {
        auto& row = table.rows.emplace_back();
        for (const TickChannel& channel : channels) {
            row.push_back(tickCell(pass, tick, channel));
        }
    }
    return table;
}

RecordTable eventTable(const Recording& pass)
{
    RecordTable table{.columns = {{"t_utc"}, {"kind"}, {"level"}, {"source"}, {"text"}}};
    for (const recording::Event& event : pass.events) {
        table.rows.push_back({skyTimeCell(event.utc), kindCell(event.kind), levelCell(event.level),
                              event.source.toStdString(), event.text.toStdString()});
    }
    return table;
}

RecordTable plannedTable(const Recording& pass)
{
    RecordTable table{.columns = {{"t_utc"},
                                  {"az_deg", true},
                                  {"el_deg", true},
                                  {"target_az_deg", true},
                                  {"target_el_deg", true},
                                  {"error_deg", true},
                                  {"hidden"}}};
    for (const plan::PlannedMoment& moment : pass.plan.value_or(plan::PlanVariant{}).moments) {
        table.rows.push_back({skyTimeCell(moment.utc), recordedDegrees(moment.axes.azimuth),
                              recordedDegrees(moment.axes.elevation), recordedDegrees(moment.target.azimuth),
                              recordedDegrees(moment.target.elevation), recordedDegrees(moment.error),
                              moment.isHidden ? "yes" : "no"});
    }
    return table;
}

RecordTable aboutTable(const Recording& pass)
{
    const recording::Header& header = pass.header;
    const auto timeCell = [&pass](bool isLast) {
        return pass.ticks.empty() ? std::string()
                                  : skyTimeCell(isLast ? pass.ticks.back().utc : pass.ticks.front().utc);
    };
    const auto error = errorOfBeam(pass);
    return {.columns = {{"key"}, {"value"}},
            .rows = {{"program", header.program.toStdString()},
                     {"mount", header.mount.toStdString()},
                     {"simulated", header.isSimulated ? "yes" : "no"},
                     {"latitude_deg", header.site ? recordedDegrees(header.site->latitude) : std::string()},
                     {"longitude_deg", header.site ? recordedDegrees(header.site->longitude) : std::string()},
                     {"height_m", header.site ? formatFixed(header.site->heightMetres, 1) : std::string()},
                     {"beam_width_deg", formatFixed(header.beamWidth.degrees(), 2)},
                     {"target", header.target.toStdString()},
                     {"norad", header.number ? std::to_string(*header.number) : std::string()},
                     {"client", header.client.toStdString()},
                     {"part", std::to_string(header.part)},
                     {"first_tick_utc", timeCell(false)},
                     {"last_tick_utc", timeCell(true)},
                     {"ticks", std::to_string(pass.ticks.size())},
                     {"lost_ticks", std::to_string(pass_report::lostTicks(pass))},
                     {"events", std::to_string(pass.events.size())},
                     {"plan", pass.plan ? plan::keyOf(pass.plan->way).toStdString() : std::string()},
                     {"error_rms_deg", error ? recordedDegrees(error->rms) : std::string()},
                     {"error_peak_deg", error ? recordedDegrees(error->peak) : std::string()},
                     {"complete", pass.hasEnd && pass.problems.isEmpty() ? "yes" : "no"}}};
}

std::vector<ReplayLine> replayLines(const Recording& pass)
{
    std::vector<ReplayLine> lines;
    if (pass.ticks.empty()) {
        return lines;
    }
    const UtcTime begin = pass.ticks.front().utc;
    const auto after = [begin](UtcTime utc) { return std::max(Seconds(utc - begin), Seconds(0.0)); };
    UtcTime next = begin;
    for (const Tick& tick : pass.ticks) {
        if (tick.utc >= next) {
            lines.push_back({after(tick.utc), statusLine(pass, tick)});
            next = tick.utc + std::chrono::milliseconds(990);  // a tick may come early by half of its period
        }
    }
    for (const recording::Event& event : pass.events) {
        lines.push_back({after(event.utc), eventLine(event)});
    }
    for (const recording::Gap& gap : pass.gaps) {
        lines.push_back({after(gap.from), QStringLiteral("%1  %2 ticks are missing")
                                              .arg(QString::fromStdString(skyTimeText(gap.from, 1)))
                                              .arg(gap.ticks)});
    }
    std::ranges::stable_sort(lines, {}, &ReplayLine::at);
    return lines;
}

}  // namespace boresight::ctl
