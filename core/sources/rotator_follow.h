// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"
#include "core/messages/rotator_report.h"

#include <optional>

// Points the beam where another rotator points, within all limits of this mount. The positions of the other rotator
// arrive as reports. Without a report for too long the tracking ends, and the mount holds. This source is separate from
// the operator: any motion by the operator ends it. Station thread only.
namespace boresight::sources {

class RotatorFollow : public SourceOf<RotatorFollow, request::FollowRotator>
{
public:
    // The reader of the positions gives up a little earlier and reports the reason.
    static constexpr Seconds kStale{6.0};

    using SourceOf::SourceOf;

    Result<> ask(const request::FollowRotator& wanted, const Source& by);
    void step(SteadyTime now) override;
    void describe(StationStatus& status) const override;
    // Fails with NotAvailable if the mount does not follow the rotator of the report.
    Result<> receive(const SourceReport& report) override;

private:
    struct Reading
    {
        QString name;
        SkyPointing direction;
        SteadyTime when;
    };
    struct Followed
    {
        Reading last;
        bool isNew = false;    // the mount has not been sent to `last` yet
        QString trouble = {};  // why the tracking must end
        std::uint64_t motionId = 0;
    };

    [[nodiscard]] Result<> takeReport(const RotatorReport& report);
    Result<> follow(bool anew);
    [[nodiscard]] QString whyToEnd(SteadyTime now) const;
    void end(const QString& why);

    std::optional<Reading> m_found;  // the last position of a rotator that is not followed but may be requested
    std::optional<Followed> m_followed;
};

}  // namespace boresight::sources
