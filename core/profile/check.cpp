// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of a profile beyond type and range.
#include "core/base/bus_name.h"
#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/listeners/listener.h"
#include "core/profile/commissioning.h"
#include "core/profile/setting_groups.h"
#include "core/rotctl/hamlib_setting.h"
#include "core/units/degrees_text.h"
#include "core/wind/wind_source.h"

#include <set>
#include <string>

namespace boresight::profile {

namespace {

// Coarser steps than 10° are no rotator that tracks a target.
constexpr double kFewestSteps = 36.0;

void checkAxis(std::vector<Problem>& problems, const std::string& table, const AxisSettings& axis, Angle park)
{
    const TravelRange& travel = axis.geometry.travel;
    if (axis.geometry.sign == 0) {
        problems.push_back({table + ".sign", Text::tr("1 or -1 is expected")});
    }
    if (travel.min >= travel.max) {
        problems.push_back({table + ".travel_min_deg",
                            Text::tr("%1 is not below %2.travel_max_deg (%3)")
                                .arg(degreesText(travel.min, 2), toQString(table), degreesText(travel.max, 2))});
    } else if (!travel.contains(park)) {
        problems.push_back({"park." + table + "_deg",
                            Text::tr("%1 is outside the travel %2…%3")
                                .arg(degreesText(park, 2), degreesText(travel.min, 2), degreesText(travel.max, 2))});
    }
    if (axis.stepsPerTurn > 0.0 && axis.stepsPerTurn < kFewestSteps) {
        problems.push_back({table + ".steps_per_turn",
                            Text::tr("must be 0 or at least %1").arg(toQString(formatFixed(kFewestSteps, 0)))});
    }
    // With a slower build-up, the axis would need a longer way to stop than a person at the mast expects.
    const Seconds filterLength{2.0 * (axis.limits.acceleration.radians() / axis.limits.jerk.radians())};
    if (filterLength > Seconds(2.0)) {
        problems.push_back(
            {table + ".max_jerk_deg_s3", Text::tr("must be at least max_acceleration_deg_s2 per second, here %1")
                                             .arg(toQString(formatFixed(axis.limits.acceleration.degrees(), 2)))});
    }
}

void checkDrivers(std::vector<Problem>& problems, const Profile& profile)
{
    if (profile.azimuth.driver == AxisDriver::None && profile.elevation.driver == AxisDriver::None) {
        problems.push_back({"elevation.driver", Text::tr("A mount needs at least one axis.")});
    }
}

void checkIds(std::vector<Problem>& problems, const Profile& profile)
{
    if (profile.azimuth.driver == profile.elevation.driver && kindOf(profile.azimuth.driver).hasId &&
        profile.azimuth.id == profile.elevation.id) {
        problems.push_back({"elevation.id", Text::tr("is the same as azimuth.id. Each controller needs its own id.")});
    }
}

// Hamlib would use the last of two values.
void checkHamlibSettings(std::vector<Problem>& problems, const Profile& profile)
{
    std::set<std::string> names;
    std::size_t bytes = 0;
    for (const std::string& text : profile.hamlibSettings) {
        bytes += text.size() + (bytes > 0 ? 1 : 0);  // rotctld joins them by commas
        const auto setting = rotctl::parseHamlibSetting(text);
        if (setting && !names.insert(setting->name).second) {
            problems.push_back({"bus.hamlib_settings", Text::tr("names %1 twice").arg(toQString(setting->name))});
        }
    }
    if (bytes > rotctl::kMostHamlibSettings) {
        problems.push_back(
            {"bus.hamlib_settings",
             Text::tr("has %1 bytes, with its commas. rotctld accepts at most %2 bytes. Remove a setting.")
                 .arg(bytes)
                 .arg(rotctl::kMostHamlibSettings)});
    }
}

listeners::Listener udpPort(const std::string& host, std::uint16_t port)
{
    listeners::Listener place{.host = host, .port = port};
    place.udp = true;
    return place;
}

// The ports that the station opens besides those of the listeners.
std::vector<listeners::Listener> otherPorts(const Profile& profile)
{
    std::vector<listeners::Listener> ports{{.host = profile.rotctld.listen.host, .port = profile.rotctld.listen.port}};
    if (profile.position.source == PositionSource::Udp) {
        ports.push_back(udpPort(profile.position.host, static_cast<std::uint16_t>(profile.position.port)));
    }
    if (profile.power.source == PowerSource::Udp) {
        ports.push_back(udpPort(profile.power.host, static_cast<std::uint16_t>(profile.power.port)));
    }
    const auto wind = wind::parseSource(profile.wind.source);
    if (wind && wind->kind == wind::SourceKind::Udp) {
        ports.push_back(udpPort(wind->place.toStdString(), wind->port));
    }
    return ports;
}

void checkListeners(std::vector<Problem>& problems, const Profile& profile)
{
    std::vector<listeners::Listener> seen = otherPorts(profile);
    for (const std::string& text : profile.listeners) {
        const auto listener = listeners::parseListener(text);
        if (!listener) {
            continue;  // the check of the setting reports it
        }
        if (std::ranges::any_of(seen, [&](const auto& one) { return listeners::collide(one, *listener); })) {
            problems.push_back({"listeners.list", Text::tr("The place %1 is already used. Each listener needs its own.")
                                                      .arg(toQString(listeners::placeOf(*listener)))});
        }
        seen.push_back(*listener);
    }
}

void checkSupervision(std::vector<Problem>& problems, const Profile& profile)
{
    const SupervisionSettings& supervision = profile.supervision;
    const auto demand = [&](bool right, const char* key, const QString& text) {
        if (!right) {
            problems.push_back({std::string("supervision.") + key, text});
        }
    };
    demand(supervision.followingHint <= supervision.followingStop, "following_hint_deg",
           Text::tr("must not be above %1").arg(QLatin1String("supervision.following_stop_deg")));
    demand(supervision.outsideHint <= supervision.outsideStop, "outside_hint_deg",
           Text::tr("must not be above %1").arg(QLatin1String("supervision.outside_stop_deg")));
    // Replies arrive once per tick, so a limit below two ticks would cause alarms all the time.
    demand(supervision.replyAge >= 2.0 * profile.control.tickPeriod(), "reply_age_s",
           Text::tr("is shorter than 2 ticks of control.tick_hz (%1 s)")
               .arg(toQString(formatFixed(2.0 * profile.control.tickPeriod().count(), 3))));
    demand(supervision.supplyStop < supervision.supplyLow, "supply_stop_v",
           Text::tr("must be below %1").arg(QLatin1String("supervision.supply_low_v")));
    demand(supervision.supplyLow < supervision.supplyHigh, "supply_low_v",
           Text::tr("must be below %1").arg(QLatin1String("supervision.supply_high_v")));
    demand(supervision.boardHot < supervision.boardLimit, "board_hot_c",
           Text::tr("must be below %1").arg(QLatin1String("supervision.board_limit_c")));
}

DriverLine lineOf(BusKind bus)
{
    switch (bus) {
        case BusKind::SocketCan:
        case BusKind::Fdcanusb:
            return DriverLine::Can;
        case BusKind::Serial:
        case BusKind::Tcp:
            return DriverLine::Text;
        case BusKind::Rotctld:
        case BusKind::Hamlib:
            return DriverLine::Rotctld;
        case BusKind::Simulated:
            break;
    }
    return DriverLine::None;
}

// The driver of this axis cannot use a bus of the kind that the profile names.
std::optional<Problem> wrongBus(const Profile& profile, const DriverKind& kind)
{
    const auto bus = parseBusName(profile.bus);
    if (!bus || kind.line == DriverLine::None || bus->kind == BusKind::Simulated) {
        return std::nullopt;
    }
    if (lineOf(bus->kind) == kind.line) {
        return std::nullopt;
    }
    const QString need =
        kind.line == DriverLine::Can    ? Text::tr("The driver \"%1\" needs fdcanusb:PATH or socketcan:INTERFACE.")
        : kind.line == DriverLine::Text ? Text::tr("The driver \"%1\" needs serial:PATH or tcp:HOST:PORT.")
                                        : Text::tr("The driver \"%1\" needs rotctld:HOST:PORT or hamlib:MODEL:PORT.");
    return Problem{"bus.name", need.arg(toQString(kind.name))};
}

// This rotctld is our own server. It would ask the mount, and the mount would ask it.
std::optional<Problem> ownServer(const Profile& profile)
{
    const auto bus = parseBusName(profile.bus);
    const ListenAddress& own = profile.rotctld.listen;
    if (!bus || !isOwnServer(*bus, own)) {
        return std::nullopt;
    }
    return Problem{"bus.name",
                   Text::tr("At %1 Boresight itself listens for programs (rotctld.listen). Start the rotctld of the "
                            "rotator on another port, for example rotctld -t 4534.")
                       .arg(toQString(toText(own)))};
}

// A profile has one bus.
std::optional<Problem> twoBuses(const Profile& profile)
{
    const DriverKind& azimuth = kindOf(profile.azimuth.driver);
    const DriverKind& elevation = kindOf(profile.elevation.driver);
    const bool both = azimuth.line != DriverLine::None && elevation.line != DriverLine::None;
    if (!both || azimuth.line == elevation.line || namesNoBus(profile)) {
        return std::nullopt;
    }
    return Problem{"elevation.driver",
                   Text::tr("\"%1\" and azimuth.driver \"%2\" need two buses, and bus.name names only one. Choose one "
                            "driver for both axes, or \"none\" for one of them.")
                       .arg(toQString(elevation.name), toQString(azimuth.name))};
}

template <class Row>
void checkRow(std::vector<Problem>& problems, const std::string& prefix, std::span<const SettingOf<Row>> all, Row row)
{
    for (const SettingOf<Row>& setting : all) {
        if (const auto done = setting.counts(row) ? setting.set(row, setting.get(row)) : Result<>{}; !done) {
            problems.push_back({prefix + setting.key, done.error().text});
        }
    }
}

template <class Row>
void checkRows(std::vector<Problem>& problems, std::string_view list, std::span<const SettingOf<Row>> all,
               const std::vector<Row>& rows)
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        checkRow(problems, std::string(list) + "[" + std::to_string(i + 1) + "].", all, rows[i]);
    }
}

}  // namespace

