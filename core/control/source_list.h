// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

#include <utility>

// All sources of motion of a station, asked in their order. Station thread only.
namespace boresight {

class SourceList
{
public:
    explicit SourceList(MotionSources sources) : m_sources(std::move(sources)) {}

    // The answer of the first source that takes this request.
    Result<> ask(const Request& request, const Source& by);
    // The error is that of the first source that does not believe the report.
    Result<> receive(const SourceReport& report);
    // The direction of the first source that knows one.
    [[nodiscard]] std::optional<SkyPointing> targetAt(UtcTime utc);

    // The rest goes to every source, as in MotionSource.
    void step(SteadyTime now);
    void describe(StationStatus& status) const;
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    void gone(const Source& client);
    void positionRead(std::uint64_t clientId);

private:
    MotionSources m_sources;
};

}  // namespace boresight
