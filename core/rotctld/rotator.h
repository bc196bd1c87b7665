// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/rotctld/exchange.h"
#include "core/units/sky.h"

#include <QString>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>

// The functions of the mount for the rotctld server. The station implements them, and the server uses nothing else of
// the station. All calls come on the station thread and return at once. The code of an Error becomes the RPRT code
// (README.md), and its text goes to the log: InvalidInput and OutOfRange -1, NoAnswer, NoDevice and Io -6, Refused and
// Busy -9, NotAvailable -11, Protocol -8.
namespace boresight::rotctld {

struct Client
{
    std::uint64_t id = 0;  // not used again while the program runs
    std::string address;   // "127.0.0.1:51234"; for a pseudo-terminal the path of its link
    std::string protocol = "rotctld";
    bool readsOnly = false;             // its listener is only for reading, so the rotator refuses its motions
    bool keepsControlByReading = true;  // as Gpredict, which sends nothing while the mount tracks well
};

// As the client wrote it: any azimuth in -3600°…3600°, elevation -90°…180°.
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

// The limits that dump_state and dump_caps report.
struct Limits
{
    Angle minAzimuth;
    Angle maxAzimuth;
    Angle minElevation;
    Angle maxElevation;

    // Moves an azimuth outside the limits by 360° if that brings it inside. A program may count 0…360° or 0…450°, and
    // the mount -180…180°.
    [[nodiscard]] Angle turned(Angle azimuth) const
    {
        const Angle other = azimuth > maxAzimuth ? azimuth - 360_deg : azimuth + 360_deg;
        const bool isOutside = azimuth > maxAzimuth || azimuth < minAzimuth;
        return isOutside && other >= minAzimuth && other <= maxAzimuth ? other : azimuth;
    }
    // Moves a position into the limits. The noise of a measured position may put it outside.
    [[nodiscard]] SkyPointing nearest(const SkyPointing& place) const
    {
        return {.azimuth = std::max(minAzimuth, std::min(place.azimuth, maxAzimuth)),
                .elevation = std::max(minElevation, std::min(place.elevation, maxElevation))};
    }
};

// The answer to get_status: which axis moves in which direction, and which limits are reached.
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
    // The measured position in the azimuth convention of the client. An error if it is older than 1 s or unknown. The
    // client matters: a tracking client that reads the position and sends no new point accepts where the mount points.
    [[nodiscard]] virtual Result<SkyPointing> position(const Client& client) = 0;
    // The target that leaves both axes where they go or stand. An axis that sags still has its set-point here. An error
    // if the position is older than 1 s or unknown.
    [[nodiscard]] virtual Result<SkyPointing> target() const = 0;
    [[nodiscard]] virtual MotionFlags motion() const = 0;

    // On success: the changed target as text, or empty if the target was not changed.
    virtual Result<QString> pointTo(const Client& client, const PointRequest& request) = 0;
    // Moves until a stop, a limit or the end of the connection of this client. `speed`: percent of the fastest jog rate
    // as the client wrote it, or -1 for the default.
    virtual Result<> move(const Client& client, MoveDirection direction, int speed) = 0;
    // Like move(), at a rate above zero. On success: the changed rate as text, or empty if the rate was not changed.
    virtual Result<QString> moveAt(const Client& client, MoveDirection direction, AngularRate rate) = 0;
    virtual Result<> stop(const Client& client) = 0;
    virtual Result<> park(const Client& client) = 0;
    virtual Result<> reset(const Client& client, int kind) = 0;

    // SPEED level 1…4 of Hamlib's dummy: scales the jog rate of `move`.
    [[nodiscard]] virtual int speedLevel() const = 0;
    virtual Result<> setSpeedLevel(const Client& client, int level) = 0;

    virtual void clientConnected(const Client& client) = 0;
    // Its move() must end, and the mount holds. Its last pointTo() stays valid, as with Hamlib: radiosonde_auto_rx
    // connects for each request, and closing the window of Gpredict sends no stop.
    virtual void clientGone(const Client& client, const QString& reason) = 0;
    // For the log: a client did something that needs a line (foreign protocol, flood, dropped, refused).
    virtual void clientRemark(const Client& client, const QString& text) = 0;

    // The protocol log is on: pass each line of a client, after it was carried out, to logExchange().
    [[nodiscard]] virtual bool isLoggingExchanges() const { return false; }
    virtual void logExchange(const Client& /*client*/, const Exchange& /*exchange*/) {}
};

}  // namespace boresight::rotctld
