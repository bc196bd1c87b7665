// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/permitted_region.h"
#include "tests/core/control/station_rig.h"

#include <array>
#include <optional>
#include <string>

// The promises that the station keeps whatever happens. They are judged from outside: by the requests and their
// answers, by what the test did to drives, bus and drive check, and by the frames that leave. Call asked() after each
// request and ticked() after each tick. The first broken promise stays in broken().
namespace boresight {

class StationPromises
{
public:
    explicit StationPromises(const StationRig& rig) : m_rig(rig), m_before(rig.control.briefStatus()) {}

    void interlock(bool fit) { m_fit = fit; }  // the result of the drive check
    void asked(const Request& request, const Source& source, bool accepted, const StationStatus& before);
    void sourceGone(const Source& source);
    // Whether the brake is really open in the next tick.
    void brake(bool isOpen) { m_isBrakeOpen = isOpen; }
    // The test has changed the position of the axis or the count of its drive. A drive under command comes back at
    // once.
    void slipped(Axis axis) { m_traces[index(axis)].sinceSlip = 0; }
    // `step` is the time since the last tick. The frames of the drives are those of this time.
    void ticked(Seconds step);

    [[nodiscard]] const std::string& broken() const { return m_broken; }
    [[nodiscard]] long motions() const { return m_motions; }  // times that an axis began to move
    [[nodiscard]] long losses() const { return m_losses; }

private:
    // An accepted request that allows the axes to move until something ends it.
    struct Permit
    {
        Source source;
        bool jog = false;   // ends with its keep-alive
        bool run = false;   // ends with its source
        bool slow = false;  // the operator's jog at the speed for an unknown wrap
        SteadyTime given{};
    };
    static constexpr std::size_t kManyClients = 3;
    struct AxisTrace
    {
        std::optional<double> position;  // turns: the last set-point, if the last frame had one
        int still = 1000;                // ticks; a drive that was just taken over stands still
        int faultyTicks = 0;
        int sinceSlip = 1000;    // ticks
        int sinceFalse = 1000;   // ticks since the drive last reported a false place
        int sinceHold = 1000;    // ticks since the drive was last told to hold where it is
        int inside = 0;          // ticks for which the real axis has been inside its travel
        double travelled = 0.0;  // turns, at the end of the last tick
    };

    void fail(const std::string& what);
    void watchControl(const Request& request, const Source& source);
    void askedForMotion(const Request& request, const Source& source, const StationStatus& before);
    void end() { m_permit.reset(); }
    void watchLatches(const StationStatus& now);
    void watchEnds(const StationStatus& now);
    void watchFrames(const StationStatus& now);
    void watchFrame(Axis axis, const fakes::IdealDrive::Seen& seen, const StationStatus& now);
    void watchSetpoint(Axis axis, double position, double velocity, const StationStatus& now);
    void watchBrake(const StationStatus& now);
    [[nodiscard]] bool isHeld(Axis axis) const;
    void watchAxis(Axis axis, const StationStatus& now, Seconds step);
    [[nodiscard]] bool takesOver(Axis axis, const StationStatus& now) const;
    void watchBounds(Axis axis, const fakes::IdealDrive::Seen& seen, const StationStatus& now);
    void watchRegion(const StationStatus& now);
    void watchPath(Axis axis, const StationStatus& now, Seconds step);

    const StationRig& m_rig;
    pointing::PermittedRegion m_region{m_rig.profile.limits, m_rig.profile.azimuth.geometry.travel,
                                       m_rig.profile.elevation.geometry.travel};
    StationStatus m_before;
    std::array<AxisTrace, 2> m_traces;
    std::optional<Permit> m_permit;
    std::optional<Permit> m_lead;  // the client whose motion was accepted last, or that was given control
    std::array<bool, kManyClients> m_readOnly{};  // by client
    int m_sinceEnd = 0;                           // ticks without a permit
    int m_sinceUnknown = 0;                       // ticks since the wraps were known
    bool m_fit = true;
    bool m_isBrakeOpen = true;
    bool m_isBrakeReleased = false;  // as last ordered
    bool m_wasHeld = true;           // both axes, by their drives
    bool m_stopped = false;
    bool m_faulty = false;
    bool m_rearmed = false;  // a re-arm was requested since the fault
    long m_motions = 0;
    long m_losses = 0;
    std::string m_broken;
};

}  // namespace boresight
