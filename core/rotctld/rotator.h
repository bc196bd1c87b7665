// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/sky.h"

#include <QString>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>

// What the rotctld server asks of the mount. The station implements it; the server knows nothing else of the station.
// All calls come on the station thread and return at once. An Error's code becomes the RPRT code (README.md), its text
// goes to the log: InvalidInput and OutOfRange -1, NoAnswer, NoDevice and Io -6, Refused and Busy -9,
// NotAvailable -11, Protocol -8.
namespace boresight::rotctld {

struct Client
{
    std::uint64_t id = 0;  // never reused while the program runs
    std::string address;   // "127.0.0.1:51234"; of a pseudo-terminal the path of its link
    std::string protocol = "rotctld";
    bool readsOnly = false;  // its listener is for reading: the rotator refuses its motions
};

// As the client wrote it: an azimuth of any turn, -3600°…3600°, elevation -90°…180°.
struct PointRequest
{
    Angle azimuth;
    Angle elevation;
};

enum class MoveDirection
{
    Up,
    Down,
    Left,
    Right
};  // left = counter-clockwise

// What dump_state and dump_caps advertise.
struct Limits
{
    Angle minAzimuth;
    Angle maxAzimuth;
    Angle minElevation;
    Angle maxElevation;

    // A program counts 0…360° or 0…450°, the mount perhaps -180…180°.
    [[nodiscard]] Angle turned(Angle azimuth) const
    {
        const Angle other = azimuth > maxAzimuth ? azimuth - 360_deg : azimuth + 360_deg;
        const bool isOutside = azimuth > maxAzimuth || azimuth < minAzimuth;
        return isOutside && other >= minAzimuth && other <= maxAzimuth ? other : azimuth;
    }
    // Of a measured place: its noise is no place to go to.
    [[nodiscard]] SkyPointing nearest(const SkyPointing& place) const
    {
        return {.azimuth = std::max(minAzimuth, std::min(place.azimuth, maxAzimuth)),
                .elevation = std::max(minElevation, std::min(place.elevation, maxElevation))};
    }
};

// One answer to get_status: what moves which way, and which limits are reached.
struct MotionFlags
{
    bool movingLeft = false;
    bool movingRight = false;
    bool movingUp = false;
    bool movingDown = false;
    bool limitLeft = false;
    bool limitRight = false;
    bool limitUp = false;
    bool limitDown = false;
};

class Rotator
{
public:
    virtual ~Rotator() = default;

    [[nodiscard]] virtual std::string info() const = 0;  // one line, e.g. "Boresight 0.1.0, my mount"
    [[nodiscard]] virtual Limits limits() const = 0;
    // Measured, in the client's azimuth convention; an error when older than 1 s or unknown. Who asks matters: a
    // tracking client that reads and then sends no point is content with where the mount points.
    [[nodiscard]] virtual Result<SkyPointing> position(const Client& client) = 0;
    [[nodiscard]] virtual MotionFlags motion() const = 0;
    // The mount goes to the last target of this client, or stays there. False: it was moved or stopped since.
    [[nodiscard]] virtual bool follows(const Client& client) const = 0;

    // Accepted: what became of the target, in words, where that is not what the client wrote. Else empty.
    virtual Result<QString> pointTo(const Client& client, const PointRequest& request) = 0;
    // Runs until stop, a limit or the end of that client's connection. Speed in percent of the fastest jog rate as
    // the client wrote it, -1 for "default".
    virtual Result<> move(const Client& client, MoveDirection direction, int speed) = 0;
    // As move, at a rate above zero. Accepted: what became of the rate, in words, where that is not what was asked.
    virtual Result<QString> moveAt(const Client& client, MoveDirection direction, AngularRate rate) = 0;
    virtual Result<> stop(const Client& client) = 0;
    virtual Result<> park(const Client& client) = 0;
    virtual Result<> reset(const Client& client, int kind) = 0;

    // SPEED level 1…4 of Hamlib's dummy: scales the jog rate of `move`.
    [[nodiscard]] virtual int speedLevel() const = 0;
    virtual Result<> setSpeedLevel(const Client& client, int level) = 0;

    virtual void clientConnected(const Client& client) = 0;
    // Its `move` must end: hold. Its last pointTo stands, as with Hamlib: radiosonde_auto_rx connects for each request,
    // and closing Gpredict's window sends no stop.
    virtual void clientGone(const Client& client, const QString& reason) = 0;
    // For the log: a client did something worth a line (foreign protocol, flood, dropped, refused).
    virtual void clientRemark(const Client& client, const QString& text) = 0;
};

}  // namespace boresight::rotctld
