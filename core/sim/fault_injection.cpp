// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/fault_injection.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace boresight::sim {
namespace {

struct Word
{
    std::string_view name;
    FaultKind kind;
    bool needsValue;
};

constexpr std::array<Word, 16> kWords{{
    {"silence", FaultKind::Silence, false},
    {"late-reply", FaultKind::LateReply, true},
    {"lost-reply", FaultKind::LostReply, true},
    {"lost-command", FaultKind::LostCommand, true},
    {"corrupt-line", FaultKind::CorruptLine, true},
    {"missing-ok", FaultKind::MissingOk, false},
    {"adapter-error", FaultKind::AdapterError, false},
    {"bus-off", FaultKind::BusOff, false},
    {"duplicate-id", FaultKind::DuplicateId, false},
    {"drive-fault", FaultKind::DriveFault, true},
    {"power-loss", FaultKind::PowerLoss, false},
    {"supply-voltage", FaultKind::SupplyVoltage, true},
    {"wind", FaultKind::Wind, true},
    {"jam", FaultKind::Jam, true},
    {"stall", FaultKind::Stall, false},
    {"register-map", FaultKind::RegisterMap, true},
}};

std::string permittedWords()
{
    std::string text;
    for (const Word& word : kWords) {
        text += text.empty() ? "" : ", ";
        text += word.name;
    }
    return text;
}

Result<> applyOption(Injection& injection, std::string_view option)
{
    const std::size_t equals = option.find('=');
    const std::string_view key = option.substr(0, equals);
    const std::string_view text = equals == std::string_view::npos ? "" : option.substr(equals + 1);
    if (key == "axis" && (text == "az" || text == "el")) {
        injection.axis = text == "az" ? Axis::Azimuth : Axis::Elevation;
        return {};
    }
    const std::optional<double> number = parseFinite(text);
    if (number && key == "at" && *number >= 0.0) {
        injection.at = Seconds(*number);
    } else if (number && key == "for" && *number > 0.0) {
        injection.duration = Seconds(*number);
    } else if (number && key == "value") {
        injection.value = *number;
    } else {
        return failure(ErrorCode::InvalidInput, "fault option \"" + std::string(option) +
                                                    "\": expected axis=az|el, at=SECONDS, for=SECONDS or value=NUMBER");
    }
    return {};
}

}  // namespace

Result<Injection> parseInjection(std::string_view text)
{
    const std::string_view name = text.substr(0, text.find(','));
    const auto* word = std::ranges::find(kWords, name, &Word::name);
    if (word == kWords.end()) {
        return failure(ErrorCode::InvalidInput,
                       "fault \"" + std::string(name) + "\" is unknown; known are " + permittedWords());
    }
    Injection injection{.kind = word->kind};
    std::string_view rest = text.substr(name.size());
    while (!rest.empty()) {
        rest.remove_prefix(1);
        const std::string_view option = rest.substr(0, rest.find(','));
        if (const Result<> applied = applyOption(injection, option); !applied) {
            return tl::unexpected(applied.error());
        }
        rest.remove_prefix(option.size());
    }
    if (word->needsValue && !injection.value) {
        return failure(ErrorCode::InvalidInput, "fault \"" + std::string(name) + "\" needs value=NUMBER");
    }
    return injection;
}

FaultSchedule::Handle FaultSchedule::add(const Injection& injection)
{
    m_entries.push_back({m_next, injection});
    return m_next++;
}

void FaultSchedule::remove(Handle handle)
{
    std::erase_if(m_entries, [&](const Entry& entry) { return entry.handle == handle; });
}

const Injection* FaultSchedule::find(FaultKind kind, Axis axis, Seconds now) const
{
    const Injection* found = nullptr;
    for (const auto& [handle, injection] : m_entries) {
        const bool concerns = injection.kind == kind && (!injection.axis || *injection.axis == axis);
        if (concerns && now >= injection.at && now < injection.at + injection.duration) {
            found = &injection;
        }
    }
    return found;
}

std::optional<double> FaultSchedule::active(FaultKind kind, Axis axis, Seconds now) const
{
    const Injection* found = find(kind, axis, now);
    return found != nullptr ? std::optional(found->value.value_or(0.0)) : std::nullopt;
}

}  // namespace boresight::sim
