// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_follow.h"

#include "core/base/text.h"
#include "core/profile/setting.h"

#include <QHostInfo>
#include <QNetworkInterface>

#include <utility>

namespace boresight {
namespace {

// Whether this is the name or an address of this computer.
bool isThisComputer(const QString& host)
{
    const QHostAddress address(host);
    return host.compare(QHostInfo::localHostName(), Qt::CaseInsensitive) == 0 ||
           (!address.isNull() && QNetworkInterface::allAddresses().contains(address));
}

bool isOwn(const BusName& rotctld, const profile::ListenAddress& own)
{
    return profile::isOwnServer(rotctld, own) ||
           (rotctld.port == own.port && isThisComputer(QString::fromStdString(rotctld.target)));
}

}  // namespace

StationFollow::StationFollow(StationControl& control, const profile::InForce& profile, const Clock& clock,
                             QObject* parent)
    : QObject(parent), m_control(control), m_profile(profile), m_clock(clock)
{}

Result<BusName> StationFollow::otherRotctld(const QString& name) const
{
    const auto bus = parseBusName(name.toStdString());
    if (!bus || bus->kind != BusKind::Rotctld) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("\"%1\" names no rotctld. Write rotctld:HOST:PORT, for example rotctld:10.0.0.7:4533.").arg(name));
    }
    if (isOwn(*bus, m_profile->rotctld.listen)) {
        return failure(
            ErrorCode::Refused,
            Text::tr("%1 is the server of Boresight itself. Name the rotctld of another rotator.").arg(name));
    }
    if (parseBusName(m_profile->bus) == bus) {
        return failure(ErrorCode::Refused,
                       Text::tr("%1 turns this mount. Name the rotctld of another rotator.").arg(name));
    }
    return *bus;
}

void StationFollow::find(const QString& name, Then then)
{
    forget();
    m_then = std::move(then);
    const Result<BusName> rotctld = otherRotctld(name);
    if (!rotctld) {
        answer(tl::unexpected(rotctld.error()));
        return;
    }
    m_motionId = m_control.motionId();
    m_wanted = new rotctl::FollowedRotctld(*rotctld, m_clock.now(), this);
    connect(m_wanted, &rotctl::FollowedRotctld::read, this, &StationFollow::takeFirst);
}

void StationFollow::takeFirst(const RotatorReport& report)
{
    if (!report.direction) {
        drop(m_wanted);
        answer(tl::unexpected(report.direction.error()));
        return;
    }
    (void)m_control.receive(report);
    rotctl::FollowedRotctld* found = std::exchange(m_wanted, nullptr);
    found->disconnect(this);
    if (std::exchange(m_then, {})(report.name)) {
        drop(m_followed);
        m_followed = found;
        connect(m_followed, &rotctl::FollowedRotctld::read, this, &StationFollow::takeNext);
    } else {
        drop(found);
    }
}

void StationFollow::takeNext(const RotatorReport& report)
{
    if (!m_control.receive(report) || !report.direction) {
        drop(m_followed);
    }
}

void StationFollow::forget()
{
    drop(m_wanted);
    answer(
        failure(ErrorCode::Refused, Text::tr("Another command came before the rotctld had answered. Track it again.")));
}

void StationFollow::close()
{
    forget();
    drop(m_followed);
}

// A different motion id shows that another command has moved the mount meanwhile.
void StationFollow::tick()
{
    if (m_wanted && m_control.motionId() != m_motionId) {
        forget();
    }
    if (m_wanted) {
        m_wanted->tick(m_clock.now());
    }
    if (m_followed) {
        m_followed->tick(m_clock.now());
    }
}

// m_then is cleared first, because the callback may request another rotator.
void StationFollow::answer(const Result<QString>& found)
{
    if (const Then then = std::exchange(m_then, {})) {
        (void)then(found);
    }
}

// Deletes later, because this may run inside a signal of the object.
void StationFollow::drop(rotctl::FollowedRotctld*& one)
{
    if (one) {
        one->disconnect(this);
        std::exchange(one, nullptr)->deleteLater();
    }
}

}  // namespace boresight

#include "moc_station_follow.cpp"
