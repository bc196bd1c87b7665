// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/station_control.h"
#include "core/north/model_in_force.h"
#include "core/north/point_book.h"

#include <optional>
#include <span>

// The points of this mount: takes them into the book, keeps the book in its file, and decides which of them count.
// Points from an earlier run of the program wait until both drives have reported their identity. Points of another
// drive or site are left out. Every change fits the points again. Station thread only.
namespace boresight {

class KeptPoints
{
public:
    // All arguments must outlive this object.
    KeptPoints(StationControl& control, CalibrationFile& file, const MountIdentity& mount, const ModelInForce& model,
               const Clock& clock, EventLog& log);

    [[nodiscard]] const PointBook& book() const { return m_book; }
    [[nodiscard]] Result<> hasRoom() const;

    void add(const NewPoint& point);
    Result<> drop(std::size_t index);
    Result<> use(std::size_t index, bool used);
    void clear();
    // The clock of this computer was set: the operator is warned of points from before.
    void clockWasSet();
    // Fits again after another model came into force.
    void fit();

    // True: points of another drive or site were left out.
    [[nodiscard]] bool leaveOutOthers();
    // True: the points that waited count from now on.
    [[nodiscard]] bool countRestored();
    // True once: there are points, and the operator is asked for the wrap of an axis for the first time.
    [[nodiscard]] bool noteTurns();

    // The fit differs from the model in force.
    [[nodiscard]] bool contradictModel() const;
    // The axes may count from another place since the first of these points.
    [[nodiscard]] bool axesMayDiffer(std::span<const calibration::CalibrationPoint> points) const;

private:
    void restore();
    void changed();

    StationControl& m_control;
    CalibrationFile& m_file;
    const MountIdentity& m_mount;
    const ModelInForce& m_model;
    const Clock& m_clock;
    EventLog& m_log;
    PointBook m_book;
    calibration::RecordMount m_pointsMount;  // the mount to which the points belong
    std::optional<UtcTime> m_turnAsked;      // when the operator was last asked for the position of an axis
};

}  // namespace boresight
