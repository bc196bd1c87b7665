// SPDX-License-Identifier: GPL-3.0-or-later
// The `conf` commands.
#include "core/sim/console_commands.h"

#include <set>

namespace boresight::sim::console {
namespace {

std::string_view groupOf(std::string_view key)
{
    return key.substr(0, key.find('.'));
}

std::string_view keyError(DriveConfig& config, std::string_view key, std::string_view withinGroup)
{
    bool known = false;
    visitFields(config, [&](std::string_view name, ConfigField) { known = known || groupOf(name) == groupOf(key); });
    return known ? withinGroup : "unknown group";
}

ArchiveValue archived(const ConfigField& field)
{
    if (const auto* number = std::get_if<double*>(&field)) {
        return static_cast<float>(**number);
    }
    if (const auto* number = std::get_if<int*>(&field)) {
        return ArchiveSigned{.value = **number, .width = 4};
    }
    if (const auto* flag = std::get_if<bool*>(&field)) {
        return **flag;
    }
    return ArchiveArray{.values = {*std::get<std::uint8_t*>(field)}, .width = 1};
}

// The fields of one group. Keys with consecutive numbers become one array.
std::vector<ArchiveField> archivedGroup(DriveConfig& config, std::string_view group)
{
    std::vector<ArchiveField> fields;
    visitFields(config, [&](std::string_view key, ConfigField field) {
        if (groupOf(key) != group) {
            return;
        }
        std::string name(key.substr(group.size() + 1));
        ArchiveValue value = archived(field);
        auto* element = std::get_if<ArchiveArray>(&value);
        if (element != nullptr) {
            name.resize(name.rfind('.'));
            if (!fields.empty() && fields.back().name == name) {
                std::get<ArchiveArray>(fields.back().value).values.push_back(element->values.front());
                return;
            }
        }
        fields.push_back({std::move(name), std::move(value)});
    });
    return fields;
}

std::string set(ConsoleDevice& device, std::string_view rest)
{
    const std::string_view key = takeWord(rest);
    if (!setConfigText(device.config(), key, takeWord(rest))) {
        return refusal(keyError(device.config(), key, "error setting"));
    }
    device.configChanged(groupOf(key));
    return std::string(kOk);
}

std::string enumerate(ConsoleDevice& device, std::string_view group)
{
    std::string text;
    visitFields(device.config(), [&](std::string_view key, ConfigField) {
        if (group.empty() || groupOf(key) == group) {
            text += std::string(key) + " " + configText(device.config(), key).value_or("") + "\r\n";
        }
    });
    return text.empty() ? refusal("unknown group") : text.append(kOk);
}

std::string binary(ConsoleDevice& device, std::string_view command, std::string_view group)
{
    if (command == "list") {
        std::string text;
        std::set<std::string, std::less<>> seen;
        visitFields(device.config(), [&](std::string_view key, ConfigField) {
            if (seen.emplace(groupOf(key)).second) {
                text += std::string(groupOf(key)) + "\r\n";
            }
        });
        return text.append(kOk);
    }
    const std::vector<ArchiveField> fields = archivedGroup(device.config(), group);
    if (fields.empty()) {
        return refusal("unknown group");
    }
    const std::string block = command == "schema" ? binarySchema(fields) : binaryData(fields);
    return "c" + std::string(command) + " " + std::string(group) + "\r\n" + lengthBytes(block.size()) + block;
}

}  // namespace

std::string config(ConsoleDevice& device, std::string_view command, std::string_view rest)
{
    if (command == "get") {
        const Result<std::string> text = configText(device.config(), rest);
        return text ? *text + "\r\n" : refusal(keyError(device.config(), rest, "error reading"));
    }
    if (command == "set") {
        return set(device, rest);
    }
    if (command == "enumerate") {
        return enumerate(device, takeWord(rest));
    }
    if (command == "list" || command == "schema" || command == "data") {
        return binary(device, command, takeWord(rest));
    }
    if (command == "write") {
        device.storeConfig();
    } else if (command == "load") {
        device.loadConfig();
    } else if (command == "default") {
        device.defaultConfig();
    } else {
        return refusal("unknown subcommand");
    }
    return std::string(kOk);
}

}  // namespace boresight::sim::console
