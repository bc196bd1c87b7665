// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/station_control.h"
#include "core/followed_rotctld/followed_rotctld.h"
#include "core/profile/in_force.h"

#include <QObject>

#include <cstdint>
#include <functional>

// The rotctld of another rotator that the mount follows, or shall follow once it has reported where it is. What it
// reports goes to the control. Station thread only.
namespace boresight {

class StationFollow : public QObject
{
    Q_OBJECT

public:
    // Gets the name of the rotator that has reported a position, or why there is none. Its own result: whether the
    // mount follows that one now.
    using Then = std::function<Result<>(const Result<QString>& found)>;

    // They outlive this.
    StationFollow(StationControl& control, const profile::InForce& profile, const Clock& clock, QObject* parent);

    // "rotctld:HOST:PORT". `then` is called once. One that is followed is followed until then.
    void find(const QString& name, Then then);
    // The mount was asked for something else meanwhile: who waits is refused.
    void forget();
    // The same, and nobody is followed.
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
    rotctl::FollowedRotctld* m_followed = nullptr;  // both belong to this
    rotctl::FollowedRotctld* m_wanted = nullptr;
    Then m_then;                   // empty: nobody waits
    std::uint64_t m_motionId = 0;  // of the mount, when it was asked for
};

}  // namespace boresight
