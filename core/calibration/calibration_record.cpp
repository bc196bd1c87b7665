// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_record.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace boresight::calibration {
namespace {

constexpr double kEarthRadius = 6371000.0;  // m
constexpr double kSamePlace = 1000.0;       // m

bool differs(const std::string& then, const std::string& today)
{
    return !then.empty() && !today.empty() && then != today;
}

double metresBetween(const RecordSite& a, const RecordSite& b)
{
    const double north = (a.latitude - b.latitude).radians();
    const double east = (a.longitude - b.longitude).wrapped180().radians() * std::cos(a.latitude.radians());
    return kEarthRadius * std::hypot(north, east);
}

}  // namespace

MountDifference difference(const RecordMount& then, const RecordMount& today)
{
    if (differs(then.azimuthDrive, today.azimuthDrive) || differs(then.elevationDrive, today.elevationDrive)) {
        return MountDifference::OtherDrive;
    }
    const bool moved = then.site && today.site && metresBetween(*then.site, *today.site) > kSamePlace;
    return moved ? MountDifference::OtherSite : MountDifference::None;
}

CalibrationHistory::CalibrationHistory(std::vector<CalibrationRecord> entries, std::size_t inForce,
                                       std::vector<CalibrationRecord> superseded)
    : m_entries(std::move(entries)), m_inForce(std::min(inForce, m_entries.size())), m_superseded(std::move(superseded))
{}

void CalibrationHistory::add(CalibrationRecord record)
{
    const auto undone = m_entries.begin() + static_cast<std::ptrdiff_t>(m_inForce);
    m_superseded.insert(m_superseded.end(), std::make_move_iterator(undone), std::make_move_iterator(m_entries.end()));
    m_entries.erase(undone, m_entries.end());
    m_entries.push_back(std::move(record));
    m_inForce = m_entries.size();
}

const CalibrationRecord& CalibrationHistory::undo()
{
    assert(canUndo());
    return m_entries[--m_inForce];
}

const CalibrationRecord& CalibrationHistory::redo()
{
    assert(canRedo());
    return m_entries[m_inForce++];
}

}  // namespace boresight::calibration
