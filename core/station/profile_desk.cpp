// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/profile_desk.h"

#include "core/base/text.h"
#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace boresight {
namespace {

QString operatorName()
{
    return QStringLiteral("operator");
}

}  // namespace

ProfileDesk::ProfileDesk(profile::InForce& profile, bool simulated, EventLog& log, Applied applied)
    : m_profile(profile), m_simulated(simulated), m_log(log), m_applied(std::move(applied))
{}

Result<> ProfileDesk::carryOut(const request::ApplyProfile& request)
{
    return fits(request.profile).map([&] { put(request.profile); });
}

Result<> ProfileDesk::carryOut(const request::Reconnect& request)
{
    return mayConnect(request.profile).map([&] {
        m_log.add(Severity::Advisory, operatorName(),
                  Text::tr("reconnects to the mount \"%1\"").arg(QString::fromStdString(request.profile.mount.name)));
        m_next = request.profile;
    });
}

void ProfileDesk::apply(const CalibrationChange& change)
{
    profile::Profile wanted = m_profile.wanted();
    change.applyTo(wanted);
    put(wanted);
}

void ProfileDesk::reportReading(const Result<>& taken)
{
    const QString source = QStringLiteral("station");
    if (!taken) {
        m_log.add(Severity::Warning, source,
                  Text::tr("the profile was not applied, so the previous profile stays in force: %1")
                      .arg(taken.error().text));
        return;
    }
    QStringList waiting;
    std::ranges::transform(m_profile.waitingKeys(), std::back_inserter(waiting), toQString);
    m_log.add(waiting.isEmpty() ? Severity::Advisory : Severity::Warning, source,
              waiting.isEmpty() ? Text::tr("the profile was read again and is in force")
                                : Text::tr("the profile was read again. These settings wait for a restart: %1")
                                      .arg(waiting.join(QStringLiteral(", "))));
}

// Whether the connected mount permits this profile in place of the one in force.
Result<> ProfileDesk::fits(const profile::Profile& wanted) const
{
    if (profile::namesNoBus(wanted) != profile::namesNoBus(*m_profile)) {
        return failure(ErrorCode::Refused,
                       Text::tr("The bus cannot change between simulated and real while the mount is connected. "
                                "Press Reconnect, or restart Boresight."));
    }
    return m_simulated ? Result<>{} : profile::fitsRealMount(wanted);
}

// After a simulation the program itself provides a profile for the real mount, so nothing is checked then.
Result<> ProfileDesk::mayConnect(const profile::Profile& next) const
{
    return m_simulated || profile::namesNoBus(next) ? Result<>{} : profile::fitsRealMount(next);
}

void ProfileDesk::put(const profile::Profile& wanted)
{
    for (const profile::Change& change : profile::changesBetween(m_profile.wanted(), wanted)) {
        m_log.add(
            Severity::Advisory, operatorName(),
            (change.applies == profile::Applies::Now ? Text::tr("changes %1 from %2 to %3")
                                                     : Text::tr("changes %1 from %2 to %3, in force after Reconnect"))
                .arg(toQString(change.key), change.before, change.after));
    }
    const std::shared_ptr<const profile::Profile> before = m_profile.shared();
    m_profile.apply(wanted);
    m_applied(*before, wanted);
}

}  // namespace boresight
