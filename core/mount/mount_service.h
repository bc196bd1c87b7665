// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/drives_status.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>

// The functions of a rotator besides moving. Not every kind has them. The control uses them only while the mount stands
// still. Station thread only. Angles are mechanical.
namespace boresight {

class MountService
{
public:
    virtual ~MountService() = default;

    // Fills in the facts about the drives, for their own panels.
    virtual void describe(DrivesStatus& status) const = 0;
    // Success if settings of the drives can be written now, otherwise the reason.
    [[nodiscard]] virtual Result<> mayBeWritten() const = 0;
    // Success if the gains of this axis can be read and changed while it stands still, otherwise the reason.
    [[nodiscard]] virtual Result<> mayBeTuned(Axis axis) const = 0;
    // maySwitchOff(): success if the axis is on, otherwise the reason. switchOff() switches one axis or all off, so
    // that nothing holds them, and returns the text for the log.
    [[nodiscard]] virtual Result<> maySwitchOff(Axis axis) const = 0;
    [[nodiscard]] virtual QString switchOff(std::optional<Axis> only) = 0;

    // leaveBus() releases the bus to other tools and returns the text for the log. takeBus() takes the bus back.
    [[nodiscard]] virtual QString leaveBus() = 0;
    [[nodiscard]] virtual Result<> mayTakeBus() const = 0;
    virtual Result<> takeBus() = 0;

    // Success if the operator is asked for the wrap of the axis and an answer can be used now, otherwise the reason.
    [[nodiscard]] virtual Result<> mayChooseWrap(Axis axis) const = 0;
    // The operator has looked: the axis is near `angle`. `source` is named in the log.
    [[nodiscard]] virtual Result<> chooseWrap(Axis axis, Angle angle, const QString& source) = 0;

    // One step of the crash-stop test, which moves each axis, stops its commands and measures how it stops.
    struct ProofStep
    {
        std::optional<AxisRates> run;  // move the mount at these rates
        bool rest = false;             // stop the mount
        bool ended = false;
    };
    // Checks and prepares the test. The axes may move within these ranges. Refused with the reason. beginProof() starts
    // it.
    [[nodiscard]] virtual Result<> mayProve(AngularRate rate, const TravelRange& azimuths,
                                            const TravelRange& elevations) = 0;
    virtual void beginProof() = 0;
    [[nodiscard]] virtual bool proofRunning() const = 0;
    [[nodiscard]] virtual ProofStep stepProof() = 0;  // once in a tick
    virtual void endProof(const QString& how) = 0;
};

}  // namespace boresight
