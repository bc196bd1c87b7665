// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/reply_edit.h"

#include "core/moteus/arbitration.h"
#include "core/moteus/subframes.h"

namespace boresight::sim {
namespace {

using moteus::Register;

struct Place
{
    moteus::Resolution resolution = moteus::Resolution::Float;
    std::size_t offset = 0;  // in the payload
    double value = 0.0;
};

bool contains(const moteus::ReplyBlock& block, Register reg)
{
    return reg >= block.first && reg < block.first + block.count;
}

std::optional<Place> find(const CanFrame& reply, Register reg)
{
    moteus::SubframeReader reader(reply.payload());
    while (const auto subframe = reader.next()) {
        const auto* const block = std::get_if<moteus::ReplyBlock>(&*subframe);
        if (block != nullptr && contains(*block, reg)) {
            const auto index = static_cast<std::uint32_t>(reg) - static_cast<std::uint32_t>(block->first);
            const auto start = static_cast<std::size_t>(block->bytes.data() - reply.data.data());
            return Place{.resolution = block->resolution,
                         .offset = start + index * moteus::sizeInBytes(block->resolution),
                         .value = block->value(index).value};
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> valueIn(const CanFrame& reply, Register reg)
{
    const std::optional<Place> place = find(reply, reg);
    return place ? std::optional(place->value) : std::nullopt;
}

void setValue(CanFrame& reply, Register reg, double value)
{
    const std::optional<Place> place = find(reply, reg);
    if (!place) {
        return;
    }
    const moteus::Kind kind = moteus::registerKind(reg).value_or(moteus::Kind::Integer);
    std::uint32_t bits = moteus::toWire(value, kind, place->resolution, moteus::Side::Device);
    for (std::size_t i = 0; i < moteus::sizeInBytes(place->resolution); ++i) {
        reply.data[place->offset + i] = static_cast<std::uint8_t>(bits);
        bits >>= 8;
    }
}

void cutBefore(CanFrame& reply, Register reg)
{
    moteus::SubframeWriter kept;
    moteus::SubframeReader reader(reply.payload());
    while (const auto subframe = reader.next()) {
        const auto* const block = std::get_if<moteus::ReplyBlock>(&*subframe);
        if (block != nullptr && contains(*block, reg)) {
            CanFrame cut = moteus::makeFrame(moteus::fromCanId(reply.id), kept.bytes());
            cut.flexibleData = reply.flexibleData;
            cut.bitRateSwitch = reply.bitRateSwitch;
            reply = cut;
            return;
        }
        kept.append(*subframe);
    }
}

void setSource(CanFrame& reply, std::uint8_t id)
{
    moteus::Arbitration arbitration = moteus::fromCanId(reply.id);
    arbitration.source = id;
    reply.id = moteus::toCanId(arbitration);
}

}  // namespace boresight::sim
