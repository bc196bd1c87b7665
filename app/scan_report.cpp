// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scan_report.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/moteus/describe.h"
#include "core/moteus/faults.h"

#include <algorithm>
#include <map>
#include <set>

namespace boresight::app {
namespace {

using moteus::Register;

using Row = std::vector<std::string>;

const Row kHead{"id", "UUID", "firmware", "map", "mode", "fault", "voltage", "temperature", "position", "reference"};

std::string withUnit(const moteus::Reply& known, Register reg, int decimals, const std::string& unit)
{
    const std::optional<double> value = known.value(reg);
    return value ? formatFixed(*value, decimals) + ' ' + unit : "?";
}

std::string wholeText(const moteus::Reply& known, Register reg)
{
    const std::optional<double> value = known.value(reg);
    return value ? formatFixed(*value, 0) : "?";
}

// The code is a fault in mode 1 only. In other modes it may name the active limit.
std::string faultColumn(const moteus::Reply& known)
{
    const std::optional<int> code = known.fault();
    if (!code) {
        return "?";
    }
    const std::string name(moteus::faultText(*code).name);
    if (known.mode() == moteus::Mode::Fault) {
        return std::to_string(*code) + ' ' + name;
    }
    return moteus::isLimit(*code) ? "none (limit: " + name + ')' : "none";
}

Row row(const FoundController& controller)
{
    const moteus::Reply& known = controller.known;
    const auto uuid = known.uuid();
    const auto mode = known.mode();
    const auto home = known.homeState();
    return {std::to_string(controller.id),
            uuid ? moteus::uuidText(*uuid) : "?",
            moteus::firmwareText(known),
            wholeText(known, Register::RegisterMapVersion),
            mode ? std::string(moteus::modeText(*mode)) : "?",
            faultColumn(known),
            withUnit(known, Register::Voltage, 1, "V"),
            withUnit(known, Register::Temperature, 1, "°C"),
            withUnit(known, Register::Position, 4, "rev"),
            home ? std::string(moteus::homeStateText(*home)) : "?"};
}

// The number of characters on the screen. The second and later bytes of a UTF-8 character do not count.
std::size_t width(const std::string& text)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string aligned(const std::vector<Row>& rows)
{
    std::vector<std::size_t> widths(kHead.size(), 0);
    for (const Row& one : rows) {
        for (std::size_t i = 0; i < one.size(); ++i) {
            widths[i] = std::max(widths[i], width(one[i]));
        }
    }
    std::string text;
    for (const Row& one : rows) {
        for (std::size_t i = 0; i + 1 < one.size(); ++i) {
            text += one[i] + std::string(widths[i] - width(one[i]) + 2, ' ');
        }
        text += one.back() + '\n';
    }
    return text;
}

const QString kOneIdEach = QStringLiteral(
    "Open the guide of Boresight (F3), step Connect. It sets the ids of the boards one after the other.");

void addOwnProblems(const FoundController& controller, QStringList& found)
{
    const moteus::Reply& known = controller.known;
    const std::optional<double> map = known.value(Register::RegisterMapVersion);
    if (map && *map != moteus::kRegisterMapVersion) {
        found
            << QStringLiteral(
                   "id %1: register map version %2 is unknown. Boresight supports version %3. The values above may be "
                   "wrong, and Boresight does not move this controller. Install firmware with register map version %3.")
                   .arg(QString::number(controller.id), toQString(formatFixed(*map, 0)),
                        QString::number(moteus::kRegisterMapVersion));
    }
    if (known.mode() == moteus::Mode::Fault) {
        const int code = known.fault().value_or(0);
        const moteus::FaultText text = moteus::faultText(code);
        found << QStringLiteral("id %1: fault %2, %3: %4. %5.")
                     .arg(QString::number(controller.id), QString::number(code), toQString(text.name),
                          toQString(text.meaning), toQString(text.remedy));
    }
    if (!map || !known.mode()) {
        found << QStringLiteral(
                     "id %1: some questions got no reply in five attempts. Check the plugs, the termination and the "
                     "bit rates of the bus.")
                     .arg(controller.id);
    }
}

}  // namespace

std::string table(std::span<const FoundController> controllers)
{
    std::vector<Row> rows{kHead};
    for (const FoundController& controller : controllers) {
        rows.push_back(row(controller));
    }
    return aligned(rows);
}

QString simulatedText()
{
    return QStringLiteral("The boards are simulated. No real drive answers.");
}

QStringList problems(std::span<const FoundController> controllers)
{
    std::map<int, int> boards;
    for (const FoundController& controller : controllers) {
        ++boards[controller.id];
    }
    QStringList found;
    for (const auto& [id, count] : boards) {
        if (count > 1) {
            found << QStringLiteral("id %1: %2 controllers have this id. %3")
                         .arg(QString::number(id), QString::number(count), kOneIdEach);
        }
    }
    for (const FoundController& controller : controllers) {
        if (controller.isUnreadable()) {
            found << QStringLiteral(
                         "id %1: a controller replies, but its UUID never arrives complete. Probably two controllers "
                         "have this id, because all new controllers have the same id. Their replies collide. %2")
                         .arg(QString::number(controller.id), kOneIdEach);
        } else {
            addOwnProblems(controller, found);
        }
    }
    return found;
}

QString silenceText(const QString& bus)
{
    return QStringLiteral(
               "no controller replied on %1. Check\n  - that the controllers have power (10 to 44 V, the light is "
               "on),\n  - that CAN H and CAN L are not swapped and that both ends of the bus have 120 Ω,\n  - that the "
               "bus runs at 1 Mbit/s with 5 Mbit/s for the data,\n  - with one controller at a time: the replies of "
               "two controllers with the same id can collide.")
        .arg(bus);
}

}  // namespace boresight::app
