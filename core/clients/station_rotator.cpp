// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clients/station_rotator.h"

#include "core/base/numbers.h"
#include "core/base/peer_address.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/clients/target_reading.h"
#include "core/units/degrees_text.h"

#include <algorithm>

namespace boresight {
namespace {

// Hamlib compares in single precision, so its clients may send 450.00001 for 450. The error is at most this tolerance.
constexpr Angle kLimitTolerance = Angle::fromDegrees(1e-4);
constexpr int kFastestSpeed = 100;
constexpr int kFastestLevel = 4;
// A tracking client sends one target a second. More lines would only push others out of the log.
constexpr int kCommandsPerSecond = 2;
constexpr int kRemarksPerSecond = 20;
constexpr int kRefusalsPerSecond = 4;
constexpr int kConnectionsPerSecond = 4;

// `below` and `above` have %1 for the value and %2 for the limit.
Result<> inside(Angle value, Angle min, Angle max, const QString& below, const QString& above)
{
    if (value < min - kLimitTolerance) {
        return failure(ErrorCode::OutOfRange, below.arg(degreesText(value, 2), degreesText(min, 2)));
    }
    if (value > max + kLimitTolerance) {
        return failure(ErrorCode::OutOfRange, above.arg(degreesText(value, 2), degreesText(max, 2)));
    }
    return {};
}

// A value just outside the range becomes its end: 90.00001° means 90°, not a flip over the top.
Angle snapped(Angle value, Angle min, Angle max)
{
    const Angle inRange = std::clamp(value, min, max);
    return abs(value - inRange) <= kLimitTolerance ? inRange : value;
}

// The true angles that an axis can reach. A little too wide: a client must not hold back a reachable target.
TravelRange trueRange(const TravelRange& travel, Angle offset, Angle rest)
{
    return {.min = travel.min + offset - rest, .max = travel.max + offset + rest};
}

// The directions that X and Y reach: every azimuth, and elevations from where X ends to the zenith.
rotctld::Limits limitsOfXY(const TravelRange& x, profile::AzimuthConvention convention)
{
    const bool fromNorth = convention == profile::AzimuthConvention::ZeroTo360;
    return {.minAzimuth = fromNorth ? 0_deg : -180_deg,
            .maxAzimuth = fromNorth ? 360_deg : 180_deg,
            .minElevation = std::min(0_deg, 90_deg - std::max(-x.min, x.max)),
            .maxElevation = 90_deg};
}

// The elevations of an axis that ends at the zenith stay at or below 90°, even if the mast leans.
TravelRange trueElevations(const TravelRange& travel, const pointing::PointingTerms& terms)
{
    const Angle rest = pointing::PointingModel(terms).skew() + abs(terms.elevationSag);
    TravelRange range = trueRange(travel, terms.elevationOffset, rest);
    if (travel.max + terms.elevationOffset <= 90_deg) {
        range.max = std::min(range.max, 90_deg);
    }
    return range;
}

}  // namespace

Source clientSource(const rotctld::Client& client)
{
    return {.kind = SourceKind::Client,
            .clientId = client.id,
            .name = (client.protocol == "rotctld" ? QString() : QStringLiteral("client ")) +
                    toQString(client.protocol + " " + client.address)};
}

StationRotator::StationRotator(StationControl& control, const profile::InForce& profile, EventLog& log,
                               const Clock& clock)
    : m_control(control),
      m_profile(profile),
      m_remarks(log, clock, kRemarksPerSecond),
      m_refusals(log, clock, kRefusalsPerSecond),
      m_commands(log, clock, kCommandsPerSecond),
      m_points(log, clock, StreamLog::Answer::Accepted),
      m_refusedPoints(log, clock, StreamLog::Answer::Refused),
      m_connections(log, clock, kConnectionsPerSecond)
{}

std::string StationRotator::info() const
{
    return "Boresight " + std::string(kVersion) + ", " + m_profile->mount.name;
}

rotctld::Limits StationRotator::limits() const
{
    if (model().isXY()) {
        return limitsOfXY(m_profile->azimuth.geometry.travel, m_profile->rotctld.azimuth);
    }
    const pointing::PointingTerms terms = m_profile->termsOf(m_control.antenna());
    const TravelRange azimuth =
        trueRange(m_profile->azimuth.geometry.travel, terms.azimuthOffset.wrapped180(), model().skew());
    const TravelRange elevation = trueElevations(m_profile->elevation.geometry.travel, terms);
    rotctld::Limits limits{.minAzimuth = azimuth.min,
                           .maxAzimuth = azimuth.max,
                           .minElevation = elevation.min,
                           .maxElevation = elevation.max};
    // Clients check a target against these limits before they send it. Every azimuth of their convention is a valid
    // direction here, so the limits cover the whole convention, however the cable wrap is counted.
    if (m_profile->rotctld.azimuth == profile::AzimuthConvention::ZeroTo360) {
        limits.minAzimuth = std::min(limits.minAzimuth, 0_deg);
        limits.maxAzimuth = std::max(limits.maxAzimuth, 360_deg);
    } else if (m_profile->rotctld.azimuth == profile::AzimuthConvention::PlusMinus180) {
        limits.minAzimuth = std::min(limits.minAzimuth, -180_deg);
        limits.maxAzimuth = std::max(limits.maxAzimuth, 180_deg);
    }
    return limits;
}

Result<SkyPointing> StationRotator::position(const rotctld::Client& client)
{
    if (client.keepsControlByReading) {
        m_control.positionRead(client.id);
    }
    return m_control.measured().map([this](AxisPosition axes) {
        // The client gets the position without the operator's trim. Otherwise the client would correct the trim away.
        if (const auto trim = m_control.trimInUse()) {
            axes = {axes.azimuth - trim->azimuth, axes.elevation - trim->elevation};
        }
        return inConvention(model().toSky(axes));
    });
}

Result<SkyPointing> StationRotator::target() const
{
    return m_control.measured().map([this](const AxisPosition&) {
        const auto& asked = m_control.askedPoint();
        return asked ? inConvention(*asked) : limits().nearest(inConvention(model().toSky(m_control.untrimmedGoal())));
    });
}

SkyPointing StationRotator::inConvention(const SkyPointing& beam) const
{
    switch (m_profile->rotctld.azimuth) {
        case profile::AzimuthConvention::ZeroTo360:
            return {.azimuth = beam.azimuth.wrapped360(), .elevation = beam.elevation};
        case profile::AzimuthConvention::PlusMinus180:
            return {.azimuth = beam.azimuth.wrapped180(), .elevation = beam.elevation};
        case profile::AzimuthConvention::Continuous:
            break;
    }
    return beam;
}

rotctld::MotionFlags StationRotator::motion() const
{
    const StationStatus status = m_control.status();
    const auto moves = [](const AxisStatus& axis, double sign) {
        return axis.state == AxisState::Moving && axis.commandedRate && *axis.commandedRate * sign > AngularRate{};
    };
    const auto atEnd = [](const AxisStatus& axis, Angle end) {
        return axis.state == AxisState::Limit && axis.actual && abs(*axis.actual - end) < 1_deg;
    };
    return {.movingLeft = moves(status.azimuth, -1.0),
            .movingRight = moves(status.azimuth, 1.0),
            .movingUp = moves(status.elevation, 1.0),
            .movingDown = moves(status.elevation, -1.0),
            .limitLeft = atEnd(status.azimuth, status.azimuth.travel.min),
            .limitRight = atEnd(status.azimuth, status.azimuth.travel.max),
            .limitUp = atEnd(status.elevation, status.elevation.travel.max),
            .limitDown = atEnd(status.elevation, status.elevation.travel.min)};
}

Result<> StationRotator::permitted(const rotctld::PointRequest& request) const
{
    if (m_profile->rotctld.outsideLimits != profile::OutsideLimits::Refuse) {
        return {};
    }
    const rotctld::Limits range = limits();
    return inside(request.azimuth, range.minAzimuth, range.maxAzimuth, Text::tr("azimuth %1 below limit %2"),
                  Text::tr("azimuth %1 above limit %2"))
        .and_then([&] {
            return inside(request.elevation, range.minElevation, range.maxElevation,
                          Text::tr("elevation %1 below limit %2"), Text::tr("elevation %1 above limit %2"));
        });
}

// The axis angles that a client with a continuous azimuth means. Empty if they are outside the travel.
std::optional<AxisPosition> StationRotator::placeOf(const SkyPointing& continuous) const
{
    const TravelRange& azimuths = m_profile->azimuth.geometry.travel;
    const TravelRange& elevations = m_profile->elevation.geometry.travel;
    const AxisPosition axes = model().toAxes(continuous).axes;
    const AxisPosition place{.azimuth = snapped(axes.azimuth, azimuths.min, azimuths.max),
                             .elevation = snapped(axes.elevation, elevations.min, elevations.max)};
    return azimuths.contains(place.azimuth) && elevations.contains(place.elevation) ? std::optional(place)
                                                                                    : std::nullopt;
}

Result<QString> StationRotator::pointTo(const rotctld::Client& client, const rotctld::PointRequest& request)
{
    const QString command =
        QStringLiteral("P %1 %2").arg(request.azimuth.degrees(), 0, 'f', 2).arg(request.elevation.degrees(), 0, 'f', 2);
    if (const Result<> allowed = permitted(request); !allowed) {
        m_control.clientAsked(clientSource(client));
        logRefusal(client, command, allowed.error());
        return tl::unexpected(allowed.error());
    }
    const rotctld::Limits range = limits();
    const Angle azimuth = snapped(request.azimuth, range.minAzimuth, range.maxAzimuth);
    const Angle elevation = snapped(request.elevation, range.minElevation, range.maxElevation);
    const SkyPointing direction{.azimuth = azimuth, .elevation = elevation};
    const bool counted = m_profile->rotctld.azimuth == profile::AzimuthConvention::Continuous;
    const auto place = counted ? placeOf(direction) : std::nullopt;
    return (place ? ask(client, request::PointAxes{*place}, command)
                  : ask(client, request::PointSky{direction}, command))
        .map([&] { return becameOf(request); });
}

QString StationRotator::becameOf(const rotctld::PointRequest& request) const
{
    const auto place = m_control.streamGoal();
    if (!place) {
        return {};
    }
    const SkyPointing asked{.azimuth = request.azimuth, .elevation = request.elevation};
    return targetReading(asked, inConvention(model().toSky(*place)), m_control.limitedReason());
}

Result<> StationRotator::move(const rotctld::Client& client, rotctld::MoveDirection direction, int speed)
{
    const AngularRate fastest = m_profile->jog.fast;
    const AngularRate rate = speed > 0 ? fastest * (std::min(speed, kFastestSpeed) / double{kFastestSpeed})
                                       : fastest * (m_speedLevel / double{kFastestLevel});
    return turn(client, direction, rate);
}

Result<QString> StationRotator::moveAt(const rotctld::Client& client, rotctld::MoveDirection direction,
                                       AngularRate rate)
{
    const AngularRate fastest = m_profile->jog.fast;
    return turn(client, direction, std::min(rate, fastest)).map([&] {
        return rate > fastest ? Text::tr("turns at %1°/s, the fastest jog rate").arg(fastest.degrees(), 0, 'f', 1)
                              : QString();
    });
}

Result<> StationRotator::turn(const rotctld::Client& client, rotctld::MoveDirection direction, AngularRate rate)
{
    AxisRates rates;
    switch (direction) {
        case rotctld::MoveDirection::Up:
            rates.elevation = rate;
            break;
        case rotctld::MoveDirection::Down:
            rates.elevation = -rate;
            break;
        case rotctld::MoveDirection::Left:
            rates.azimuth = -rate;
            break;
        case rotctld::MoveDirection::Right:
            rates.azimuth = rate;
            break;
    }
    return ask(client, request::Move{rates}, QStringLiteral("M"));
}

Result<> StationRotator::stop(const rotctld::Client& client)
{
    return ask(client, request::Hold{}, QStringLiteral("S"));
}

Result<> StationRotator::park(const rotctld::Client& client)
{
    return ask(client, request::Park{}, QStringLiteral("K"));
}

Result<> StationRotator::reset(const rotctld::Client& client, int)
{
    if (m_control.faultLatched() || m_control.waitsSinceRearm(clientSource(client))) {
        return ask(client, request::Rearm{}, QStringLiteral("R"));
    }
    return m_control.measured().map([](const AxisPosition&) {});  // nothing to re-arm: only check that the drives reply
}

Result<> StationRotator::setSpeedLevel(const rotctld::Client& client, int level)
{
    if (level < 1 || level > kFastestLevel) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("SPEED is 1 to 4"));
    }
    if (const Result<> may = m_control.mayCommand(clientSource(client)); !may) {
        logRefusal(client, QStringLiteral("V SPEED"), may.error());
        return may;
    }
    m_speedLevel = level;
    return {};
}

