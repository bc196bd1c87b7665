// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/calibration/deviation_curve.h"
#include "core/calibration/pointing_solver.h"
#include "core/units/site.h"

#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// A record of an applied calibration: what was applied, when, where and on which drives, what it replaced and what it
// was found from. The history is a list of records with Undo and Redo. Pure values; record_text.h writes and reads the
// files.
namespace boresight::calibration {

using RecordSite = Site;

// The mount for which a calibration is valid. At another site or with another drive the calibration may be wrong.
struct RecordMount
{
    std::string azimuthDrive;  // UUID; empty if it was unknown
    std::string elevationDrive;
    std::optional<RecordSite> site;

    bool operator==(const RecordMount&) const = default;
};

// How the sensor is mounted, and the deviation of its compass.
struct SensorMounting
{
    AzimuthSense sense = AzimuthSense::Clockwise;
    Angle azimuthOffset;  // true azimuth of the beam when the sensor points north
    Angle elevationOffset;
    std::optional<DeviationCurve> curve;

    bool operator==(const SensorMounting&) const = default;
};

template <class Value>
struct Change
{
    Value before;
    Value after;

    bool operator==(const Change&) const = default;
};

struct CalibrationRecord
{
    UtcTime when;   // time of the Apply, to the millisecond
    QString title;  // "North from the compass swing"
    RecordMount mount;
    Change<pointing::PointingTerms> terms;
    std::array<std::optional<Angle>, kTerms> sigmas;  // of the terms that were found
    std::optional<Change<SensorMounting>> sensor;     // only if it was changed
    std::vector<CalibrationPoint> points;

    bool operator==(const CalibrationRecord&) const = default;
};

enum class MountDifference
{
    None,
    OtherSite,  // more than a kilometre away, where the Sun and the declination differ
    OtherDrive  // the zero of an axis may differ
};

// Whether the calibration of `then` may be wrong on the mount of `today`. A value that is unknown on one side is not
// compared.
[[nodiscard]] MountDifference difference(const RecordMount& then, const RecordMount& today);

// The first `inForce` entries are in force, the others were undone. A new entry replaces the undone entries. The
// replaced entries and their points are kept apart for reading only.
class CalibrationHistory
{
public:
    CalibrationHistory() = default;
    // inForce must not exceed the number of entries.
    CalibrationHistory(std::vector<CalibrationRecord> entries, std::size_t inForce,
                       std::vector<CalibrationRecord> superseded = {});

    [[nodiscard]] const std::vector<CalibrationRecord>& entries() const { return m_entries; }
    [[nodiscard]] const std::vector<CalibrationRecord>& superseded() const { return m_superseded; }
    [[nodiscard]] std::size_t inForce() const { return m_inForce; }
    [[nodiscard]] bool canUndo() const { return m_inForce > 0; }
    [[nodiscard]] bool canRedo() const { return m_inForce < m_entries.size(); }

    void add(CalibrationRecord record);
    // undo() returns the entry to take back (its `before` comes into force), redo() the entry to apply again (its
    // `after`). Call them only if canUndo() or canRedo().
    const CalibrationRecord& undo();
    const CalibrationRecord& redo();

    bool operator==(const CalibrationHistory&) const = default;

private:
    std::vector<CalibrationRecord> m_entries;  // oldest first
    std::size_t m_inForce = 0;
    std::vector<CalibrationRecord> m_superseded;  // in the order in which they were superseded
};

}  // namespace boresight::calibration
