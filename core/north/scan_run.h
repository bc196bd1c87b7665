// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/calibration/cross_scan.h"
#include "core/calibration/pointing_solver.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

// A cross scan: a line of places across the body, then a line in elevation through the peak of the first, where a weak
// source is seen best. At each place the scan waits for the received power, which is typed once or received from a
// receiver for a while. At the end the beam is on the body again, where the middle of the scan is measured. Moves
// nothing itself. Pure; station thread.
namespace boresight {

class ScanRun
{
public:
    // Places of each line. The number is odd, so that the middle is one of the places.
    static constexpr int kPlaces = 9;

    // `width`: from one end of a line to the other, on the sky.
    ScanRun(Angle width, SteadyTime now);

    // All places beside the body where the scan would look. The peak may shift the second line.
    [[nodiscard]] static std::vector<calibration::SkyOffset> placesOf(Angle width);
    // Where beside the body the beam must point now.
    [[nodiscard]] calibration::SkyOffset offset() const;
    // The beam does not stand still at the place yet.
    void moves(SteadyTime now);
    // The beam stands still at the place.
    [[nodiscard]] bool wantsPower(SteadyTime now) const { return !comesBack() && rests(now); }
    // The power at this place. The scan continues to the next place.
    void give(double decibels, SteadyTime now);
    // A value from the receiver. A value from before the beam and the receiver had settled is not used.
    void hear(double decibels, SteadyTime arrival);
    // The median of the values received at this place, if there are enough of them. One wrong value does no harm.
    [[nodiscard]] std::optional<double> heard(SteadyTime now) const;
    [[nodiscard]] bool done(SteadyTime now) const { return comesBack() && rests(now); }
    // Why the scan waits at this place for too long. Empty: it does not.
    [[nodiscard]] QString obstacle(SteadyTime now) const;

    [[nodiscard]] double part() const { return static_cast<double>(m_place) / (2.0 * kPlaces + 1.0); }
    [[nodiscard]] QString text(SteadyTime now) const;

    // `middle`: the position of the axes with the beam on the body.
    [[nodiscard]] Result<calibration::CrossScan> outcome(const AxisPosition& middle) const;

private:
    void turnAtPeak();
    [[nodiscard]] bool comesBack() const { return m_place == 2 * kPlaces; }
    [[nodiscard]] SteadyTime settled() const;
    [[nodiscard]] bool rests(SteadyTime now) const { return now >= settled(); }

    std::vector<calibration::SkyOffset> m_places;
    int m_place = 0;  // counted over both lines
    Angle m_turned;   // where the second line crosses the first
    QString m_noPeak;
    SteadyTime m_came;
    SteadyTime m_moved;  // when the beam last moved
    SteadyTime m_firstHeard{};
    std::vector<double> m_heard;  // dB, at this place
    std::vector<calibration::ScanReading> m_across;
    std::vector<calibration::ScanReading> m_elevation;
};

}  // namespace boresight