Result<> StationRotator::ask(const rotctld::Client& client, const Request& request, const QString& command)
{
    Result<> answer = m_control.request(request, clientSource(client));
    const QString name = clientSource(client).name;
    const bool point =
        std::holds_alternative<request::PointSky>(request) || std::holds_alternative<request::PointAxes>(request);
    if (!answer) {
        if (!point || m_refusedPoints.begins(name, command, answer.error().text)) {
            logRefusal(client, command, answer.error());
        }
        return answer;
    }
    m_refusedPoints.gone(name);
    if (!point || m_points.begins(name, command)) {
        m_commands.add(Severity::Advisory, name, Text::tr("%1 accepted").arg(command));
    }
    return answer;
}

void StationRotator::logRefusal(const rotctld::Client& client, const QString& command, const Error& error)
{
    m_refusals.add(Severity::Warning, clientSource(client).name, Text::tr("%1 refused: %2").arg(command, error.text));
}

void StationRotator::clientConnected(const rotctld::Client& client)
{
    m_connections.add(Severity::Advisory, clientSource(client).name, Text::tr("connected"));
    m_control.clientCame(clientSource(client), boresight::hostOf(client.address), client.readsOnly);
}

void StationRotator::clientGone(const rotctld::Client& client, const QString& reason)
{
    m_points.gone(clientSource(client).name);
    m_refusedPoints.gone(clientSource(client).name);
    m_connections.add(Severity::Advisory, clientSource(client).name, Text::tr("disconnected: %1").arg(reason));
    m_control.sourceGone(clientSource(client));
}

void StationRotator::clientRemark(const rotctld::Client& client, const QString& text)
{
    m_remarks.add(Severity::Warning, clientSource(client).name, text);
}

}  // namespace boresight
