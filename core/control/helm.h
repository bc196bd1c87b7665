// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/control/control_parts.h"
#include "core/control/first_moves_guard.h"
#include "core/control/gates.h"
#include "core/control/source_log.h"
#include "core/guards/cable_guard.h"

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
    // The parts that change when a motion starts or ends.
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

    // `view` is called for each access, because it contains the time of the tick.
    Helm(const Parts& parts, std::function<ControlParts()> view) : m_of(parts), m_view(std::move(view)) {}

    // For reading only.
    [[nodiscard]] ControlParts view() const { return m_view(); }
    [[nodiscard]] const CurrentMotion& current() const { return m_of.current; }
    [[nodiscard]] SteadyTime now() const { return view().now; }
    [[nodiscard]] AxisPosition standing() const { return view().standing(); }
    [[nodiscard]] AxisPosition heading() const { return view().heading(); }
    // The direction of the beam at this position of the axes, as text with an azimuth from 0° to 360°.
    [[nodiscard]] QString directionText(const AxisPosition& place) const;

    // This source may send the mount to some place. Each goTo() and streamTo() checks this, too.
    [[nodiscard]] Result<> mayPoint(const Source& by) const { return Gates(view()).mayPoint(by); }
    // The place is permitted, and a permitted route leads to it.
    [[nodiscard]] Result<> mayGoTo(const AxisPosition& place) const;
    // The position of the axes for a new target in this direction, on the wrap nearest to where the axes can stop. A
    // former target that they still move to does not count. An error if the axes do not reach the direction.
    [[nodiscard]] Result<AxisPosition> placeOf(const SkyPointing& direction) const;
    // The same for a direction that the operator enters. An elevation beyond the travel over the top is refused.
    [[nodiscard]] Result<AxisPosition> aimOf(const SkyPointing& direction) const;
    // The same for an azimuth or an elevation alone, on the wrap nearest to `from`. The other axis stays where it is in
    // `from`.
    [[nodiscard]] Result<AxisPosition> placeAlong(Axis axis, Angle angle, const AxisPosition& from) const;
    // The beam can be pointed to this direction, and a permitted route leads there from where it is.
    [[nodiscard]] Result<> reaches(const SkyPointing& direction) const;
    // Whether this direction would be refused as a go-to of the operator. Reasons that forbid any motion are left out.
    [[nodiscard]] DirectionVerdict judge(const SkyPointing& direction) const;

    // `what` is shown and logged during the motion.
    Result<> goTo(const AxisPosition& place, Activity activity, const Source& by, const QString& what);
    // The same, but on any wrap that a permitted route leads to.
    Result<> goToAnyTurn(const AxisPosition& place, Activity activity, const Source& by, const QString& what);
    // One point of a stream. If the direction is out of reach, the mount goes to the nearest permitted place, or the
    // point is refused, as the profile sets. `anew`: this point does not continue the earlier points. If `what` is
    // empty, the text names the direction.
    Result<> streamTo(const SkyPointing& direction, const Source& by, const QString& what = {}, bool anew = false);
    Result<> streamTo(const AxisPosition& place, const Source& by);
    // A target that is in the direction `now` and will be in the direction `soon` after the time `apart`.
    struct Lead
    {
        SkyPointing now;
        SkyPointing soon;
        Seconds apart;
        std::optional<AxisPosition> near;  // determines the wrap; empty: the target before, or where the axes can stop
        bool isPlanned = false;            // the cable has room for the way to come
    };
    // Follows the target and returns the position of the axes for `lead.now`. If the direction is out of reach, the
    // mount follows at the nearest permitted place.
    Result<AxisPosition> lead(const Lead& lead, const Source& by, const QString& what);
    // The same for places of the axes by a plan, which keeps to the room of the cable.
    struct AxisLead
    {
        AxisPosition now;
        AxisPosition soon;
        Seconds apart;
    };
    Result<AxisPosition> leadAxes(const AxisLead& lead, const Source& by, const QString& what);
    // Moves at these rates until the motion is ended. Where only a slow jog is permitted, a faster one is refused.
    Result<> runAt(const AxisRates& rates, Activity activity, const Source& by, const QString& what);

    // Gives the motion that has just begun this earlier id. So a source that moved the mount before goes on afterwards.
    void keepMotionId(std::uint64_t motionId) { m_of.current.setMotionId(motionId); }
    // Ends the motion of a source that has lost control, although no other motion begins.
    void nextMotionId() { m_of.current.setMotionId(current().motionId() + 1); }
    // The tracked target is followed on this wrap only. At the end of the cable the mount waits.
    void keepWrap(const Source& by);
    // The offset that is added to every point of a stream.
    void setTrim(const AxisPosition& trim, const Source& by);
    // If the mount follows the stream of this source, it stops at the last point.
    void settleStream(const Source& by);
    // If a client sent this command, it was active just now.
    void commanded(const Source& by);
    // This client has read the position. If the mount follows its stream, the last point stays valid.
    void confirmStream(std::uint64_t clientId);

    // The target that the station tracks by itself. A satellite may have an antenna of its own.
    void useAntennaFor(const std::optional<AntennaChoice::Tracked>& tracked) { m_of.antenna.track(tracked); }
    void endTracking() { m_of.antenna.endTracking(); }

    // Starts a motion that makes its own set-points, for example the crash-stop test.
    Result<> beginOwn(Activity activity, const Source& by, const QString& what);

    // Ends the motion: the axes brake and stay where they stop. `left` is the activity afterwards: None or Holding.
    void hold(Activity left);
    // The same. Logs the reason in the name of the source that moved the mount. The log never drops this line.
    void end(Severity severity, const QString& why);
    // Logged in the name of the source that moves the mount.
    void note(Severity severity, const QString& what) { m_of.log.insist(severity, current().commander(), what); }
    void raiseAlarm(const AlarmEntry& entry, const QStringList& arguments) { m_of.alarms.raise(entry, arguments); }
    void clearAlarm(const AlarmEntry& entry) { m_of.alarms.clear(entry); }
    // The operator takes control. If clients had it, the log has a line about it.
    void takeOver(const Source& by, Taking how = Taking::ByAct);

