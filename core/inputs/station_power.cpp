// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_power.h"

namespace boresight {
namespace {

const QString kPowerSource = QStringLiteral("power");
constexpr int kPowerLinesPerSecond = 2;

}  // namespace

StationPower::StationPower(const profile::InForce& profile, const Clock& clock, EventLog& log, QObject* parent)
    : QObject(parent), m_profile(profile), m_clock(clock), m_lines(log, clock, kPowerLinesPerSecond)
{}

void StationPower::open()
{
    close();
    m_open = true;
    const profile::PowerSettings& settings = m_profile->power;
    if (settings.source == profile::PowerSource::None) {
        return;
    }
    m_line = std::make_unique<power::ThreadedLine>(
        power::LineSettings{
            .transport = settings.source == profile::PowerSource::Udp ? power::Transport::Udp : power::Transport::Tcp,
            .host = QString::fromStdString(settings.host),
            .port = static_cast<std::uint16_t>(settings.port)},
        m_clock, this);
    connect(m_line.get(), &power::ThreadedLine::received, this, &StationPower::received);
}

void StationPower::close()
{
    m_open = false;
    m_line.reset();
    m_problem.clear();
}

void StationPower::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (m_open && before.power != after.power) {
        open();
    }
}

PowerLineStatus StationPower::tick()
{
    if (!m_line) {
        return {};
    }
    const power::LineState& state = m_line->state();
    PowerLineStatus status{
        .name = m_line->name(), .problem = m_line->problem(), .values = state.values, .refused = state.refused};
    if (state.last) {
        status.decibels = state.last->decibels;
        status.age = m_clock.now() - state.last->arrival;
    }
    if (status.problem != m_problem) {
        m_problem = status.problem;
        if (!m_problem.isEmpty()) {
            m_lines.add(Severity::Warning, kPowerSource, m_problem);
        }
    }
    return status;
}

}  // namespace boresight

#include "moc_station_power.cpp"
