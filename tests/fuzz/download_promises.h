// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/element_web/element_cache.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>

// What a download promises, whatever was answered: it ends in a stored answer with element sets, or in one short
// printable problem, and what was stored before is never replaced by something without sets.
namespace boresight::fuzz {

class DownloadPromises
{
public:
    DownloadPromises(const QString& folder, const orbit::ElementAddress& address) : m_cache(folder), m_address(address)
    {}

    // After each answer. `asked`: when the server was. Empty: no server was found.
    void check(bool isStored, const QStringList& problems, const std::optional<UtcTime>& asked);

private:
    [[nodiscard]] QByteArray cached() const;
    void checkProblems(bool isStored, const QStringList& problems) const;

    orbit::ElementCache m_cache;
    orbit::ElementAddress m_address;
    QByteArray m_before;  // what the answer before has left
    std::optional<UtcTime> m_lastTry;
};

}  // namespace boresight::fuzz