private:
    // `detail` is only logged, together with `what`.
    void begin(Activity activity, const Source& by, const QString& what, const QString& detail = {});
    [[nodiscard]] QString arrivalText(const AxisPosition& place) const;
    [[nodiscard]] Result<> mayRun(const AxisRates& rates, Activity activity, const Source& by) const;
    [[nodiscard]] AxisPosition turnWithAWay(const AxisPosition& place) const;
    [[nodiscard]] Result<> mayAim(const SkyPointing& direction) const;
    [[nodiscard]] QString obstacleAt(const SkyPointing& direction) const;
    [[nodiscard]] std::optional<SkyPointing> nearestTo(const SkyPointing& direction) const;
    [[nodiscard]] Result<AxisPosition> placeNear(const SkyPointing& direction, const AxisPosition& near) const;
    [[nodiscard]] AxisPosition nearestWrapOf(const SkyPointing& point, const Source& by) const;
    [[nodiscard]] bool continuesStream(const Source& by) const { return current().continues(Activity::Streaming, by); }
    [[nodiscard]] std::optional<CableGuard::TurnBack> turnBackTo(const AxisPosition& place, const Source& by) const;
    void beginTurnBack(const std::optional<CableGuard::TurnBack>& back);
    [[nodiscard]] bool waitsAtEnd(const std::optional<CableGuard::TurnBack>& back, const Source& by) const;
    [[nodiscard]] static pointing::Resolved endOf(const CableGuard::TurnBack& back, const AxisPosition& place);
    Result<> follow(pointing::Resolved resolved, const SkyPointing& asked, const Source& by, const QString& what);

    Parts m_of;
    std::function<ControlParts()> m_view;
};

}  // namespace boresight
