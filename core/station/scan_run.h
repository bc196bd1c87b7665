// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/calibration/cross_scan.h"
#include "core/calibration/pointing_solver.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

// A cross scan: a line of places across the body, then one in elevation, at each of which the received power is waited
// for; in the end the beam is on the body again, where the middle of both lines is measured. Moves nothing itself.
// Pure; station thread.
namespace boresight {

class ScanRun
{
public:
    // Of each line; odd, so that the middle is one of them.
    static constexpr int kPlaces = 9;

    // `width`: from one end of a line to the other, on the sky.
    ScanRun(Angle width, SteadyTime now);

    // Where beside the body the beam shall look now.
    [[nodiscard]] calibration::SkyOffset offset() const;
    // The beam has come to rest there.
    [[nodiscard]] bool wantsPower(SteadyTime now) const { return !comesBack() && rests(now); }
    // The power at this place: the next place is to be looked at.
    void give(double decibels, SteadyTime now);
    [[nodiscard]] bool done(SteadyTime now) const { return comesBack() && rests(now); }
    // Nobody told the power for long.
    [[nodiscard]] bool late(SteadyTime now) const;

    [[nodiscard]] double part() const { return static_cast<double>(m_place) / (2.0 * kPlaces + 1.0); }
    [[nodiscard]] QString text(SteadyTime now) const;

    // `middle`: where the axes stand on the body.
    [[nodiscard]] Result<calibration::CrossScan> outcome(const AxisPosition& middle) const;

private:
    [[nodiscard]] bool comesBack() const { return m_place == 2 * kPlaces; }
    [[nodiscard]] bool rests(SteadyTime now) const;

    Angle m_width;
    int m_place = 0;  // of both lines
    SteadyTime m_came;
    std::vector<calibration::ScanReading> m_across;
    std::vector<calibration::ScanReading> m_elevation;
};

}  // namespace boresight
