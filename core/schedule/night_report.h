// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

// How well each pass of a night was tracked, from the directions of the beam and of the satellite. Pure, any thread.
namespace boresight::schedule {

// The loss in dB at this distance from the centre of the beam. A Gaussian beam with half the gain at half its width B:
// 40 log10(2) (distance / B)^2, which is 3.01 dB at B / 2 and 1 dB at 0.288 B.
[[nodiscard]] double beamLoss(Angle distance, Angle beamWidth);

enum class PassEnd
{
    Set,          // it was tracked until its end
    Manual,       // somebody used the mount or pressed STOP
    Fault,        // a fault, or the connection was lost
    Refused,      // the station refused to track it, or gave up
    Interrupted,  // Boresight ended without a shutdown
    Running
};

struct PassRecord
{
    std::int64_t number = 0;
    QString name;
    UtcTime aos{};
    UtcTime los{};
    Seconds tracked{0.0};  // with a measured beam, while the satellite is up
    Seconds within1dB{0.0};
    Seconds within3dB{0.0};
    // Errors of the beam on the sky, from the first time on target. Empty: it was never on target. The slew to the
    // satellite only counts in the times.
    std::optional<Angle> rmsError = {};
    std::optional<Angle> peakError = {};
    PassEnd end = PassEnd::Running;
    QString why;  // in words; empty: it has set

    bool operator==(const PassRecord&) const = default;
};

struct NightReport
{
    std::vector<PassRecord> passes;  // in the order in which they began
    int interventions = 0;           // acts of people that ended the schedule
    int faults = 0;                  // that ended it

    [[nodiscard]] int done() const;  // tracked until the end

    bool operator==(const NightReport&) const = default;
};

// The pass that is tracked, or was tracked last, as stored in its own file.
struct NewestPass
{
    PassRecord pass;
    int earlier = 0;  // number of parts of the same pass that the report had before

    bool operator==(const NewestPass&) const = default;
};

// The number of parts of a pass in the report. A pass that was begun again has several.
[[nodiscard]] int partsOf(const NightReport& report, const PassRecord& pass);

// One pass while it is tracked: what is added in each tick.
class PassTally
{
public:
    PassTally() = default;
    explicit PassTally(PassRecord begun) : m_record(std::move(begun)) {}

    // The beam counts as on target after this time without interruption, because a slewing beam may only cross the
    // target.
    static constexpr Seconds kSettled{1.0};

    struct Look
    {
        Angle error;
        bool isOnTarget = true;
        Seconds during{0.0};  // duration of this state
    };
    void add(const Look& look, Angle beamWidth);
    [[nodiscard]] PassRecord record() const;
    [[nodiscard]] PassRecord ended(PassEnd end, const QString& why) const;

private:
    [[nodiscard]] bool settles(const Look& look);

    PassRecord m_record;
    Seconds m_onTarget{0.0};  // without interruption
    Seconds m_judged{0.0};    // since it was first on target
    double m_squares = 0.0;   // deg² s, during m_judged
};

}  // namespace boresight::schedule
