// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/source_list.h"

#include "core/base/text.h"

namespace boresight {

Result<> SourceList::ask(const Request& request, const Source& by)
{
    for (const auto& one : m_sources) {
        if (auto answer = one->take(request, by)) {
            return *std::move(answer);
        }
    }
    return failure(ErrorCode::NotAvailable, Text::tr("no source of motion accepts this request"));
}

Result<> SourceList::receive(const SourceReport& report)
{
    Result<> believed;
    for (const auto& one : m_sources) {
        believed = believed.and_then([&] { return one->receive(report); });
    }
    return believed;
}

std::optional<SkyPointing> SourceList::targetAt(UtcTime utc)
{
    for (const auto& one : m_sources) {
        if (const auto direction = one->targetAt(utc)) {
            return direction;
        }
    }
    return std::nullopt;
}

void SourceList::step(SteadyTime now)
{
    for (const auto& one : m_sources) {
        one->step(now);
    }
}

void SourceList::describe(StationStatus& status) const
{
    for (const auto& one : m_sources) {
        one->describe(status);
    }
}

void SourceList::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    for (const auto& one : m_sources) {
        one->profileChanged(before, after);
    }
}

void SourceList::gone(const Source& client)
{
    for (const auto& one : m_sources) {
        one->gone(client);
    }
}

void SourceList::positionRead(std::uint64_t clientId)
{
    for (const auto& one : m_sources) {
        one->positionRead(clientId);
    }
}

}  // namespace boresight
