// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/calibration/cross_scan.h"
#include "core/calibration/pointing_solver.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

// A cross scan: a line of places across the body, then one in elevation through the peak of the first, where a weak
// source is seen best. At each place the received power is waited for, typed once or heard for a while from a receiver;
// in the end the beam is on the body again, where the middle of the scan is measured. Moves nothing itself. Pure;
// station thread.
namespace boresight {

class ScanRun
{
public:
    // Of each line; odd, so that the middle is one of them.
    static constexpr int kPlaces = 9;

    // `width`: from one end of a line to the other, on the sky.
    ScanRun(Angle width, SteadyTime now);

    // All that it would look at, beside the body, if the peak is there.
    [[nodiscard]] static std::vector<calibration::SkyOffset> placesOf(Angle width);
    // Where beside the body the beam shall look now.
    [[nodiscard]] calibration::SkyOffset offset() const;
    // The beam has not come to rest there yet.
    void moves(SteadyTime now);
    // The beam has come to rest there.
    [[nodiscard]] bool wantsPower(SteadyTime now) const { return !comesBack() && rests(now); }
    // The power at this place: the next place is to be looked at.
    void give(double decibels, SteadyTime now);
    // One that came by a line. What came before the beam and the receiver had settled is of another place, and not
    // used.
    void hear(double decibels, SteadyTime arrival);
    // What was heard at this place, if that is enough: the middle of it, so that a single slip does no harm.
    [[nodiscard]] std::optional<double> heard(SteadyTime now) const;
    [[nodiscard]] bool done(SteadyTime now) const { return comesBack() && rests(now); }
    // Why it does not get on, after having waited for long; empty: it does.
    [[nodiscard]] QString obstacle(SteadyTime now) const;

    [[nodiscard]] double part() const { return static_cast<double>(m_place) / (2.0 * kPlaces + 1.0); }
    [[nodiscard]] QString text(SteadyTime now) const;

    // `middle`: where the axes stand on the body.
    [[nodiscard]] Result<calibration::CrossScan> outcome(const AxisPosition& middle) const;

private:
    void turnAtPeak();
    [[nodiscard]] bool comesBack() const { return m_place == 2 * kPlaces; }
    [[nodiscard]] SteadyTime settled() const;
    [[nodiscard]] bool rests(SteadyTime now) const { return now >= settled(); }

    std::vector<calibration::SkyOffset> m_places;
    int m_place = 0;  // of both lines
    Angle m_turned;   // where on the line across the other one goes through
    QString m_noPeak;
    SteadyTime m_came;
    SteadyTime m_moved;  // the last time that it did
    SteadyTime m_firstHeard{};
    std::vector<double> m_heard;  // dB, at this place
    std::vector<calibration::ScanReading> m_across;
    std::vector<calibration::ScanReading> m_elevation;
};

}  // namespace boresight
