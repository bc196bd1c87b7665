// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/simulate_options.h"

#include "app/boresightctl/option_reader.h"
#include "app/boresightctl/sensor_option.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/profile/setting.h"
#include "core/sim/injection_option.h"

namespace boresight::ctl {
namespace {

tl::unexpected<Error> refuse(const QString& text)
{
    return failure(ErrorCode::InvalidInput, text);
}

Result<> takeText(const std::string& name, OptionReader& reader, std::string& text)
{
    text = reader.takeValue().value_or("");
    return text.empty() ? refuse(QStringLiteral("--%1 needs a value").arg(toQString(name))) : Result<>();
}

Result<> takeId(const std::string& name, OptionReader& reader, std::optional<int>& id)
{
    const std::string text = reader.takeValue().value_or("");
    const std::optional<std::int64_t> number = parseInteger(text);
    if (!number || *number < 1 || *number > 126) {
        return refuse(QStringLiteral("--%1 \"%2\": expected an id, 1…126").arg(toQString(name), toQString(text)));
    }
    id = static_cast<int>(*number);
    return {};
}

Result<> takeInjection(const sim::InjectionOption& option, OptionReader& reader, SimulateOptions& options)
{
    const std::string text = reader.takeValue().value_or("");
    return sim::parseInjection(option, text).map([&](const sim::Injection& one) {
        options.injections.push_back(one);
        options.faults.push_back(text.empty() ? std::string(option.name) : std::string(option.name) + ' ' + text);
    });
}

Result<> takeBroker(OptionReader& reader, SimulateOptions& options)
{
    const std::string text = reader.takeValue().value_or("");
    const bool namesPort = text.rfind(':') != std::string::npos && !text.ends_with(']');
    const auto address = profile::parseListenAddress(namesPort ? text : text + ":1883");
    if (!address || address->port == 0) {
        return refuse(QStringLiteral("--sensor-mqtt \"%1\": expected HOST[:PORT]").arg(toQString(text)));
    }
    // A client name of its own. With the name of the firmware, the broker would disconnect a real sensor.
    options.sensorBroker = mqtt::Broker{.host = QString::fromStdString(address->host), .port = address->port};
    return {};
}

// Topics begin with this text. "+" and "#" are wildcards, so they are refused.
Result<> takeTopics(OptionReader& reader, SimulateOptions& options)
{
    return takeText("sensor-topics", reader, options.sensorTopics).and_then([&]() -> Result<> {
        return options.sensorTopics.find_first_of("+#") == std::string::npos
                   ? Result<>()
                   : refuse(QStringLiteral("--sensor-topics \"%1\": a topic to write to must not have + or #")
                                .arg(toQString(options.sensorTopics)));
    });
}

Result<> takeSwitch(const std::string& name, OptionReader& reader, bool& state)
{
    state = true;
    return reader.hasUnusedValue() ? refuse(QStringLiteral("--%1 takes no value").arg(toQString(name))) : Result<>();
}

// Empty if the sensor has no option of this name.
std::optional<Result<>> takeOptionOfSensor(const std::string& name, OptionReader& reader, SimulateOptions& options)
{
    if (name == "sensor") {
        return takeText(name, reader, options.sensor);
    }
    if (name == "sensor-mqtt") {
        return takeBroker(reader, options);
    }
    if (name.starts_with("sensor-")) {
        options.ofSensor = name;
    }
    if (name == "sensor-topics") {
        return takeTopics(reader, options);
    }
    if (name == "sensor-orientation-only") {
        return takeSwitch(name, reader, options.orientationOnly);
    }
    if (const SensorOption* const option = findSensorOption(name)) {
        return takeSensorOption(*option, reader.takeValue().value_or(""), options.sensorTruth);
    }
    return std::nullopt;
}

Result<> takeStation(OptionReader& reader, SimulateOptions& options)
{
    const auto address = profile::parseListenAddress(reader.takeValue().value_or(""));
    if (!address || address->port == 0) {
        return refuse(QStringLiteral("--station: expected HOST:PORT like localhost:4533"));
    }
    options.station = *address;
    return {};
}

Result<> takeOption(const std::string& name, OptionReader& reader, SimulateOptions& options)
{
    if (name == "pty") {
        return takeText(name, reader, options.pty);
    }
    if (name == "can") {
        return takeText(name, reader, options.can);
    }
    if (name == "station") {
        return takeStation(reader, options);
    }
    if (name == "end-faults") {
        return takeSwitch(name, reader, options.endFaults);
    }
    if (name == "az-id") {
        return takeId(name, reader, options.azimuthId);
    }
    if (name == "el-id") {
        return takeId(name, reader, options.elevationId);
    }
    if (name == "factory" || name == "print-truth") {
        return takeSwitch(name, reader, name == "factory" ? options.factory : options.printTruth);
    }
    if (const auto taken = takeOptionOfSensor(name, reader, options)) {
        return *taken;
    }
    if (const sim::InjectionOption* const option = sim::findInjectionOption(name)) {
        return takeInjection(*option, reader, options);
    }
    return refuse(QStringLiteral("there is no option --%1").arg(toQString(name)));
}

// A running station has its mount already, so it takes faults only.
Result<> checkForStation(const SimulateOptions& options)
{
    const bool isMore = !options.pty.empty() || !options.can.empty() || options.hasSensor() ||
                        !options.ofSensor.empty() || options.azimuthId || options.elevationId || options.factory ||
                        options.printTruth;
    if (isMore) {
        return refuse(QStringLiteral("--station takes faults and --end-faults only"));
    }
    return options.faults.empty() && !options.endFaults
               ? refuse(QStringLiteral("--station needs a fault, for example --wind az:60+3, or --end-faults"))
               : Result<>();
}

Result<> check(const SimulateOptions& options)
{
    if (options.station) {
        return checkForStation(options);
    }
    if (options.endFaults) {
        return refuse(QStringLiteral("--end-faults needs --station"));
    }
    if (options.pty.empty() == options.can.empty()) {
        return refuse(QStringLiteral("use either --pty PATH, --can IFACE or --station HOST:PORT"));
    }
    if (!options.sensor.empty() && options.sensor == options.pty) {
        return refuse(QStringLiteral("--sensor and --pty name the same file"));
    }
    if (!options.ofSensor.empty() && !options.hasSensor()) {
        return refuse(QStringLiteral("--%1 needs --sensor or --sensor-mqtt").arg(toQString(options.ofSensor)));
    }
    const sim::PairSettings pair = options.pairSettings();
    if (!options.factory && pair.azimuth.config.id == pair.elevation.config.id) {
        return refuse(
            QStringLiteral(
                "both drives would have id %1: set --az-id or --el-id. To simulate this fault, use --duplicate-id")
                .arg(pair.azimuth.config.id));
    }
    for (const sim::Injection& injection : options.injections) {
        if (sim::isOfAdapter(injection.kind) && options.pty.empty()) {
            return refuse(QStringLiteral("faults of the adapter need --pty: a CAN interface has no adapter (%1)")
                              .arg(toQString(sim::describe(injection))));
        }
    }
    return {};
}

}  // namespace

sim::PairSettings SimulateOptions::pairSettings() const
{
    sim::PairSettings settings = factory ? sim::factoryPair() : sim::commissionedPair();
    settings.azimuth.config.id = azimuthId.value_or(settings.azimuth.config.id);
    settings.elevation.config.id = elevationId.value_or(settings.elevation.config.id);
    return settings;
}

Result<SimulateOptions> parseSimulateOptions(Arguments arguments)
{
    SimulateOptions options;
    OptionReader reader(arguments);
    while (!reader.atEnd()) {
        const Result<> taken =
            reader.takeName().and_then([&](const std::string& name) { return takeOption(name, reader, options); });
        if (!taken) {
            return tl::unexpected(taken.error());
        }
    }
    return check(options).map([&] { return options; });
}

}  // namespace boresight::ctl
