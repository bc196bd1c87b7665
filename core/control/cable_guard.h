// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "core/tracking/axis_profile.h"
#include "core/tracking/cable_forecast.h"
#include "core/units/sky.h"

#include <QString>

#include <cstdint>
#include <optional>

// The azimuth cable: where it is wound least, whether it ends before a pass does, and that the mount turns back because
// it ends. Reports both in time and decides nothing about motion. Station thread only; mechanical angles.
namespace boresight {

class CableGuard
{
public:
    // The short way would lead beyond an end of the azimuth's range: the mount goes the other way round.
    struct TurnBack
    {
        Angle by;  // signed
        Angle end;
        bool follows = false;  // in the middle of a stream, which it goes on following after it
    };
    // Where a way to another azimuth begins.
    struct Way
    {
        Angle here;
        Angle heading;         // where the axis is going, which chose the turn
        bool follows = false;  // the stream that goes on is the one that is followed already
    };

    CableGuard(AlarmBoard& alarms, const Clock& clock) : m_alarms(alarms), m_clock(clock) {}

    // Of the turns of this direction the one nearest to the cable that is not wound, 0°; empty if it stands there.
    [[nodiscard]] static std::optional<AxisPosition> leastWound(const AxisPosition& place, const TravelRange& range);
    // Empty: the way to `azimuth` is the short one.
    [[nodiscard]] static std::optional<TurnBack> turnBackTo(Angle azimuth, const Way& way, const TravelRange& range);

    // The mount sets off so. The text for the log.
    [[nodiscard]] QString begin(const TurnBack& back, const tracking::MotionLimits& limits);
    void forgetTurnBack() { m_turnBack.reset(); }

    // Once per tick. `path` is followed; `left` is the way of the azimuth to where it is sent. Empty: there is none.
    // `keepsWrap`: the mount waits at the end.
    void watch(const std::optional<tracking::MovingTarget>& path, const std::optional<Angle>& left,
               const TravelRange& range, const tracking::MotionLimits& limits, bool keepsWrap);

    [[nodiscard]] const std::optional<CableEnd>& end() const { return m_end; }  // of what is followed
    // Short, for the line below the state; empty: it does not turn back now.
    [[nodiscard]] std::optional<QString> turnBackText() const;

private:
    // The text of the alarm.
    struct Told
    {
        Severity severity;
        UtcTime ends;
        bool turnsBack;
    };

    void watchEnd(const std::optional<tracking::MovingTarget>& path, const TravelRange& range,
                  const tracking::MotionLimits& limits, bool keepsWrap);
    void watchTurnBack(const std::optional<Angle>& left);
    void tell(const CableEnd& end);
    [[nodiscard]] bool isTold(const Told& end) const;

    AlarmBoard& m_alarms;
    const Clock& m_clock;
    std::optional<CableEnd> m_end;
    std::optional<Told> m_told;
    std::optional<TurnBack> m_turnBack;  // going on now
    std::uint64_t m_ticks = 0;
};

}  // namespace boresight
