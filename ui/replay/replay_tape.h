// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/recording/recording.h"
#include "core/targets/sky_moment.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

// A recording in the order of time, and what is in it at a moment. Never changed, so threads share it.
namespace boresight::ui {

class ReplayTape
{
public:
    // Sorts ticks and events by time, and adds an event for each gap.
    explicit ReplayTape(recording::Recording record);

    [[nodiscard]] const recording::Header& header() const { return m_record.header; }
    [[nodiscard]] const std::vector<recording::Tick>& ticks() const { return m_record.ticks; }
    [[nodiscard]] const std::vector<recording::Event>& events() const { return m_record.events; }
    // The path of the target from the first tick to the last one. Null: the target was unknown.
    [[nodiscard]] const targets::SkyWay& way() const { return m_way; }
    // What is missing, one sentence each: of much damage the first parts and a number. Empty: the file is whole.
    [[nodiscard]] const QStringList& remarks() const { return m_remarks; }

    // The first and the last tick. Without ticks: the first and the last event.
    [[nodiscard]] UtcTime begin() const { return m_begin; }
    [[nodiscard]] UtcTime end() const { return m_end; }

    // The number of ticks before this time, or at it.
    [[nodiscard]] std::size_t ticksUntil(UtcTime utc) const;
    // The newest tick at this moment. Null: the recording has no earlier tick.
    [[nodiscard]] const recording::Tick* tickAt(UtcTime utc) const;
    // The index of the newest event at this moment.
    [[nodiscard]] std::optional<std::size_t> eventAt(UtcTime utc) const;
    // The index of the last start of a motion at this moment or before. With `below`: among the events before this one.
    [[nodiscard]] std::optional<std::size_t> motionStartAt(UtcTime utc, std::optional<std::size_t> below = {}) const;

private:
    void addGaps();
    void addRemarks();
    void findSpan();
    void findWay();

    recording::Recording m_record;
    targets::SkyWay m_way;
    QStringList m_remarks;
    UtcTime m_begin;
    UtcTime m_end;
};

using SharedTape = std::shared_ptr<const ReplayTape>;

// Reads a file. May take a second, so it runs beside the gui thread.
[[nodiscard]] Result<SharedTape> loadTape(const QString& path);

}  // namespace boresight::ui
