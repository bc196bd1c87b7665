// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/control/cable_guard.h"
#include "core/control/control_parts.h"
#include "core/control/first_moves_guard.h"
#include "core/control/gates.h"
#include "core/control/source_log.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

// Every source of motion goes through this class to move the mount. Each function that starts a motion passes the
// gates first, so no source can omit them. Station thread only; mechanical angles.
namespace boresight {

class Helm
{
public:
    // The parts that a motion changes when it starts or ends.
    struct Parts
    {
        Motion& motion;
        MountDriver& mount;
        CurrentMotion& current;
        Arming& arming;
        ClientControl& clientControl;
        CableGuard& cable;
        FirstMovesGuard& firstMoves;
        SourceLog& log;
        AlarmBoard& alarms;
        AntennaChoice& antenna;
    };

    // `view` is asked each time, because the time of the tick is a part of what it gives.
    Helm(const Parts& parts, std::function<ControlParts()> view) : m_of(parts), m_view(std::move(view)) {}

    // To read from.
    [[nodiscard]] ControlParts view() const { return m_view(); }
    [[nodiscard]] const CurrentMotion& current() const { return m_of.current; }
    [[nodiscard]] SteadyTime now() const { return view().now; }
    [[nodiscard]] AxisPosition standing() const { return view().standing(); }
    [[nodiscard]] AxisPosition heading() const { return view().heading(); }
    // The direction that the beam has there, in words: an azimuth from 0° to 360°.
    [[nodiscard]] QString directionText(const AxisPosition& place) const;

    // May this source send the mount anywhere? Every goTo and streamTo asks it, too.
    [[nodiscard]] Result<> mayPoint(const Source& by) const { return Gates(view()).mayPoint(by); }
    // A place is permitted, and there is a way.
    [[nodiscard]] Result<> mayGoTo(const AxisPosition& place) const;
    // The axes of a direction, on the wrap nearest to where they are going; an error when they do not reach it.
    [[nodiscard]] Result<AxisPosition> placeOf(const SkyPointing& direction) const;
    // The same for a direction that the operator asks for.
    [[nodiscard]] Result<AxisPosition> aimOf(const SkyPointing& direction) const;
    // The same for an azimuth or an elevation alone: the other axis stays where it is in `from`.
    [[nodiscard]] Result<AxisPosition> placeAlong(Axis axis, Angle angle, const AxisPosition& from) const;
    // Whether the beam can be pointed there from where it is.
    [[nodiscard]] Result<> reaches(const SkyPointing& direction) const;
    // Whether a go-to of the operator to this direction would be refused, whatever stands in the way of any motion.
    [[nodiscard]] DirectionVerdict judge(const SkyPointing& direction) const;

    // `what` is shown and logged while the motion goes on.
    Result<> goTo(const AxisPosition& place, Activity activity, const Source& by, const QString& what);
    // The same, on whichever wrap there is a way to.
    Result<> goToAnyTurn(const AxisPosition& place, Activity activity, const Source& by, const QString& what);
    // One point of a stream. A direction out of reach is followed at the nearest permitted place, or refused, as the
    // profile says. `anew`: this point does not continue the points before. An empty `what` names the direction.
    Result<> streamTo(const SkyPointing& direction, const Source& by, const QString& what = {}, bool anew = false);
    Result<> streamTo(const AxisPosition& place, const Source& by);
    // What is followed goes from one direction to another in this time, and is in the first one now. A direction out of
    // reach is followed at the nearest permitted place.
    struct Lead
    {
        SkyPointing now;
        SkyPointing soon;
        Seconds apart;
        std::optional<AxisPosition> near;  // chooses the turn; empty: where the axes are going
    };
    // The place of the axes for it.
    Result<AxisPosition> lead(const Lead& lead, const Source& by, const QString& what);
    // At these rates until somebody ends it. A jog is slow where nothing else is permitted.
    Result<> runAt(const AxisRates& rates, Activity activity, const Source& by, const QString& what);

    // The motion that has just begun was by hand: the source that moved the mount continues afterwards.
    void keepMotionId(std::uint64_t motionId) { m_of.current.setMotionId(motionId); }
    // Control was given away: the motion of its source ends, although no other motion begins.
    void nextMotionId() { m_of.current.setMotionId(current().motionId() + 1); }
    // What is tracked now stays on its wrap: at the end of the cable the mount waits there.
    void keepWrap(const Source& by);
    // What is added to the points of streams.
    void setTrim(const AxisPosition& trim, const Source& by);
    // If the stream of this source is followed, it stops at its last point.
    void settleStream(const Source& by);
    // This client has read the position. If its stream is followed, its last point still holds.
    void confirmStream(std::uint64_t clientId);

    // The station tracks this by itself: a satellite may have an antenna of its own.
    void useAntennaFor(const std::optional<AntennaChoice::Tracked>& tracked) { m_of.antenna.track(tracked); }
    void endTracking() { m_of.antenna.endTracking(); }

    // A motion that makes its own set-points, as the crash-stop proof does: it starts.
    Result<> beginOwn(Activity activity, const Source& by, const QString& what);

    // Ends what goes on: the axes brake and stay. None or Holding is left.
    void hold(Activity left);
    // The same, and logs why in the name of whoever moved the mount. This line is never left out.
    void end(Severity severity, const QString& why);
    // Logged in the name of whoever moves the mount.
    void note(Severity severity, const QString& what) { m_of.log.insist(severity, current().commander(), what); }
    void raiseAlarm(const AlarmEntry& entry, const QStringList& arguments) { m_of.alarms.raise(entry, arguments); }
    void clearAlarm(const AlarmEntry& entry) { m_of.alarms.clear(entry); }
    // The operator who asks has the authority from now on. Clients lose it never without a line in the log.
    void takeOver(const Source& by, Taking how = Taking::ByAct);

private:
    // `detail` is logged besides `what`, and not shown.
    void begin(Activity activity, const Source& by, const QString& what, const QString& detail = {});
    [[nodiscard]] QString arrivalText(const AxisPosition& place) const;
    [[nodiscard]] Result<> mayRun(const AxisRates& rates, Activity activity, const Source& by) const;
    [[nodiscard]] AxisPosition turnWithAWay(const AxisPosition& place) const;
    [[nodiscard]] Result<> mayAim(const SkyPointing& direction) const;
    [[nodiscard]] QString obstacleAt(const SkyPointing& direction) const;
    [[nodiscard]] std::optional<SkyPointing> nearestTo(const SkyPointing& direction) const;
    [[nodiscard]] std::optional<CableGuard::TurnBack> turnBackTo(const AxisPosition& place, const Source& by) const;
    void beginTurnBack(const std::optional<CableGuard::TurnBack>& back);
    [[nodiscard]] bool waitsAtEnd(const std::optional<CableGuard::TurnBack>& back, const Source& by) const;
    [[nodiscard]] static pointing::Resolved endOf(const CableGuard::TurnBack& back, const AxisPosition& place);
    Result<> follow(pointing::Resolved resolved, const SkyPointing& asked, const Source& by, const QString& what);

    Parts m_of;
    std::function<ControlParts()> m_view;
};

}  // namespace boresight
