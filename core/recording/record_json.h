// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recording/channel.h"
#include "core/recording/recording.h"

#include <QByteArray>
#include <QByteArrayView>

#include <optional>
#include <span>
#include <vector>

// The parts of a recording that are JSON: header, events, gap, and what a plan has besides its moments. Absent keys are
// unknown values, and other keys are ignored. Control characters of texts are read as U+FFFD. The keys: README.md.
// Pure.
namespace boresight::recording {

// A header, or a plan without its moments, with the channels of the rows.
template <class Value>
struct Described
{
    Value value;
    std::vector<WrittenChannel> channels;
};

[[nodiscard]] QByteArray headerJson(const Header& header);
[[nodiscard]] QByteArray eventsJson(std::span<const Event> events);
[[nodiscard]] QByteArray gapJson(const Gap& gap);
[[nodiscard]] QByteArray planJson(const plan::PlanVariant& plan);

// Empty: this is no such JSON, or a time of an event or a gap is not one that isRecordable() permits.
[[nodiscard]] std::optional<Described<Header>> readHeaderJson(QByteArrayView json);
[[nodiscard]] std::optional<std::vector<Event>> readEventsJson(QByteArrayView json);
[[nodiscard]] std::optional<Gap> readGapJson(QByteArrayView json);
[[nodiscard]] std::optional<Described<plan::PlanVariant>> readPlanJson(QByteArrayView json);

}  // namespace boresight::recording
