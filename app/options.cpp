// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/options.h"

#include "core/base/bus_name.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/elements/element_address.h"
#include "core/profile/commissioning.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_store.h"
#include "core/profile/setting.h"

#include <QCommandLineParser>
#include <QDateTime>
#include <QDebug>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

namespace boresight::app {
namespace {

const std::string kSimulated = toString(BusName{});
const QString kProfile = QStringLiteral("profile");
const QString kBus = QStringLiteral("bus");
const QString kSimulate = QStringLiteral("simulate");
const QString kListen = QStringLiteral("listen");
const QString kElements = QStringLiteral("elements");
const QString kStateDir = QStringLiteral("state-dir");
const QString kStandingAt = QStringLiteral("standing-at");

QString timeOfNow()
{
    return QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyy-MM-ddTHH:mmZ"));
}

// For example "moteus (a moteus drive), simple (…)".
QString simulatedDrivers()
{
    QStringList all;
    for (const profile::DriverKind& kind : profile::kDriverKinds) {
        if (kind.driver != profile::AxisDriver::None) {
            all << QStringLiteral("%1 (%2)").arg(toQString(kind.name), toQString(kind.simulated));
        }
    }
    for (const profile::OtherDevice& other : profile::kOtherDevices) {
        all << QStringLiteral("%1 (%2)").arg(toQString(other.name), toQString(other.simulated));
    }
    return all.join(QStringLiteral(", "));
}

std::optional<Simulation> simulationNamed(std::string_view name)
{
    const auto* const other = std::ranges::find(profile::kOtherDevices, name, &profile::OtherDevice::name);
    if (other != profile::kOtherDevices.end()) {
        return Simulation{.on = true, .driver = other->driver, .device = other->device};
    }
    const auto* const kind = std::ranges::find(profile::kDriverKinds, name, &profile::DriverKind::name);
    return kind != profile::kDriverKinds.end() && kind->driver != profile::AxisDriver::None
               ? std::optional(Simulation{.on = true, .driver = kind->driver})
               : std::nullopt;
}

void addOptions(QCommandLineParser& parser)
{
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOption({kProfile,
                      QStringLiteral("Profile of the mount. Without it the current profile of the user is used, or the "
                                     "built-in reference mount."),
                      QStringLiteral("FILE")});
    parser.addOption({kBus, QStringLiteral("fdcanusb:PATH, socketcan:IFACE or simulated. Overrides the profile."),
                      QStringLiteral("BUS")});
    parser.addOption(
        {kSimulate, QStringLiteral("Use the built-in simulated mount, as with --bus simulated. --simulate=DRIVER: turn "
                                   "every axis by this driver: %1. Nothing is written to the profile of a real mount.")
                        .arg(simulatedDrivers())});
    parser.addOption({kListen, QStringLiteral("Address of the rotctld server. Port 0 picks a free port."),
                      QStringLiteral("HOST:PORT")});
    parser.addOption(
        {kElements,
         QStringLiteral("File, folder or https address with the elements of satellites, or celestrak:GROUP. May be "
                        "repeated. Overrides the profile."),
         QStringLiteral("PATH")});
    parser.addOption({kStateDir, QStringLiteral("Folder of the log, the position journal and the window layout."),
                      QStringLiteral("DIR")});
    parser.addOption(
        {kStandingAt,
         QStringLiteral("You looked at the mount at this time, and the axes stood at this azimuth and elevation, in "
                        "degrees of the axes. Boresight uses this once, at most 10 minutes later, and only if neither "
                        "drive nor position journal knows the cable wrap. Example: 405,50@%1")
             .arg(timeOfNow()),
         QStringLiteral("AZ,EL@UTC")});
}

// Takes the driver of "--simulate=DRIVER" out of the arguments, because QCommandLineParser has no options with an
// optional value.
Result<QStringList> takeSimulatedDriver(Options& options, const QStringList& arguments)
{
    const QString prefix = QStringLiteral("--simulate=");
    QStringList left;
    for (const QString& argument : arguments) {
        if (!argument.startsWith(prefix)) {
            left << argument;
            continue;
        }
        const std::string name = argument.sliced(prefix.size()).toStdString();
        const auto simulation = simulationNamed(name);
        if (!simulation) {
            return failure(ErrorCode::InvalidInput,
                           QStringLiteral("--simulate=%1 is unknown. Use --simulate for the drivers of the profile, or "
                                          "one of these after \"=\": %2")
                               .arg(toQString(name), simulatedDrivers()));
        }
        options.simulation = *simulation;
        left << QStringLiteral("--simulate");
    }
    return left;
}

Result<profile::Profile> readProfile(Options& options, const QCommandLineParser& parser)
{
    options.configDir = QStandardPaths::writableLocation(QStandardPaths::ConfigLocation) + QStringLiteral("/boresight");
    options.profilePath = parser.value(kProfile);
    if (parser.isSet(kProfile)) {
        return profile::loadProfile(options.profilePath);
    }
    return profile::ProfileStore(options.configDir)
        .findCurrent()
        .and_then([&](const std::optional<QString>& path) -> Result<profile::Profile> {
            options.profilePath = path.value_or(QString());
            return path ? profile::loadProfile(*path) : profile::Profile{};
        });
}

void useRealBus(Options& options, const std::string& bus)
{
    const bool namedNone = profile::namesNoBus(options.profile);
    options.profile.bus = bus;
    if (!namedNone) {
        return;
    }
    options.profile = profile::forRealMount(options.profile);
    if (!options.isFirstStart()) {
        qWarning().noquote() << QStringLiteral(
                                    "%1 is the profile of the simulated mount. Its zeros, north, pointing model and "
                                    "sensor are left out for %2. Confirm the directions of its axes.")
                                    .arg(options.profilePath, toQString(bus));
    }
}

// A profile without a real bus can only be simulated.
void warnSimulated(const Options& options)
{
    if (!options.isFirstStart() && options.simulation == Simulation::Off && profile::namesNoBus(options.profile)) {
        qWarning().noquote() << QStringLiteral(
                                    "%1 names no bus of a real mount, so the mount is simulated. Nothing of the "
                                    "simulation is written to this file. Set bus.name, use --bus, or choose the "
                                    "adapter in the guide of the window.")
                                    .arg(options.profilePath);
    }
}

Result<> applyBus(Options& options, const QCommandLineParser& parser)
{
    if (!parser.isSet(kBus) && !parser.isSet(kSimulate)) {
        return {};
    }
    const std::string bus = parser.isSet(kBus) ? parser.value(kBus).toStdString() : kSimulated;
    if (parser.isSet(kSimulate) && bus != kSimulated) {
        return failure(
            ErrorCode::InvalidInput,
            QStringLiteral("--simulate and --bus %1 exclude each other. Use one of them").arg(toQString(bus)));
    }
    return parseBusName(bus).map([&](const BusName& name) {
        if (name.kind != BusKind::Simulated) {
            useRealBus(options, bus);
        } else if (options.simulation == Simulation::Off) {
            options.simulation = Simulation::Reference;
        }
    });
}

Result<> fitsItsMount(const Options& options)
{
    if (options.simulationFor(options.profile) != Simulation::Off) {
        return {};
    }
    return profile::fitsRealMount(options.profile).map_error([&](Error error) {
        return Error{error.code, QStringLiteral("%1: %2").arg(options.profilePath, error.text)};
    });
}

Result<> applyListen(Options& options, const QCommandLineParser& parser)
{
    if (!parser.isSet(kListen)) {
        return {};
    }
    return profile::parseListenAddress(parser.value(kListen).toStdString())
        .map([&](const profile::ListenAddress& address) {
            options.profile.rotctld.listen = address;
            options.overridden.emplace_back("rotctld.listen");
        })
        .map_error([](Error error) {
            return Error{error.code, QStringLiteral("--listen: ") + error.text};
        });
}

Result<> applyElements(Options& options, const QCommandLineParser& parser)
{
    if (!parser.isSet(kElements)) {
        return {};
    }
    options.profile.orbit.elements.clear();
    for (const QString& value : parser.values(kElements)) {
        const std::string entry = value.toStdString();
        const bool isAddress = orbit::isElementAddress(entry);
        if (const auto address = orbit::parseElementAddress(entry); isAddress && !address) {
            return failure(address.error().code, QStringLiteral("--elements: ") + address.error().text);
        }
        options.profile.orbit.elements.push_back(isAddress ? entry : QFileInfo(value).absoluteFilePath().toStdString());
    }
    options.overridden.emplace_back("orbit.elements");
    return {};
}

Result<> applyStandingAt(Options& options, const QCommandLineParser& parser)
{
    if (!parser.isSet(kStandingAt)) {
        return {};
    }
    const QString text = parser.value(kStandingAt);
    const QString place = text.section(QLatin1Char('@'), 0, 0);
    const QStringList angles = place.split(QLatin1Char(','));
    const auto azimuth = parseFinite(angles.value(0).toStdString());
    const auto elevation = parseFinite(angles.value(1).toStdString());
    if (angles.size() != 2 || !azimuth || !elevation) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("--standing-at: two angles and a time like 405,50@%1 are expected, not \"%2\"")
                           .arg(timeOfNow(), text));
    }
    const QDateTime looked = QDateTime::fromString(text.section(QLatin1Char('@'), 1), Qt::ISODate);
    if (!looked.isValid() || looked.timeSpec() != Qt::UTC) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("--standing-at: the UTC time at which you looked is missing. If that was just "
                                      "now, write --standing-at %1@%2")
                           .arg(place, timeOfNow()));
    }
    options.standingAt =
        EnteredPlace{.place = {.azimuth = Angle::fromDegrees(*azimuth), .elevation = Angle::fromDegrees(*elevation)},
                     .looked = UtcTime(std::chrono::milliseconds(looked.toMSecsSinceEpoch()))};
    return {};
}

