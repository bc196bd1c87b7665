// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/replay_tape.h"

#include "core/recording/record_reader.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace boresight::ui {

namespace {

struct TapeWords
{
    Q_DECLARE_TR_FUNCTIONS(ReplayTape)
};

constexpr UtcTime::duration kWayStep = std::chrono::seconds(1);
constexpr qsizetype kMostShown = 3;  // of the parts that are damaged
constexpr auto kUtcOf = [](const auto& one) { return one.utc; };

}  // namespace

ReplayTape::ReplayTape(recording::Recording record)
    : m_record(std::move(record)), m_begin(m_record.header.began), m_end(m_begin)
{
    addGaps();
    addRemarks();
    // The clock of the computer may have been set back during the pass.
    std::ranges::stable_sort(m_record.ticks, {}, kUtcOf);
    std::ranges::stable_sort(m_record.events, {}, kUtcOf);
    findSpan();
    findWay();
}

void ReplayTape::findSpan()
{
    const auto& ticks = m_record.ticks;
    const auto& events = m_record.events;
    if (!ticks.empty()) {
        m_begin = ticks.front().utc;
        m_end = ticks.back().utc;
    } else if (!events.empty()) {
        m_begin = events.front().utc;
        m_end = events.back().utc;
    }
}

void ReplayTape::addGaps()
{
    for (const recording::Gap& gap : m_record.gaps) {
        m_record.events.push_back(
            {.utc = gap.from,
             .kind = recording::EventKind::Event,
             .level = recording::EventLevel::Warning,
             .source = QStringLiteral("station"),
             .text = TapeWords::tr("%1 ticks were not recorded. The disk was too slow or full.").arg(gap.ticks)});
    }
}

void ReplayTape::addRemarks()
{
    // The reader counts a missing end as a problem, too.
    if (!m_record.hasEnd && m_record.problems.size() <= 1) {
        m_remarks << TapeWords::tr(
            "The recording has no end mark. The replay ends with the last whole block. Boresight "
            "still writes the file, or was interrupted.");
    } else if (!m_record.problems.isEmpty()) {
        m_remarks << TapeWords::tr("The file is damaged. The replay has everything that could be read:");
        const QStringList& problems = m_record.problems;
        for (const QString& problem : problems.first(std::min(kMostShown, problems.size()))) {
            m_remarks << problem + QLatin1Char('.');
        }
        if (problems.size() > kMostShown) {
            m_remarks << TapeWords::tr("Further damage: %1.").arg(problems.size() - kMostShown);
        }
    }
    if (m_record.ticks.empty()) {
        m_remarks << TapeWords::tr("The recording has no ticks, so sky and charts are empty.");
    }
}

void ReplayTape::findWay()
{
    std::vector<targets::SkyMoment> moments;
    for (const recording::Tick& tick : m_record.ticks) {
        if (tick.target && (moments.empty() || tick.utc - moments.back().utc >= kWayStep)) {
            moments.push_back({.utc = tick.utc, .direction = *tick.target});
        }
    }
    if (!moments.empty()) {
        m_way = std::make_shared<const std::vector<targets::SkyMoment>>(std::move(moments));
    }
}

std::size_t ReplayTape::ticksUntil(UtcTime utc) const
{
    return static_cast<std::size_t>(std::ranges::upper_bound(m_record.ticks, utc, {}, kUtcOf) - m_record.ticks.begin());
}

const recording::Tick* ReplayTape::tickAt(UtcTime utc) const
{
    const std::size_t until = ticksUntil(utc);
    return until == 0 ? nullptr : &m_record.ticks[until - 1];
}

std::optional<std::size_t> ReplayTape::eventAt(UtcTime utc) const
{
    const auto after = std::ranges::upper_bound(m_record.events, utc, {}, kUtcOf);
    return after == m_record.events.begin()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(after - m_record.events.begin()) - 1);
}

std::optional<std::size_t> ReplayTape::motionStartAt(UtcTime utc, std::optional<std::size_t> below) const
{
    const auto newest = eventAt(utc);
    for (std::size_t i = std::min(newest ? *newest + 1 : 0, below.value_or(m_record.events.size())); i > 0; --i) {
        if (m_record.events[i - 1].kind == recording::EventKind::MotionStart) {
            return i - 1;
        }
    }
    return std::nullopt;
}

Result<SharedTape> loadTape(const QString& path)
{
    auto record = recording::loadRecording(path);
    if (!record) {
        return tl::unexpected(record.error());
    }
    return std::make_shared<const ReplayTape>(*std::move(record));
}

}  // namespace boresight::ui
