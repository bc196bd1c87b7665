// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/pointing_solver.h"
#include "core/control/calibration_source.h"
#include "core/control/station_control.h"
#include "core/north/sky_bodies.h"

#include <optional>
#include <vector>

// Keeps the beam on the Sun or the Moon: a stream of where it is, one point a second, that StationControl follows like
// that of a client, with the operator's authority. Any other motion, Hold, STOP and a fault end it. Station thread.
namespace boresight {

class BodyFollower
{
public:
    // All of them outlive it.
    BodyFollower(StationControl& control, const profile::InForce& profile, const Clock& clock, EventLog& log);

    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    // Over the top: with the boom past the zenith, if the elevation's travel and limits allow it.
    Result<> follow(ephemeris::Body body, ephemeris::Refraction refraction, bool overTheTop = false);
    // The next point when it is time; sees when somebody else has ended it.
    void tick();
    // Holds, if the body is followed; what the operator has trimmed is meant for it alone. The reason, if there is one,
    // is a warning.
    void end(const QString& why = {});
    // The beam shall look beside the body, by so much on the sky.
    Result<> lookBeside(const calibration::SkyOffset& offset);

    [[nodiscard]] bool following() const { return m_following && body().has_value(); }
    [[nodiscard]] bool follows(ephemeris::Body body) const { return m_following && m_body == body; }
    [[nodiscard]] bool overTheTop() const { return m_following && m_overTheTop; }
    [[nodiscard]] bool looksBeside() const { return m_offset != calibration::SkyOffset{}; }
    // Why it ended last by itself. Empty: somebody ended it, or commanded the mount.
    [[nodiscard]] const QString& ending() const { return m_ending; }
    // Followed last, and the mount was moved by hand only since: none once it was sent elsewhere or left beside it.
    [[nodiscard]] std::optional<ephemeris::Body> body() const
    {
        return m_control.errand() == m_errand ? m_body : std::nullopt;
    }
    [[nodiscard]] ephemeris::Refraction refraction() const { return m_refraction; }
    // Of what is measured next: by light or by radio.
    void setRefraction(ephemeris::Refraction refraction) { m_refraction = refraction; }
    // Where it appears now. Refused while the site is not known.
    [[nodiscard]] Result<SkyPointing> direction(ephemeris::Body body);
    [[nodiscard]] BodyNow now(ephemeris::Body body);
    // One of the times of rising and setting that are reported with it.
    void lookAhead() { m_bodies.lookAhead(m_clock.utc()); }
    // Why it can not be followed; what stands in the way of any motion is not looked at.
    [[nodiscard]] Result<> permits(ephemeris::Body body, bool overTheTop = false);
    // Why it can not be followed now.
    [[nodiscard]] Result<> mayFollow(ephemeris::Body body, bool overTheTop);
    // The same of all these places around it, on the side from which it is followed.
    [[nodiscard]] Result<> permitsAround(ephemeris::Body body, const std::vector<calibration::SkyOffset>& places);

private:
    Result<> sendPoint(bool anew);
    [[nodiscard]] Result<> staysOnItsWay();
    void ended(const QString& how);

    StationControl& m_control;
    const Clock& m_clock;
    EventLog& m_log;
    SkyBodies m_bodies;
    std::optional<ephemeris::Body> m_body;
    std::uint64_t m_errand = 0;  // of the control, when it was sent there
    ephemeris::Refraction m_refraction = ephemeris::Refraction::Light;
    calibration::SkyOffset m_offset;
    std::optional<SkyPointing> m_place;  // of the body, at the last point
    bool m_overTheTop = false;
    bool m_following = false;
    QString m_ending;
    SteadyTime m_next{};
};

}  // namespace boresight
