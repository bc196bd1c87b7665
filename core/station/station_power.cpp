// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_power.h"

namespace boresight {
namespace {

const QString kPowerSource = QStringLiteral("power");
constexpr int kPowerLinesPerSecond = 2;

}  // namespace

StationPower::StationPower(const profile::PowerSettings& settings, const Clock& clock, EventLog& log, QObject* parent)
    : QObject(parent), m_settings(settings), m_clock(clock), m_lines(log, clock, kPowerLinesPerSecond)
{}

void StationPower::open()
{
    close();
    m_open = true;
    if (m_settings.source == profile::PowerSource::None) {
        return;
    }
    m_line = std::make_unique<power::ThreadedLine>(
        power::LineSettings{
            .transport = m_settings.source == profile::PowerSource::Udp ? power::Transport::Udp : power::Transport::Tcp,
            .host = QString::fromStdString(m_settings.host),
            .port = static_cast<std::uint16_t>(m_settings.port)},
        m_clock, this);
    connect(m_line.get(), &power::ThreadedLine::received, this, &StationPower::received);
}

void StationPower::close()
{
    m_open = false;
    m_line.reset();
    m_problem.clear();
}

void StationPower::apply(const profile::PowerSettings& settings)
{
    if (settings == m_settings) {
        return;
    }
    m_settings = settings;
    if (m_open) {
        open();
    }
}

power::LineStatus StationPower::tick()
{
    if (!m_line) {
        return {};
    }
    power::LineStatus status = m_line->status();
    if (status.problem != m_problem) {
        m_problem = status.problem;
        if (!m_problem.isEmpty()) {
            m_lines.add(Severity::Warning, kPowerSource, m_problem);
        }
    }
    return status;
}

}  // namespace boresight
