// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/pointing/mount_model.h"
#include "core/tracking/axis_profile.h"

#include <cstdint>
#include <string>

// All settings of one mount, as plain values. The initialisers below are the defaults and describe the reference mount:
// azimuth 0…360° is 0…1 turn; the elevation drive is mounted inverted, 0° is -0.25 turn, 90° is -0.5 turn.
// What each key of the file means, its unit and range: setting.h. Reading and writing: profile_file.h.
namespace boresight::profile {

inline constexpr int kVersion = 1;

// What the position that a drive reports after its power-up is worth. A moteus without an encoder on the output knows
// it only within one turn of the rotor (home state 1).
enum class PowerUpPosition
{
    Ambiguous,  // no absolute pointing until the drive reports a referenced output (home state 2)
    Trusted     // it is right: an encoder on the axis, and a travel below one turn of it
};

struct AxisSettings
{
    int id = 1;  // of the moteus controller on the bus
    pointing::AxisGeometry geometry{};
    tracking::MotionLimits limits{};
    double maxTorque = 0.0;  // Nm, as the drive counts it
    PowerUpPosition powerUpPosition = PowerUpPosition::Ambiguous;

    bool operator==(const AxisSettings&) const = default;
};

// What the drives are left doing when the program ends.
enum class OnExit
{
    Hold,
    Brake,
    Off
};

// What a client's direction outside the permitted region leads to.
enum class OutsideLimits
{
    Nearest,  // drive to the nearest permitted point and show LIMITED
    Refuse    // an error to the client, nothing moves
};

// How `p` reports the azimuth to a client.
enum class AzimuthConvention
{
    ZeroTo360,
    PlusMinus180,
    Continuous  // the mechanical angle: 370° stays 370°
};

struct MountSettings
{
    std::string name = "Boresight mount";
    Angle beamWidth = Angle::fromDegrees(10.0);

    bool operator==(const MountSettings&) const = default;
};

struct ControlSettings
{
    int tickHz = 50;
    Seconds watchdog{0.1};
    OnExit onExit = OnExit::Hold;

    [[nodiscard]] Seconds tickPeriod() const { return Seconds(1.0 / tickHz); }
    bool operator==(const ControlSettings&) const = default;
};

struct JogSettings
{
    AngularRate slow = AngularRate::fromDegrees(0.2);
    AngularRate normal = AngularRate::fromDegrees(2.0);
    AngularRate fast = AngularRate::fromDegrees(6.0);

    bool operator==(const JogSettings&) const = default;
};

struct ListenAddress
{
    std::string host = "127.0.0.1";
    std::uint16_t port = 4533;  // 0: any free port

    bool operator==(const ListenAddress&) const = default;
};

// The answer to \dump_state, which a Hamlib client reads when it connects.
enum class DumpState
{
    OldAndNew,  // read by Hamlib 4.0 to today's
    AsHamlib    // byte for byte as Hamlib 4.5.1 and later; older clients then refuse every target
};

struct RotctldSettings
{
    ListenAddress listen;
    OutsideLimits outsideLimits = OutsideLimits::Nearest;
    AzimuthConvention azimuth = AzimuthConvention::ZeroTo360;
    DumpState dumpState = DumpState::OldAndNew;
    int maxClients = 600;

    bool operator==(const RotctldSettings&) const = default;
};

[[nodiscard]] AxisSettings referenceAzimuth();
[[nodiscard]] AxisSettings referenceElevation();

struct Profile
{
    MountSettings mount;
    std::string bus = "simulated";  // "fdcanusb:PATH", "socketcan:IFACE" or "simulated"
    AxisSettings azimuth = referenceAzimuth();
    AxisSettings elevation = referenceElevation();
    ControlSettings control;
    AxisPosition park{};  // mechanical angles
    JogSettings jog;
    RotctldSettings rotctld;

    bool operator==(const Profile&) const = default;
};

}  // namespace boresight::profile
