// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clients/logged_rotator.h"

namespace boresight {
namespace {

using ActKind = ProtocolAct::Kind;

ActKind moveKind(rotctld::MoveDirection direction)
{
    switch (direction) {
        case rotctld::MoveDirection::Up:
            return ActKind::MoveUp;
        case rotctld::MoveDirection::Down:
            return ActKind::MoveDown;
        case rotctld::MoveDirection::Left:
            return ActKind::MoveLeft;
        case rotctld::MoveDirection::Right:
            break;
    }
    return ActKind::MoveRight;
}

}  // namespace

void LoggedRotator::note(const ProtocolAct& act) const
{
    if (m_log.isOn()) {
        m_log.note(act);
    }
}

Result<SkyPointing> LoggedRotator::position(const rotctld::Client& client)
{
    note({.kind = ActKind::AskPosition});
    return m_rotator.position(client);
}

Result<SkyPointing> LoggedRotator::target() const
{
    note({.kind = ActKind::AskTarget});
    return m_rotator.target();
}

rotctld::MotionFlags LoggedRotator::motion() const
{
    note({.kind = ActKind::AskMotion});
    return m_rotator.motion();
}

Result<QString> LoggedRotator::pointTo(const rotctld::Client& client, const rotctld::PointRequest& request)
{
    note({.kind = ActKind::Point, .azimuth = request.azimuth, .elevation = request.elevation});
    return m_rotator.pointTo(client, request);
}

Result<> LoggedRotator::move(const rotctld::Client& client, rotctld::MoveDirection direction, int speed)
{
    note({.kind = moveKind(direction)});
    return m_rotator.move(client, direction, speed);
}

Result<QString> LoggedRotator::moveAt(const rotctld::Client& client, rotctld::MoveDirection direction, AngularRate rate)
{
    note({.kind = moveKind(direction)});
    return m_rotator.moveAt(client, direction, rate);
}

Result<> LoggedRotator::stop(const rotctld::Client& client)
{
    note({.kind = ActKind::Stop});
    return m_rotator.stop(client);
}

Result<> LoggedRotator::park(const rotctld::Client& client)
{
    note({.kind = ActKind::Park});
    return m_rotator.park(client);
}

Result<> LoggedRotator::reset(const rotctld::Client& client, int kind)
{
    note({.kind = ActKind::Reset});
    return m_rotator.reset(client, kind);
}

Result<> LoggedRotator::setSpeedLevel(const rotctld::Client& client, int level)
{
    note({.kind = ActKind::SetSpeed, .level = level});
    return m_rotator.setSpeedLevel(client, level);
}

}  // namespace boresight
