// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// A tuning run moves an axis. It sends the rates again in every tick. The motion ends when the rates stop arriving.
// Station thread only.
namespace boresight::sources {

class TrialRun : public SourceOf<TrialRun, request::Trial>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::Trial& wanted, const Source& by);
    void step(SteadyTime now) override;

protected:
    [[nodiscard]] bool serves(const Request& /*request*/, const Source& by) const override
    {
        return by.kind == SourceKind::Operator;
    }

private:
    SteadyTime m_deadline{};
};

}  // namespace boresight::sources
