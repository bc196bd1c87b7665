// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/pass_plan.h"
#include "core/recording/byte_source.h"
#include "core/recording/recording.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <span>
#include <string>
#include <vector>

// The channels of a recording: one number of each row, its name, its unit, and how many steps the unit has in the file.
// A file names its channels, so a reader finds them by name. Pure.
namespace boresight::recording {

template <class Row>
struct Channel
{
    std::string name;  // "azimuth.actual"
    std::string unit;  // "deg"
    double perUnit = 1.0;
    std::optional<double> (*get)(const Row&) = nullptr;
    void (*set)(Row&, double) = nullptr;
};

// How a file describes a channel.
struct WrittenChannel
{
    QString name;
    double perUnit = 1.0;
};

// In the order of the file.
[[nodiscard]] const std::vector<Channel<Tick>>& tickChannels();
[[nodiscard]] const std::vector<Channel<plan::PlannedMoment>>& planChannels();

// More rows than in any block that Boresight writes.
inline constexpr std::uint64_t kMostRows = 200'000;

// The number of the rows, then a column for each channel.
[[nodiscard]] QByteArray rowBytes(std::span<const Tick> ticks);
[[nodiscard]] QByteArray rowBytes(std::span<const plan::PlannedMoment> moments);

// Reads rows with the channels of the file. A channel that this version does not know is passed over. Empty: these are
// not such rows, or more than `most`.
[[nodiscard]] std::optional<std::vector<Tick>> takeTicks(ByteSource& source,
                                                         const std::vector<WrittenChannel>& channels,
                                                         std::uint64_t most);
[[nodiscard]] std::optional<std::vector<plan::PlannedMoment>> takeMoments(ByteSource& source,
                                                                          const std::vector<WrittenChannel>& channels);

}  // namespace boresight::recording
