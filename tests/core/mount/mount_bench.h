// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/station_control.h"
#include "core/mount/paired_mount.h"
#include "core/simple_mount/simple_mount.h"
#include "core/sources/motion_sources.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

// Rotators of each kind below a control, with a clock that is turned by hand. A new driver needs one bench here.
namespace boresight {

inline constexpr Seconds kOneTick{0.02};

// Slow enough for every rotator in this file.
inline profile::Profile slowProfile(profile::AxisDriver azimuth = profile::AxisDriver::Moteus,
                                    profile::AxisDriver elevation = profile::AxisDriver::Moteus)
{
    profile::Profile profile;
    profile.azimuth.driver = azimuth;
    profile.elevation.driver = elevation;
    for (const Axis axis : kAxes) {
        profile::AxisSettings& settings = axis == Axis::Azimuth ? profile.azimuth : profile.elevation;
        settings.limits.speed = AngularRate::fromDegrees(5.0);
    }
    return profile;
}

inline const QString kUnfit = QStringLiteral("The gear of the drive is not the one of the profile.");
inline const QString kOtherBoard = QStringLiteral("b0000000-0000-0000-0000-000000000003");

inline Result<> interlock(bool fit)
{
    return fit ? Result<>{} : failure(ErrorCode::Refused, kUnfit);
}

inline Angle of(Axis axis, const AxisPosition& place)
{
    return axis == Axis::Azimuth ? place.azimuth : place.elevation;
}

// A rotator, a control above it and a clock that is turned by hand.
class Bench
{
public:
    virtual ~Bench() = default;

    virtual StationControl& control() = 0;
    virtual profile::InForce& inForce() = 0;
    virtual void tick() = 0;
    [[nodiscard]] virtual AxisPosition truth() = 0;  // the true position of the axes
    [[nodiscard]] virtual bool ordered() = 0;        // whether the hardware has received anything but queries so far
    virtual void setLine(bool connected) = 0;
    // The rotator turns more slowly than its profile says: each axis at this part of its speed.
    virtual void setPace(const std::array<double, 2>& /*pace*/) {}
    // The driver finds its hardware unfit or fit for motion. Returns false if such a rotator is always fit.
    [[nodiscard]] virtual bool setFit(bool /*fit*/) { return false; }
    // While the line is off, another device replaces its own. Returns false if such a rotator does not report its
    // identity.
    [[nodiscard]] virtual bool exchangeDevice() { return false; }

    // Another profile is applied.
    void edit(const profile::Profile& profile)
    {
        const profile::Profile before = *inForce();
        inForce().apply(profile);
        control().profileChanged(before, *inForce());
    }
    [[nodiscard]] Capabilities can() { return control().mount().capabilities(); }
    [[nodiscard]] bool has(Axis axis) { return can().has(axis); }
    // The last axis that exists.
    [[nodiscard]] Axis someAxis() { return has(Axis::Elevation) ? Axis::Elevation : Axis::Azimuth; }
    // time within which a silence is reported
    [[nodiscard]] Seconds silence() { return can().axes[index(someAxis())]->silence; }
    // The resolution of the coarsest axis, at least that of the simulation.
    [[nodiscard]] virtual Angle resolution()
    {
        Angle resolution = Angle::fromDegrees(0.01);
        for (const auto& axis : can().axes) {
            resolution = axis ? std::max(resolution, axis->step) : resolution;
        }
        return resolution;
    }
    // A missing axis must not have moved at all.
    void expectAt(const AxisPosition& place, const AxisPosition& before, Angle tolerance)
    {
        for (const Axis axis : kAxes) {
            const Angle expected = has(axis) ? of(axis, place) : of(axis, before);
            EXPECT_LE(abs(of(axis, truth()) - expected), has(axis) ? tolerance : Angle{}) << index(axis);
        }
    }
    [[nodiscard]] bool warns(const char* alarm)
    {
        return std::ranges::any_of(control().status().alarms,
                                   [alarm](const Alarm& one) { return one.name == QLatin1String(alarm); });
    }

    // The same, and its cause lasts.
    [[nodiscard]] bool isActive(const char* alarm)
    {
        return std::ranges::any_of(control().status().alarms, [alarm](const Alarm& one) {
            return one.active && one.name == QLatin1String(alarm);
        });
    }

    void run(Seconds time)
    {
        for (Seconds left = time; left > Seconds(0.0); left -= kOneTick) {
            tick();
        }
    }
    Result<> ask(const Request& request) { return control().request(request, kOperator); }
    Result<> goTo(double azimuth, double elevation)
    {
        return ask(request::PointAxes{{Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)}});
    }
    // Whether the axes stand still during `time`.
    [[nodiscard]] bool stands(Seconds time)
    {
        const AxisPosition before = truth();
        run(time);
        return truth() == before;
    }
};

