// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/reply_spoiler.h"

#include "core/sim/drive_config.h"
#include "core/sim/reference_mount.h"
#include "core/sim/reply_edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace boresight::sim {
namespace {

using moteus::Register;

// In the order in which they are applied.
constexpr std::array kEdits{FaultKind::StaleReply,       FaultKind::FalsePosition,   FaultKind::PositionNaN,
                            FaultKind::PositionInfinite, FaultKind::PositionMissing, FaultKind::SupplyNaN,
                            FaultKind::TemperatureNaN,   FaultKind::ForeignId,       FaultKind::ExchangedReplies,
                            FaultKind::DoubledReply};

// In degrees: from an error that no antenna notices to a whole turn.
constexpr double kSmallestRandomError = 0.01;
constexpr double kLargestRandomError = 360.0;
constexpr double kLongestRandomAge = 1.0;  // s
constexpr double kReplySpoilerLargestId = 126.0;

}  // namespace

std::vector<CanFrame> ReplySpoiler::spoil(const CanFrame& reply, const FaultSchedule& faults, Seconds now, int otherId)
{
    remember(reply, now);
    if (faults.isEmpty()) {
        return {reply};
    }
    CanFrame arriving = reply;
    std::size_t copies = 1;
    for (const Edit& edit : editsFor(faults, now)) {
        apply(edit, arriving, now, otherId);
        copies = edit.kind == FaultKind::DoubledReply ? 2 : copies;
    }
    return std::vector(copies, arriving);
}

std::vector<ReplySpoiler::Edit> ReplySpoiler::editsFor(const FaultSchedule& faults, Seconds now)
{
    std::vector<Edit> edits;
    for (const FaultKind kind : kEdits) {
        if (const std::optional<double> value = faults.active(kind, m_axis, now)) {
            edits.push_back({.kind = kind, .value = *value});
        }
    }
    const std::optional<double> probability = faults.active(FaultKind::EditedReply, m_axis, now);
    if (probability && random(0.0, 1.0) < *probability) {
        edits.push_back(randomEdit());
    }
    return edits;
}

ReplySpoiler::Edit ReplySpoiler::randomEdit()
{
    const auto last = static_cast<int>(kEdits.size()) - 1;
    const auto chosen = static_cast<std::size_t>(std::uniform_int_distribution(0, last)(m_random));
    Edit edit{.kind = kEdits[chosen]};
    if (edit.kind == FaultKind::FalsePosition) {
        const double size = std::exp(random(std::log(kSmallestRandomError), std::log(kLargestRandomError)));
        edit.value = random(0.0, 1.0) < 0.5 ? size : -size;
    } else if (edit.kind == FaultKind::StaleReply) {
        edit.value = random(0.0, kLongestRandomAge);
    } else if (edit.kind == FaultKind::ForeignId) {
        edit.value = std::floor(random(1.0, kReplySpoilerLargestId));
    }
    return edit;
}

void ReplySpoiler::apply(const Edit& edit, CanFrame& reply, Seconds now, int otherId) const
{
    switch (edit.kind) {
        case FaultKind::StaleReply:
            reply = said(reply, now - Seconds(edit.value)).value_or(reply);
            break;
        case FaultKind::FalsePosition:
            if (const std::optional<double> turns = valueIn(reply, Register::Position)) {
                setValue(reply, Register::Position, *turns + referenceAxis(m_axis).sign * edit.value / 360.0);
            }
            break;
        case FaultKind::PositionNaN:
            setValue(reply, Register::Position, kNone);
            break;
        case FaultKind::PositionInfinite:
            setValue(reply, Register::Position, std::numeric_limits<double>::infinity());
            break;
        case FaultKind::PositionMissing:
            cutBefore(reply, Register::Position);
            break;
        case FaultKind::SupplyNaN:
            setValue(reply, Register::Voltage, kNone);
            break;
        case FaultKind::TemperatureNaN:
            setValue(reply, Register::Temperature, kNone);
            setValue(reply, Register::MotorTemperature, kNone);
            break;
        case FaultKind::ForeignId:
            setSource(reply, static_cast<std::uint8_t>(edit.value));
            break;
        case FaultKind::ExchangedReplies:
            setSource(reply, static_cast<std::uint8_t>(otherId));
            break;
        default:
            break;
    }
}

void ReplySpoiler::remember(const CanFrame& reply, Seconds now)
{
    while (!m_said.empty() && m_said.front().at < now - kLongestStale) {
        m_said.pop_front();
    }
    m_said.push_back({.at = now, .frame = reply});
}

// The last reply at that time to the same query: of the same length, and with the same first byte.
std::optional<CanFrame> ReplySpoiler::said(const CanFrame& like, Seconds at) const
{
    const auto found = std::find_if(m_said.rbegin(), m_said.rend(), [&](const Said& one) {
        return one.at <= at && one.frame.size == like.size && one.frame.data[0] == like.data[0];
    });
    return found != m_said.rend() ? std::optional(found->frame) : std::nullopt;
}

}  // namespace boresight::sim
