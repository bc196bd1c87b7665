// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "core/tracking/axis_setpoints.h"
#include "core/tracking/cable_forecast.h"
#include "core/units/sky.h"

#include <QString>

#include <cstdint>
#include <optional>

// The azimuth cable: which wrap of a direction winds the cable least, whether the cable ends before the target does,
// and whether the mount unwraps now. Only reports, and decides nothing about motion. Station thread only; mechanical
// angles.
namespace boresight {

class CableGuard
{
public:
    // The short way would lead beyond an end of the azimuth travel, so the mount goes the other way round.
    struct TurnBack
    {
        Angle by;  // the way of the axis, signed
        Angle end;
        bool follows = false;  // the mount tracks a stream, and continues with it afterwards
    };
    // Where the way to another azimuth begins.
    struct Way
    {
        Angle here;
        Angle heading;         // this angle chose the wrap: where the axis is going, or can stop
        bool follows = false;  // the stream is the one that the mount tracks already
    };

    CableGuard(AlarmBoard& alarms, const Clock& clock) : m_alarms(alarms), m_clock(clock) {}

    // The wrap of this direction on which the cable is wound least: the one nearest to 0°. Empty: `place` is on it
    // already.
    [[nodiscard]] static std::optional<AxisPosition> leastWound(const AxisPosition& place, const TravelRange& range);
    // Empty: the short way to `azimuth` is possible.
    [[nodiscard]] static std::optional<TurnBack> turnBackTo(Angle azimuth, const Way& way, const TravelRange& range);

    // The mount begins to unwrap. Returns the text for the log.
    [[nodiscard]] QString begin(const TurnBack& back, const tracking::MotionLimits& limits);
    void forgetTurnBack() { m_turnBack.reset(); }

    // Beyond this end of the range the cable can be unwrapped by 360°.
    [[nodiscard]] static bool hasOtherWrap(Angle end, const TravelRange& range);

    // Once per tick. `path` is the path that is tracked. `left` is the angle that the azimuth has yet to go. Empty:
    // there is no such path or angle. `keepsWrap`: the operator chose to wait at the end of the cable. `heldAt`: the
    // end where the mount waits now. Empty: it does not.
    void watch(const std::optional<tracking::MovingTarget>& path, const std::optional<Angle>& left,
               const TravelRange& range, const tracking::MotionLimits& limits, bool keepsWrap,
               const std::optional<Angle>& heldAt);

    [[nodiscard]] const std::optional<CableEnd>& end() const
    {
        return m_end;
    }  // of the cable, on the path that is tracked
    // Short text for the line below the state. Empty: the mount does not unwrap now.
    [[nodiscard]] std::optional<QString> turnBackText() const;

private:
    // The present content of the alarm.
    struct Told
    {
        Severity severity;
        UtcTime ends;
        const AlarmEntry* entry;
    };

    void watchEnd(const std::optional<tracking::MovingTarget>& path, const TravelRange& range,
                  const tracking::MotionLimits& limits, bool keepsWrap);
    void holdAt(Angle end, bool isChosen);
    void watchTurnBack(const std::optional<Angle>& left);
    void tell(const CableEnd& end, bool holdIsChosen);
    [[nodiscard]] bool isTold(const Told& end) const;

    AlarmBoard& m_alarms;
    const Clock& m_clock;
    std::optional<CableEnd> m_end;
    std::optional<Told> m_told;
    std::optional<TurnBack> m_turnBack;  // the unwrapping that is under way
    std::uint64_t m_ticks = 0;
};

}  // namespace boresight