class MoteusBench final : public Bench
{
public:
    explicit MoteusBench(const profile::Profile& profile = slowProfile()) : m_rig(profile) {}
    StationControl& control() override { return m_rig.control; }
    profile::InForce& inForce() override { return m_rig.inForce; }
    [[nodiscard]] StationRig& rig() { return m_rig; }
    void tick() override { m_rig.tick(); }
    AxisPosition truth() override
    {
        return {.azimuth = m_rig.profile.azimuth.geometry.toAxis(MotorTurns::fromTurns(m_rig.azimuth.position)),
                .elevation = m_rig.profile.elevation.geometry.toAxis(MotorTurns::fromTurns(m_rig.elevation.position))};
    }
    bool ordered() override { return m_rig.commands() > 0; }
    void setLine(bool connected) override { m_rig.azimuth.silent = m_rig.elevation.silent = !connected; }
    bool setFit(bool fit) override
    {
        m_rig.mount.setInterlock(interlock(fit));
        return true;
    }
    bool exchangeDevice() override
    {
        const Axis axis = someAxis();
        m_rig.facts[index(axis)].uuid = kOtherBoard;
        m_rig.learn(axis, m_rig.facts[index(axis)]);
        return true;
    }

private:
    StationRig m_rig;
};

const AxisPosition kBetweenDegrees{.azimuth = Angle::fromDegrees(10.4), .elevation = Angle::fromDegrees(20.6)};

class SimpleBench final : public Bench
{
public:
    explicit SimpleBench(const SimpleMount::Axes& axes = {}, const profile::Profile& profile = slowProfile())
        : m_profile(profile), m_mount(m_box, axes)
    {}
    StationControl& control() override { return m_control; }
    profile::InForce& inForce() override { return m_profile; }
    [[nodiscard]] fakes::ManualClock& clock() { return m_clock; }
    void tick() override
    {
        m_clock.advance(kOneTick);
        m_control.tick();
        m_mount.send();
    }
    AxisPosition truth() override { return m_box.truth(); }
    bool ordered() override { return m_box.orders() > 0; }
    void setLine(bool connected) override { m_box.setPower(connected, m_clock.now()); }
    [[nodiscard]] const SimpleBox& box() const { return m_box; }

private:
    profile::InForce m_profile;
    fakes::ManualClock m_clock;
    EventLog m_log{m_clock};
    AlarmBoard m_alarms{m_log, m_clock};
    SimpleBox m_box{kBetweenDegrees};
    SimpleMount m_mount;
    StationControl m_control{m_profile, m_clock, m_log, m_alarms, m_mount, motionSources};
};

// Two rotators, each with its own control box, line and axis.
class PairBench final : public Bench
{
public:
    StationControl& control() override { return m_control; }
    profile::InForce& inForce() override { return m_profile; }
    void tick() override
    {
        m_clock.advance(kOneTick);
        m_control.tick();
        m_azimuth.send();
        m_elevation.send();
    }
    AxisPosition truth() override
    {
        return {.azimuth = m_azimuthBox.truth().azimuth, .elevation = m_elevationBox.truth().elevation};
    }
    bool ordered() override { return m_azimuthBox.orders() + m_elevationBox.orders() > 0; }
    void setLine(bool connected) override
    {
        m_azimuthBox.setPower(connected, m_clock.now());
        m_elevationBox.setPower(connected, m_clock.now());
    }
    void setElevationLine(bool connected) { m_elevationBox.setPower(connected, m_clock.now()); }
    // Whether one of them has turned the axis of the other.
    [[nodiscard]] bool turnedForeignAxes() const
    {
        return m_azimuthBox.truth().elevation != kBetweenDegrees.elevation ||
               m_elevationBox.truth().azimuth != kBetweenDegrees.azimuth;
    }

private:
    profile::InForce m_profile{slowProfile()};
    fakes::ManualClock m_clock;
    EventLog m_log{m_clock};
    AlarmBoard m_alarms{m_log, m_clock};
    SimpleBox m_azimuthBox{kBetweenDegrees};
    SimpleBox m_elevationBox{kBetweenDegrees};
    SimpleMount m_azimuth{m_azimuthBox, {.azimuth = true, .elevation = false}};
    SimpleMount m_elevation{m_elevationBox, {.azimuth = false, .elevation = true}};
    PairedMount m_mount{m_azimuth, m_elevation};
    StationControl m_control{m_profile, m_clock, m_log, m_alarms, m_mount, motionSources};
};

