// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

// How well each pass of a night was tracked: where the beam was, against where the satellite was. Pure, any thread.
namespace boresight::schedule {

// What a beam loses at this distance from its middle, in dB. A Gaussian beam whose gain is half at half its width B:
// 40 log10(2) (distance / B)^2, so 3.01 dB at B / 2, and 1 dB at 0.288 B.
[[nodiscard]] double beamLoss(Angle distance, Angle beamWidth);

enum class PassEnd
{
    Set,          // it was tracked until its end
    Manual,       // somebody has taken the mount, or pressed STOP
    Fault,        // or the connection was lost
    Refused,      // the station did not begin to track it, or gave it up
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
    // Of the beam, on the sky, since it was first on its target. Empty: it never was. The way there counts as seconds
    // only.
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

// The pass that is tracked, or was tracked last, as it is kept beside the report.
struct NewestPass
{
    PassRecord pass;
    int earlier = 0;  // the parts of the same pass that the report had before it

    bool operator==(const NewestPass&) const = default;
};

// Of a pass that was begun again the report has several parts.
[[nodiscard]] int partsOf(const NightReport& report, const PassRecord& pass);

// One pass while it is tracked: what is added in each tick.
class PassTally
{
public:
    PassTally() = default;
    explicit PassTally(PassRecord begun) : m_record(std::move(begun)) {}

    // The beam is on its target when it was there for so long without a break: while it slews it may cross it.
    static constexpr Seconds kSettled{1.0};

    struct Look
    {
        Angle error;
        bool isOnTarget = true;
        Seconds during{0.0};  // it was so
    };
    void add(const Look& look, Angle beamWidth);
    [[nodiscard]] PassRecord record() const;
    [[nodiscard]] PassRecord ended(PassEnd end, const QString& why) const;

private:
    [[nodiscard]] bool settles(const Look& look);

    PassRecord m_record;
    Seconds m_onTarget{0.0};  // without a break
    Seconds m_judged{0.0};    // since it was first on its target
    double m_squares = 0.0;   // deg² s, in this time
};

}  // namespace boresight::schedule
