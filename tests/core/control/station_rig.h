// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/station_control.h"
#include "core/moteus_mount/moteus_mount.h"
#include "core/sources/motion_sources.h"
#include "tests/fakes/ideal_drive.h"
#include "tests/fakes/manual_clock.h"

#include <functional>

// StationControl with two ideal drives, or one if the profile has one, and a hand-turned clock. The drives are on the
// bus.
namespace boresight {

inline const Source kOperator{.kind = SourceKind::Operator, .name = QStringLiteral("operator")};
inline const Source kClient{.kind = SourceKind::Client, .clientId = 1, .name = QStringLiteral("rotctld 1")};
inline const Source kOtherClient{.kind = SourceKind::Client, .clientId = 2, .name = QStringLiteral("rotctld 2")};

struct StationRig
{
    static constexpr Seconds kTick{0.02};  // of the default profile

    // The drives passed the drive check, and they stand where they report.
    explicit StationRig(const profile::Profile& settings = {},
                        const TurnKeeper::Start& start = {.trustFirstContact = true},
                        const MakeSources& sources = motionSources)
        : profile(settings),
          step(1.0 / settings.control.tickHz),
          mount(inForce, clock, log, alarms, start,
                axesIf(settings.azimuth.driver == profile::AxisDriver::Moteus,
                       settings.elevation.driver == profile::AxisDriver::Moteus)),
          control(inForce, clock, log, alarms, mount, sources)
    {
        mount.setInterlock({});
        for (const Axis axis : mount.axes()) {
            learn(axis, factsOf(axis));
        }
    }

    // Sets the facts as the drive check reports them.
    void learn(Axis axis, const drive_check::DriveFacts& known)
    {
        facts[index(axis)] = known;
        facts[index(axis)].origin = {.origin = moteus::CountOrigin{.beginning = 1, .offset = drive(axis).origin()},
                                     .asked = clock.now()};
        mount.learn(axis, facts[index(axis)]);
    }

    [[nodiscard]] fakes::IdealDrive& drive(Axis axis) { return axis == Axis::Azimuth ? azimuth : elevation; }

    [[nodiscard]] drive_check::DriveFacts factsOf(Axis axis) const
    {
        return {.uuid = axis == Axis::Azimuth ? QStringLiteral("a0000000-0000-0000-0000-000000000001")
                                              : QStringLiteral("e0000000-0000-0000-0000-000000000002"),
                .bootedAt = clock.now() - std::chrono::hours(1),
                .outputEncoder = false,
                .rotorToOutputRatio = 0.01,
                .holdsWhenNotFed = true};
    }

    void tick()
    {
        clock.advance(step);
        if (onTick) {
            onTick();
        }
        const SteadyTime now = clock.now();
        for (const Axis axis : mount.axes()) {
            if (originIsRead && mount.needsOrigin(axis)) {
                learn(axis, facts[index(axis)]);
            }
        }
        control.tick();
        const auto frames = mount.frames();
        clock.advance(heldUp);
        if (mount.busLeft()) {
            mount.framesSent();
            return;  // the link of the station is closed
        }
        mount.framesTaken();
        for (const CanFrame& frame : frames) {
            for (fakes::IdealDrive* const drive : {&azimuth, &elevation}) {
                if (const auto reply = drive->answer(frame, now)) {
                    mount.take(*reply);
                }
            }
        }
        mount.framesSent();
    }

    void run(Seconds time)
    {
        for (int i = 0; i < static_cast<int>(time / step); ++i) {
            tick();
        }
    }

    // Runs until nothing moves, for at most `time`.
    void settle(Seconds time = Seconds(120.0))
    {
        run(Seconds(0.2));
        constexpr int kBetween = 5;  // ticks between two checks: a status costs as much as a tick
        for (Seconds left = time; left > Seconds(0.0) && moving(); left -= kBetween * step) {
            for (int i = 0; i < kBetween; ++i) {
                tick();
            }
        }
    }

    [[nodiscard]] bool moving() const
    {
        const StationStatus status = control.briefStatus();
        return status.azimuth.state == AxisState::Moving || status.elevation.state == AxisState::Moving ||
               status.state == StationState::Slew;
    }

    Result<> ask(const Request& request, const Source& source = kOperator) { return control.request(request, source); }

    Result<> point(double azimuthDegrees, double elevationDegrees, const Source& source = kClient)
    {
        return ask(request::PointSky{{.azimuth = Angle::fromDegrees(azimuthDegrees),
                                      .elevation = Angle::fromDegrees(elevationDegrees)}},
                   source);
    }

    // Sends a client's first target and runs for `time` on the way there. Returns whether the target was accepted.
    [[nodiscard]] bool setsOff(double azimuthDegrees, double elevationDegrees, Seconds time)
    {
        run(Seconds(0.2));
        const bool accepted = point(azimuthDegrees, elevationDegrees).has_value();
        run(time);
        return accepted;
    }

    // Puts the axes at this place from the start, without a motion to it.
    [[nodiscard]] bool holdAt(const AxisPosition& place)
    {
        azimuth.position = profile.azimuth.geometry.toMotor(place.azimuth).turns();
        elevation.position = profile.elevation.geometry.toMotor(place.elevation).turns();
        run(Seconds(0.2));
        const bool accepted = ask(request::PointAxes{place}).has_value();
        settle();
        return accepted;
    }

    void draw(const pointing::Region& region)
    {
        profile.limits = region;
        setProfile(profile);
    }

    // Does what the station does when the operator applies a profile.
    void setProfile(const profile::Profile& wanted)
    {
        profile = wanted;
        const auto before = inForce.shared();
        inForce.apply(wanted);
        control.profileChanged(*before, *inForce);
    }

    [[nodiscard]] StationState state() const { return control.state(); }
    [[nodiscard]] double azimuthDegrees() const { return degrees(Axis::Azimuth); }
    [[nodiscard]] double elevationDegrees() const { return degrees(Axis::Elevation); }
    [[nodiscard]] double degrees(Axis axis) const { return mount.report(axis).place.value().degrees(); }
    [[nodiscard]] std::size_t commands() const { return azimuth.seen.size() + elevation.seen.size(); }

    [[nodiscard]] std::string lastLog() const
    {
        const auto lines = log.since(0, 1);
        return lines.empty() ? std::string() : lines.back().text.toStdString();
    }

    profile::Profile profile;  // as last applied
    const Seconds step;        // what the clock advances in one tick
    profile::InForce inForce{profile};
    fakes::ManualClock clock;
    EventLog log{clock};
    Seconds heldUp{0.0};       // time between the start of a tick and its frames
    bool originIsRead = true;  // the drive check reads at once the origin that positions count from
    AlarmBoard alarms{log, clock};
    MoteusMount mount;
    StationControl control;
    fakes::IdealDrive azimuth{1, 0.0};
    fakes::IdealDrive elevation{2, -0.25};
    std::array<drive_check::DriveFacts, 2> facts;
    std::function<void()> onTick;  // is called in each tick before the control
};

}  // namespace boresight
