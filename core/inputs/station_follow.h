// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/station_control.h"
#include "core/followed_rotctld/followed_rotctld.h"
#include "core/profile/in_force.h"

#include <QObject>

#include <cstdint>
#include <functional>

// Connects to the rotctld of another rotator that the mount follows, or will follow after its first position. Its
// reports go to the control. Station thread only.
namespace boresight {

class StationFollow : public QObject
{
    Q_OBJECT

public:
    // Receives the name of the rotator that has reported a position, or the reason why there is none. Returns whether
    // the mount follows this rotator now.
    using Then = std::function<Result<>(const Result<QString>& found)>;

    // All arguments but the parent outlive this.
    StationFollow(StationControl& control, const profile::InForce& profile, const Clock& clock, QObject* parent);

    // `name` is "rotctld:HOST:PORT". `then` is called once. Until then the mount still follows another rotator.
    void find(const QString& name, Then then);
    // The mount got another command: the request that waits is refused.
    void forget();
    // As forget(). The mount also stops following.
    void close();
    void tick();

private:
    [[nodiscard]] Result<BusName> otherRotctld(const QString& name) const;
    void takeFirst(const RotatorReport& report);
    void takeNext(const RotatorReport& report);
    void answer(const Result<QString>& found);
    void drop(rotctl::FollowedRotctld*& one);

    StationControl& m_control;
    const profile::InForce& m_profile;
    const Clock& m_clock;
    rotctl::FollowedRotctld* m_followed = nullptr;  // m_followed and m_wanted are children of this
    rotctl::FollowedRotctld* m_wanted = nullptr;
    Then m_then;                   // empty: no request waits
    std::uint64_t m_motionId = 0;  // motion id of the mount at the time of the request
};

}  // namespace boresight
