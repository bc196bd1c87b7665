// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/pointing_solver.h"
#include "core/station/sky_bodies.h"
#include "core/station/station_control.h"

#include <optional>

// Keeps the beam on the Sun or the Moon: a stream of where it is, one point a second, that StationControl follows like
// that of a client, with the operator's authority. Any other motion, Hold, STOP and a fault end it. Station thread.
namespace boresight {

// Who asks for the motions of calibrations: the operator, but not the operator's own hand, which ends them.
[[nodiscard]] const Source& calibrationSource();

class BodyFollower
{
public:
    BodyFollower(StationControl& control, const profile::Profile& profile, const Clock& clock, EventLog& log);

    void setProfile(const profile::Profile& profile);

    Result<> follow(ephemeris::Body body, ephemeris::Refraction refraction);
    // The next point when it is time; sees when somebody else has ended it.
    void tick();
    // Holds, if the body is followed; what the operator has trimmed is meant for it alone.
    void end();
    // The beam shall look beside the body, by so much on the sky.
    Result<> lookBeside(const calibration::SkyOffset& offset);

    [[nodiscard]] bool following() const { return m_following; }
    // Chosen last, followed or not.
    [[nodiscard]] const std::optional<ephemeris::Body>& body() const { return m_body; }
    [[nodiscard]] ephemeris::Refraction refraction() const { return m_refraction; }
    // Where it appears now. Refused while the site is not known.
    [[nodiscard]] Result<SkyPointing> direction(ephemeris::Body body);
    [[nodiscard]] BodyNow now(ephemeris::Body body);
    // One of the times of rising and setting that are told with it.
    void lookAhead() { m_bodies.lookAhead(m_clock.utc()); }
    // Why it can not be followed; what stands in the way of any motion is not looked at.
    [[nodiscard]] Result<> permits(ephemeris::Body body);

private:
    Result<> sendPoint(bool anew);
    void ended(const QString& how);
    void warn();

    StationControl& m_control;
    const Clock& m_clock;
    EventLog& m_log;
    SkyBodies m_bodies;
    bool m_keepsFromSun = false;
    std::optional<ephemeris::Body> m_body;
    ephemeris::Refraction m_refraction = ephemeris::Refraction::Light;
    calibration::SkyOffset m_offset;
    bool m_following = false;
    SteadyTime m_next{};
};

}  // namespace boresight
