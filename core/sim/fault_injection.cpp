// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/fault_injection.h"

#include <algorithm>

namespace boresight::sim {

FaultSchedule::Handle FaultSchedule::add(const Injection& injection)
{
    m_entries.push_back({m_next, injection});
    return m_next++;
}

void FaultSchedule::remove(Handle handle)
{
    std::erase_if(m_entries, [&](const Entry& entry) { return entry.handle == handle; });
}

const Injection* FaultSchedule::find(FaultKind kind, Axis axis, Seconds now) const
{
    const Injection* found = nullptr;
    for (const auto& [handle, injection] : m_entries) {
        const bool concerns = injection.kind == kind && (!injection.axis || *injection.axis == axis);
        if (concerns && now >= injection.at && now < injection.at + injection.duration) {
            found = &injection;
        }
    }
    return found;
}

std::optional<double> FaultSchedule::active(FaultKind kind, Axis axis, Seconds now) const
{
    const Injection* found = find(kind, axis, now);
    return found != nullptr ? std::optional(found->value.value_or(0.0)) : std::nullopt;
}

}  // namespace boresight::sim
