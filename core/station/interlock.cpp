// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/interlock.h"

namespace boresight {

void Interlock::latchStop()
{
    m_stopLatched = true;
    m_authority = Authority::Operator;
}

Result<> Interlock::resetStop()
{
    if (!m_stopLatched) {
        return failure(ErrorCode::Refused, "STOP is not latched");
    }
    m_stopLatched = false;
    return {};
}

void Interlock::latchFault(const QString& reason)
{
    if (!m_fault) {
        m_fault = reason;
    }
}

Result<> Interlock::admitsRearm(const Source& source) const
{
    if (source.kind == SourceKind::Client && m_authority == Authority::Operator) {
        return failure(ErrorCode::Refused, "the operator has taken over: re-arming is up to the operator");
    }
    return {};
}

Result<> Interlock::admits(const Source& source) const
{
    if (m_stopLatched) {
        return failure(ErrorCode::Refused, "STOP is latched: reset STOP first");
    }
    if (m_fault) {
        return failure(ErrorCode::Refused, m_fault->toStdString() + ": re-arm first");
    }
    if (source.kind == SourceKind::Client && m_authority == Authority::Operator) {
        return failure(ErrorCode::Refused, "the operator has taken over: give control back to the clients first");
    }
    return {};
}

}  // namespace boresight
