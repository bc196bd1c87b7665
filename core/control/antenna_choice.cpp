// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/antenna_choice.h"

#include "core/base/text.h"

#include <QStringList>

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

// The name of the antenna in `after`. If only names were changed, the place in the list identifies the antenna.
std::string nameIn(const profile::Profile& after, const profile::Profile& before, const std::string& name)
{
    const auto old = std::ranges::find(before.antennas, name, &pointing::Antenna::name);
    const bool isSameList = before.antennas.size() == after.antennas.size();
    if (old == before.antennas.end() || !isSameList || after.antenna(name).name == name) {
        return name;
    }
    return after.antennas[static_cast<std::size_t>(old - before.antennas.begin())].name;
}

}  // namespace

AntennaChoice::AntennaChoice(const profile::InForce& profile, EventLog& log, std::function<void()> changed)
    : m_profile(profile), m_log(log), m_changed(std::move(changed)), m_inUse(profile->antenna(m_chosen))
{}

Angle AntennaChoice::spread() const
{
    Angle widest;
    for (const pointing::Antenna& one : m_profile->allAntennas()) {
        widest = std::max(widest, pointing::beamDistance(one, m_inUse));
    }
    return widest;
}

Result<> AntennaChoice::isKnown(const std::string& name) const
{
    QStringList names;
    for (const pointing::Antenna& one : m_profile->allAntennas()) {
        if (one.name == name) {
            return {};
        }
        names << QStringLiteral("\"%1\"").arg(toQString(one.name));
    }
    return failure(ErrorCode::InvalidInput, Text::tr("There is no antenna \"%1\". The profile has %2.")
                                                .arg(toQString(name), names.join(QStringLiteral(", "))));
}

Result<> AntennaChoice::choose(const std::string& name)
{
    return isKnown(name).map([&] {
        m_chosen = name;
        if (m_tracked) {
            m_tracked->satellite.reset();
        }
        renew();
    });
}

void AntennaChoice::track(const std::optional<Tracked>& tracked)
{
    m_tracked = tracked;
    renew();
}

void AntennaChoice::endTracking()
{
    if (m_tracked) {
        m_tracked->isOver = true;
    }
}

void AntennaChoice::release()
{
    if (m_tracked && m_tracked->isOver) {
        track({});
    }
}

void AntennaChoice::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    m_chosen = nameIn(after, before, m_chosen);
    renew();
}

std::string AntennaChoice::wanted(const profile::Profile& by) const
{
    const std::string own =
        m_tracked && m_tracked->satellite ? orbit::antennaOf(by.satellites, *m_tracked->satellite) : std::string();
    return own.empty() ? nameIn(by, *m_profile, m_chosen) : own;
}

void AntennaChoice::renew()
{
    const pointing::Antenna before = std::exchange(m_inUse, m_profile->antenna(wanted(*m_profile)));
    if (m_inUse.name != before.name) {
        m_log.add(Severity::Advisory, QStringLiteral("station"),
                  Text::tr("antenna \"%1\" is in use").arg(toQString(m_inUse.name)));
    }
    if (m_inUse != before) {
        m_changed();
    }
}

}  // namespace boresight