std::vector<Problem> crossCheck(const Profile& profile)
{
    std::vector<Problem> problems;
    checkDrivers(problems, profile);
    checkAxis(problems, "azimuth", profile.azimuth, profile.park.azimuth);
    checkAxis(problems, "elevation", profile.elevation, profile.park.elevation);
    checkIds(problems, profile);
    checkFurtherBoards(problems, profile);
    checkHamlibSettings(problems, profile);
    // Two lost frames in a row must not stop the mount. The small slack is for rounding (0.05 s at 60 Hz).
    if (3.0 * profile.control.tickPeriod() > profile.control.watchdog + Seconds(1e-9)) {
        problems.push_back(
            {"control.watchdog_s", Text::tr("is shorter than 3 ticks of control.tick_hz (%1 s)")
                                       .arg(toQString(formatFixed(3.0 * profile.control.tickPeriod().count(), 3)))});
    }
    if (profile.jog.slow > profile.jog.normal || profile.jog.normal > profile.jog.fast) {
        problems.push_back({"jog.normal_deg_s", Text::tr("must lie between jog.slow_deg_s and jog.fast_deg_s")});
    }
    if (profile.rotctld.control == ControlRule::Locked && profile.rotctld.lockedTo.empty()) {
        problems.push_back({"rotctld.locked_to", Text::tr("is needed while rotctld.lead is \"locked\"")});
    }
    checkBroker(problems, profile);
    checkListeners(problems, profile);
    checkGeometry(problems, profile);
    checkRegion(problems, profile);
    checkAntennas(problems, profile);
    checkSupervision(problems, profile);
    checkSatellites(problems, profile);
    checkSchedule(problems, profile);
    checkSensor(problems, profile);
    checkPower(problems, profile);
    checkTransmit(problems, profile);
    checkBrake(problems, profile);
    checkEndSwitches(problems, profile);
    checkPosition(problems, profile);
    checkWind(problems, profile);
    return problems;
}