// A moteus and a simple rotator, one axis each.
class MixedBench final : public Bench
{
public:
    explicit MixedBench(Axis moteus) : m_axis(moteus)
    {
        m_moteus.setInterlock({});
        learn();
    }
    StationControl& control() override { return m_control; }
    profile::InForce& inForce() override { return m_profile; }
    void tick() override
    {
        m_clock.advance(kOneTick);
        if (m_moteus.needsOrigin(m_axis)) {
            learn();
        }
        m_control.tick();
        for (const CanFrame& frame : m_moteus.frames()) {
            for (fakes::IdealDrive& drive : m_onBus) {
                if (const auto reply = drive.answer(frame, m_clock.now())) {
                    m_moteus.take(*reply);
                }
            }
        }
        m_moteus.framesSent();
        m_simple.send();
    }
    AxisPosition truth() override
    {
        const Angle turned = m_profile->axis(m_axis).geometry.toAxis(MotorTurns::fromTurns(drive().position));
        const AxisPosition box = m_box.truth();
        return m_axis == Axis::Azimuth ? AxisPosition{turned, box.elevation} : AxisPosition{box.azimuth, turned};
    }
    bool ordered() override { return m_box.orders() > 0 || !m_onBus[0].seen.empty() || !m_onBus[1].seen.empty(); }
    void setLine(bool connected) override
    {
        drive().silent = !connected;
        m_box.setPower(connected, m_clock.now());
    }
    bool setFit(bool fit) override
    {
        m_moteus.setInterlock(interlock(fit));
        return true;
    }
    bool exchangeDevice() override
    {
        m_uuid = kOtherBoard;
        learn();
        return true;
    }
    [[nodiscard]] QString lastLog() const { return m_log.since(0, 1).back().text; }
    void setBoxLine(bool connected) { m_box.setPower(connected, m_clock.now()); }
    void setMoteusLine(bool connected) { drive().silent = !connected; }
    // Whether one of them has turned, or was commanded to turn, the axis of the other.
    [[nodiscard]] bool turnedForeignAxes() const
    {
        const AxisPosition box = m_box.truth();
        return !m_onBus[1 - index(m_axis)].seen.empty() ||
               (m_axis == Axis::Azimuth ? box.azimuth != kBetweenDegrees.azimuth
                                        : box.elevation != kBetweenDegrees.elevation);
    }

private:
    [[nodiscard]] fakes::IdealDrive& drive() { return m_onBus[index(m_axis)]; }
    // Sets the facts as the drive check reports them.
    void learn()
    {
        m_moteus.learn(m_axis, drive_check::DriveFacts{
                                   .uuid = m_uuid,
                                   .bootedAt = m_clock.now() - std::chrono::hours(1),
                                   .outputEncoder = false,
                                   .rotorToOutputRatio = 0.01,
                                   .holdsWhenNotFed = true,
                                   .origin = {.origin = moteus::CountOrigin{.beginning = 1, .offset = drive().origin()},
                                              .asked = m_clock.now()}});
    }

    const Axis m_axis;  // the axis of the moteus
    QString m_uuid = QStringLiteral("a0000000-0000-0000-0000-000000000001");
    profile::InForce m_profile{
        slowProfile(m_axis == Axis::Azimuth ? profile::AxisDriver::Moteus : profile::AxisDriver::Simple,
                    m_axis == Axis::Azimuth ? profile::AxisDriver::Simple : profile::AxisDriver::Moteus)};
    fakes::ManualClock m_clock;
    EventLog m_log{m_clock};
    AlarmBoard m_alarms{m_log, m_clock};
    std::array<fakes::IdealDrive, 2> m_onBus{fakes::IdealDrive{1, 0.0}, fakes::IdealDrive{2, -0.25}};
    SimpleBox m_box{kBetweenDegrees};
    MoteusMount m_moteus{m_profile,
                         m_clock,
                         m_log,
                         m_alarms,
                         {.trustFirstContact = true},
                         axesIf(m_axis == Axis::Azimuth, m_axis == Axis::Elevation)};
    SimpleMount m_simple{m_box, {.azimuth = m_axis != Axis::Azimuth, .elevation = m_axis != Axis::Elevation}};
    PairedMount m_mount{m_axis == Axis::Azimuth ? static_cast<MountDriver&>(m_moteus) : m_simple,
                        m_axis == Axis::Azimuth ? static_cast<MountDriver&>(m_simple) : m_moteus};
    StationControl m_control{m_profile, m_clock, m_log, m_alarms, m_mount, motionSources};
};

}  // namespace boresight
