// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/pointing_solver.h"
#include "core/control/calibration_source.h"
#include "core/control/station_control.h"
#include "core/north/sky_bodies.h"

#include <optional>
#include <vector>

// Keeps the beam on the Sun or the Moon. Sends one point a second with the operator's authority, which StationControl
// tracks like a stream of points from a client. Any other motion, Hold, STOP and a fault end the tracking. Station
// thread.
namespace boresight {

class BodyFollower
{
public:
    // All arguments must outlive this object.
    BodyFollower(StationControl& control, const profile::InForce& profile, const Clock& clock, EventLog& log);

    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    // `overTheTop`: with the boom past the zenith, if the travel and the limits of the elevation allow that.
    Result<> follow(ephemeris::Body body, ephemeris::Refraction refraction, bool overTheTop = false);
    // Sends the next point when it is due. Notices when another motion has ended the tracking.
    void tick();
    // Holds the mount if the body is tracked. The operator's trim is dropped, because it belongs to this body alone. A
    // reason, if there is one, is logged as a warning.
    void end(const QString& why = {});
    // The clock of this computer was set, so what was measured with this body belongs to another time.
    void clockWasSet();
    // Points the beam beside the body, by this offset on the sky.
    Result<> lookBeside(const calibration::SkyOffset& offset);

    [[nodiscard]] bool following() const { return m_following && body().has_value(); }
    [[nodiscard]] bool follows(ephemeris::Body body) const { return m_following && m_body == body; }
    [[nodiscard]] bool overTheTop() const { return m_following && m_overTheTop; }
    [[nodiscard]] bool looksBeside() const { return m_offset != calibration::SkyOffset{}; }
    // Why the tracking last ended by itself. Empty: somebody ended it or commanded the mount.
    [[nodiscard]] const QString& ending() const { return m_ending; }
    // The body that was tracked last, if the mount was moved only by hand since. Empty after the mount was sent
    // elsewhere or left beside the body.
    [[nodiscard]] std::optional<ephemeris::Body> body() const
    {
        return m_control.motionId() == m_motionId ? m_body : std::nullopt;
    }
    [[nodiscard]] ephemeris::Refraction refraction() const { return m_refraction; }
    // The refraction of the next measurement: for light or for radio.
    void setRefraction(ephemeris::Refraction refraction) { m_refraction = refraction; }
    // Where the body appears now. Refused while the site is unknown.
    [[nodiscard]] Result<SkyPointing> direction(ephemeris::Body body);
    [[nodiscard]] BodyNow now(ephemeris::Body body);
    // Finds one of the times of rising and setting that are reported with the body.
    void lookAhead() { m_bodies.lookAhead(m_clock.utc()); }
    // Why the body cannot be tracked. Reasons that forbid every motion are not checked.
    [[nodiscard]] Result<> permits(ephemeris::Body body, bool overTheTop = false);
    // Why the body cannot be tracked now.
    [[nodiscard]] Result<> mayFollow(ephemeris::Body body, bool overTheTop);
    // The same for all these places around the body, on the side from which it is tracked.
    [[nodiscard]] Result<> permitsAround(ephemeris::Body body, const std::vector<calibration::SkyOffset>& places);

private:
    [[nodiscard]] Result<> isTimeCertain(ephemeris::Body body) const;
    Result<> sendPoint(bool anew);
    [[nodiscard]] Result<> staysOnItsWay();
    void noticeOtherCommand();
    void ended(const QString& how);

    StationControl& m_control;
    const Clock& m_clock;
    EventLog& m_log;
    SkyBodies m_bodies;
    std::optional<ephemeris::Body> m_body;
    std::uint64_t m_motionId = 0;  // the motion id of the control when the mount was sent there
    ephemeris::Refraction m_refraction = ephemeris::Refraction::Light;
    calibration::SkyOffset m_offset;
    std::optional<SkyPointing> m_place;  // of the body, when the last point was sent
    bool m_overTheTop = false;
    bool m_following = false;
    QString m_ending;
    SteadyTime m_next{};
};

}  // namespace boresight
