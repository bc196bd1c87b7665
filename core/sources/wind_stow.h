// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

#include <cstdint>

// Parks the mount when the wind exceeds the limits of the profile. It takes control as the operator would, so no client
// continues by itself after the wind. A mount that nobody has moved since the start, a fault or STOP stays where it is:
// an alarm offers to park it. Station thread only.
namespace boresight::sources {

class WindStow : public SourceOf<WindStow>
{
public:
    using SourceOf::SourceOf;

    void step(SteadyTime now) override;

private:
    void park();

    std::uint64_t m_onsets = 0;  // number of strong winds already handled
};

}  // namespace boresight::sources
