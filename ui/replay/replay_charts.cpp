// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/replay_charts.h"

#include "ui/replay/recorded_status.h"

#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace boresight::ui {

namespace {

constexpr std::chrono::minutes kLongestChart{30};
constexpr UtcTime::duration kKept = TelemetryStore::kBin * PeakRing::kBins;

}  // namespace

SteadyTime ReplayClock::now() const
{
    return steadyTimeOf(m_utc);
}

ReplayCharts::ReplayCharts(SharedTape tape, QWidget* parent)
    : QWidget(parent), m_tape(std::move(tape)), m_charts(new StripCharts(m_clock, this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_charts);
    m_charts->setRecorded();
}

void ReplayCharts::show(const StationStatus& status)
{
    m_clock.setMoment(status.utc);
    const std::size_t needed = m_tape->ticksUntil(status.utc - kLongestChart);
    const std::size_t kept =
        m_until == 0 ? 0 : std::max(m_first, m_tape->ticksUntil(m_tape->ticks()[m_until - 1].utc - kKept));
    if (needed < kept) {
        m_charts->clear();
        m_first = needed;
        m_until = needed;
    }
    fill(m_tape->ticksUntil(status.utc));
    m_charts->showStatus(status);
}

void ReplayCharts::fill(std::size_t until)
{
    if (until <= m_until) {
        return;
    }
    std::vector<TickSample> samples;
    samples.reserve(until - m_until);
    for (; m_until < until; ++m_until) {
        samples.push_back(recordedSample(m_tape->ticks()[m_until]));
    }
    m_charts->add(samples);
}

}  // namespace boresight::ui

#include "moc_replay_charts.cpp"