std::vector<Problem> problemsOf(const Profile& profile)
{
    std::vector<Problem> problems;
    checkRow(problems, "", settings(), profile);
    checkRows(problems, kHorizonKey, horizonSettings(), profile.limits.horizon);
    checkRows(problems, kKeepOutKey, keepOutSettings(), profile.limits.keepOuts);
    checkRows(problems, kPresetKey, presetSettings(), profile.presets);
    checkRows(problems, kSatelliteKey, satelliteSettings(), profile.satellites);
    checkRows(problems, kAntennaKey, antennaSettings(), profile.antennas);
    checkRows(problems, kWatchKey, watchSettings(), profile.schedule.watch);
    for (Problem& problem : crossCheck(profile)) {
        problems.push_back(std::move(problem));
    }
    return problems;
}

std::vector<Problem> problemsOfReal(const Profile& profile)
{
    std::vector<Problem> problems = problemsOf(profile);
    if (profile.sensor.source == SensorSource::Simulated) {
        problems.push_back({"sensor.source", Text::tr("\"simulated\" needs the simulated mount (bus.name)")});
    }
    if (auto own = ownServer(profile)) {
        problems.push_back(*std::move(own));
    }
    const auto two = twoBuses(profile);
    if (two) {
        problems.push_back(*two);
    }
    for (const Axis axis : kAxes) {
        const DriverKind& kind = kindOf(profile.axis(axis).driver);
        if (kind.onlySimulated) {
            problems.push_back(
                {axis == Axis::Azimuth ? "azimuth.driver" : "elevation.driver",
                 Text::tr("\"%1\" is only simulated. Start Boresight with --simulate.").arg(toQString(kind.name))});
        }
        if (auto wrong = wrongBus(profile, kind); wrong && !two) {
            problems.push_back(*std::move(wrong));
        }
    }
    return problems;
}

