// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/drives_status.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>

// What an operator can do to a rotator itself, besides moving it. Not every kind has it. The control asks only while
// the mount rests. Station thread only. Angles are mechanical.
namespace boresight {

class MountService
{
public:
    virtual ~MountService() = default;

    // What is known of the drives themselves, for their own panels.
    virtual void describe(DrivesStatus& status) const = 0;
    // Settings of the drives can be written now; else the reason.
    [[nodiscard]] virtual Result<> mayBeWritten() const = 0;
    // The gains of this axis can be read and changed while it stands; else the reason.
    [[nodiscard]] virtual Result<> mayBeTuned(Axis axis) const = 0;
    // Lets its axes go, or one of them, which must be on. Returns what the log says of it.
    [[nodiscard]] virtual Result<> maySwitchOff(Axis axis) const = 0;
    [[nodiscard]] virtual QString switchOff(std::optional<Axis> only) = 0;

    // Leaves the bus to other tools, and takes it back. The first returns what the log says of it.
    [[nodiscard]] virtual QString leaveBus() = 0;
    [[nodiscard]] virtual Result<> mayTakeBus() const = 0;
    virtual Result<> takeBus() = 0;

    // The operator is asked which wrap the axis is on, and an answer can be taken now; else the reason.
    [[nodiscard]] virtual Result<> mayChooseWrap(Axis axis) const = 0;
    // The operator has looked: the axis stands at about `angle`. `source` is named in the log.
    [[nodiscard]] virtual Result<> chooseWrap(Axis axis, Angle angle, const QString& source) = 0;

    // The crash-stop proof: runs each axis up, stops feeding it, and measures how it stops.
    struct ProofStep
    {
        std::optional<AxisRates> run;  // move the mount so
        bool rest = false;             // stop
        bool ended = false;
    };
    // Refused with the reason. The axes may move within these ranges. Then beginProof() begins it.
    [[nodiscard]] virtual Result<> mayProve(AngularRate rate, const TravelRange& azimuths,
                                            const TravelRange& elevations) = 0;
    virtual void beginProof() = 0;
    [[nodiscard]] virtual bool proofRunning() const = 0;
    [[nodiscard]] virtual ProofStep stepProof() = 0;  // once in a tick
    virtual void endProof(const QString& how) = 0;
};

}  // namespace boresight
