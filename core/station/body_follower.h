// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/pointing_solver.h"
#include "core/station/calibration_source.h"
#include "core/station/sky_bodies.h"
#include "core/station/station_control.h"

#include <optional>
#include <vector>

// Keeps the beam on the Sun or the Moon: a stream of where it is, one point a second, that StationControl follows like
// that of a client, with the operator's authority. Any other motion, Hold, STOP and a fault end it. Station thread.
namespace boresight {

class BodyFollower
{
public:
    BodyFollower(StationControl& control, const profile::Profile& profile, const Clock& clock, EventLog& log);

    void setProfile(const profile::Profile& profile);

    Result<> follow(ephemeris::Body body, ephemeris::Refraction refraction);
    // The next point when it is time; sees when somebody else has ended it.
    void tick();
    // Holds, if the body is followed; what the operator has trimmed is meant for it alone. The reason, if there is one,
    // is a warning.
    void end(const QString& why = {});
    // The beam shall look beside the body, by so much on the sky.
    Result<> lookBeside(const calibration::SkyOffset& offset);

    [[nodiscard]] bool following() const { return m_following; }
    [[nodiscard]] bool looksBeside() const { return m_offset != calibration::SkyOffset{}; }
    // Why it ended last by itself; empty: it was told to, or the mount was.
    [[nodiscard]] const QString& ending() const { return m_ending; }
    // Chosen last, followed or not; none after a beam that was left beside it.
    [[nodiscard]] const std::optional<ephemeris::Body>& body() const { return m_body; }
    [[nodiscard]] ephemeris::Refraction refraction() const { return m_refraction; }
    // Of what is measured next: by light or by radio.
    void setRefraction(ephemeris::Refraction refraction) { m_refraction = refraction; }
    // Where it appears now. Refused while the site is not known.
    [[nodiscard]] Result<SkyPointing> direction(ephemeris::Body body);
    [[nodiscard]] BodyNow now(ephemeris::Body body);
    // One of the times of rising and setting that are told with it.
    void lookAhead() { m_bodies.lookAhead(m_clock.utc()); }
    // Why it can not be followed; what stands in the way of any motion is not looked at.
    [[nodiscard]] Result<> permits(ephemeris::Body body);
    // The same of all these places around it.
    [[nodiscard]] Result<> permitsAround(ephemeris::Body body, const std::vector<calibration::SkyOffset>& places);

private:
    Result<> sendPoint(bool anew);
    [[nodiscard]] Result<> staysOnItsWay();
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
    std::optional<SkyPointing> m_place;  // of the body, at the last point
    bool m_following = false;
    QString m_ending;
    SteadyTime m_next{};
};

}  // namespace boresight