Result<> fitsRealMount(const Profile& profile)
{
    const std::vector<Problem> problems = problemsOfReal(profile);
    return problems.empty() ? Result<>{} : failure(ErrorCode::InvalidInput, toText(problems.front()));
}

Result<ListenAddress> parseListenAddress(std::string_view text)
{
    const auto colon = text.rfind(':');
    const auto port = colon == std::string_view::npos ? std::nullopt : parseInteger(text.substr(colon + 1));
    if (!port || *port < 0 || *port > 65535) {
        return failure(ErrorCode::InvalidInput, Text::tr("HOST:PORT with a port of 0…65535 is expected"));
    }
    std::string_view host = text.substr(0, colon);
    const bool bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
    if (bracketed) {
        host = host.substr(1, host.size() - 2);
    }
    const bool isIpv6 = host.find(':') != std::string_view::npos;
    const bool odd = host.find_first_of(" []") != std::string_view::npos || hasControlCharacters(host);
    if (host.empty() || odd || isIpv6 != bracketed) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("a host name or address is expected before the port, IPv6 in brackets"));
    }
    return ListenAddress{.host = std::string(host), .port = static_cast<std::uint16_t>(*port)};
}

bool isOwnServer(const BusName& rotctld, const ListenAddress& own)
{
    const auto isHere = [](const std::string& host) {
        return host == "localhost" || host == "::1" || host.starts_with("127.");
    };
    const bool takesAll = own.host == "0.0.0.0" || own.host == "::";
    const bool here = isHere(rotctld.target) && (isHere(own.host) || takesAll);
    return rotctld.kind == BusKind::Rotctld && rotctld.port == own.port && (here || rotctld.target == own.host);
}

std::string toText(const ListenAddress& address)
{
    const bool isIpv6 = address.host.find(':') != std::string::npos;
    return (isIpv6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

}  // namespace boresight::profile