Result<QString> makeStateDir(const QCommandLineParser& parser)
{
    QString path = parser.value(kStateDir);
    if (path.isEmpty()) {
        path = qEnvironmentVariable("STATE_DIRECTORY");  // set by systemd
    }
    if (path.isEmpty()) {
        path = qEnvironmentVariable("XDG_STATE_HOME", QDir::homePath() + QStringLiteral("/.local/state")) +
               QStringLiteral("/boresight");
    }
    if (!QDir().mkpath(path)) {
        return failure(
            ErrorCode::Io,
            QStringLiteral("cannot make the state folder %1. Choose another one with --state-dir").arg(path));
    }
    return QDir(path).absolutePath();
}

}  // namespace

profile::Profile Options::startingProfile() const
{
    profile::Profile starting = profile;
    if (isFirstStart() && hasSensor(simulation, profile)) {
        starting.sensor.source = profile::SensorSource::Simulated;
    } else if (isFirstStart() && simulation == Simulation::Off) {
        starting.mount.directions = profile::Directions::Unconfirmed;
    }
    return starting;
}

tl::expected<Options, NoStart> readOptions(const QStringList& arguments, const QString& description)
{
    const auto byProfile = [](const Error& error) { return NoStart{error, true}; };
    const auto byArguments = [](const Error& error) { return NoStart{error, false}; };
    QCommandLineParser parser;
    parser.setApplicationDescription(description);
    addOptions(parser);
    Options options;
    const auto plain = takeSimulatedDriver(options, arguments);
    if (!plain) {
        return tl::unexpected(byArguments(plain.error()));
    }
    parser.process(*plain);
    if (!parser.positionalArguments().isEmpty()) {
        return tl::unexpected(byArguments(
            {ErrorCode::InvalidInput, QStringLiteral("\"%1\" is not an option. Options begin with --. See --help")
                                          .arg(parser.positionalArguments().constFirst())}));
    }
    return readProfile(options, parser)
        .map([&](const profile::Profile& profile) {
            options.profile = profile;
            if (const QString warning = profile::exposedSecret(profile, options.profilePath); !warning.isEmpty()) {
                qWarning().noquote() << warning;
            }
        })
        .map_error(byProfile)
        .and_then([&] { return applyBus(options, parser).map_error(byArguments); })
        .and_then([&] { return fitsItsMount(options).map_error(byProfile); })
        .and_then([&] { return applyListen(options, parser).map_error(byArguments); })
        .and_then([&] { return applyElements(options, parser).map_error(byArguments); })
        .and_then([&] { return applyStandingAt(options, parser).map_error(byArguments); })
        .and_then([&] { return makeStateDir(parser).map_error(byArguments); })
        .map([&](const QString& stateDir) {
            options.stateDir = stateDir;
            warnSimulated(options);
            return options;
        });
}

}  // namespace boresight::app
