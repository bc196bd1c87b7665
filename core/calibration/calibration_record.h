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

// What was applied, when, where and on which drives, with what it replaced and what it was found from; and the list of
// these, in which one can go back and forth. Pure values; record_text.h makes files of them.
namespace boresight::calibration {

using RecordSite = Site;

// Of what a calibration holds for: elsewhere, or with another drive, it may be wrong.
struct RecordMount
{
    std::string azimuthDrive;  // UUID; empty if it was not known
    std::string elevationDrive;
    std::optional<RecordSite> site;

    bool operator==(const RecordMount&) const = default;
};

// How the sensor is mounted, and what its compass suffers from.
struct SensorMounting
{
    AzimuthSense sense = AzimuthSense::Clockwise;
    Angle azimuthOffset;  // true azimuth of the beam where the sensor looks north
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
    UtcTime when;   // of the Apply, to the millisecond
    QString title;  // "North from the compass swing"
    RecordMount mount;
    Change<pointing::PointingTerms> terms;
    std::array<std::optional<Angle>, kTerms> sigmas;  // of the terms that were found out
    std::optional<Change<SensorMounting>> sensor;     // if that was changed, too
    std::vector<CalibrationPoint> points;

    bool operator==(const CalibrationRecord&) const = default;
};

enum class MountDifference
{
    None,
    OtherSite,  // more than a kilometre away, where a compass and the Sun say something else
    OtherDrive  // the zero of an axis may be another
};

// What of the mount of today speaks against a calibration of then; what is not known on either side does not.
[[nodiscard]] MountDifference difference(const RecordMount& then, const RecordMount& today);

// The first `inForce` entries are in force, the others were undone. A new one takes the place of those; they, and the
// points in them, are kept apart to be read: nothing leads back to them.
class CalibrationHistory
{
public:
    CalibrationHistory() = default;
    // inForce is at most the number of entries.
    CalibrationHistory(std::vector<CalibrationRecord> entries, std::size_t inForce,
                       std::vector<CalibrationRecord> superseded = {});

    [[nodiscard]] const std::vector<CalibrationRecord>& entries() const { return m_entries; }
    [[nodiscard]] const std::vector<CalibrationRecord>& superseded() const { return m_superseded; }
    [[nodiscard]] std::size_t inForce() const { return m_inForce; }
    [[nodiscard]] bool canUndo() const { return m_inForce > 0; }
    [[nodiscard]] bool canRedo() const { return m_inForce < m_entries.size(); }

    void add(CalibrationRecord record);
    // The entry that is to be taken back (its `before` comes into force), or to be applied again (its `after`). Call
    // only where it can.
    const CalibrationRecord& undo();
    const CalibrationRecord& redo();

    bool operator==(const CalibrationHistory&) const = default;

private:
    std::vector<CalibrationRecord> m_entries;  // oldest first
    std::size_t m_inForce = 0;
    std::vector<CalibrationRecord> m_superseded;  // in the order in which they were
};

}  // namespace boresight::calibration
