// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"
#include "core/messages/rotator_report.h"

#include <optional>

// Another rotator whose position arrives: the beam goes where that one points, within all limits of this mount. Without
// a position for too long it ends, and the mount holds. It is a source of its own beside the operator's hand, which
// ends it. Station thread only.
namespace boresight::sources {

class RotatorFollow : public SourceOf<RotatorFollow, request::FollowRotator>
{
public:
    // Who reads the positions gives up somewhat earlier, and reports the reason.
    static constexpr Seconds kStale{6.0};

    using SourceOf::SourceOf;

    Result<> ask(const request::FollowRotator& wanted, const Source& by);
    void step(SteadyTime now) override;
    void describe(StationStatus& status) const override;
    // NotAvailable: it is followed no more.
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
        bool isNew = false;    // the mount was not sent there yet
        QString trouble = {};  // why it is followed no more
        std::uint64_t motionId = 0;
    };

    [[nodiscard]] Result<> takeReport(const RotatorReport& report);
    Result<> follow(bool anew);
    [[nodiscard]] QString whyToEnd(SteadyTime now) const;
    void end(const QString& why);

    std::optional<Reading> m_found;  // of one that may be asked for
    std::optional<Followed> m_followed;
};

}  // namespace boresight::sources
