// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/element_web/element_cache.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>

// The promises of a download, whatever the answer is. It ends with a stored answer that has element sets, or with one
// short printable problem. An earlier stored answer is never replaced by one without sets.
namespace boresight::fuzz {

class DownloadPromises
{
public:
    DownloadPromises(const QString& folder, const orbit::ElementAddress& address) : m_cache(folder), m_address(address)
    {}

    // Called after each answer. `asked` is the time of the request. Empty: no server was found.
    void check(bool isStored, const QStringList& problems, const std::optional<UtcTime>& asked);

private:
    [[nodiscard]] QByteArray cached() const;
    void checkProblems(bool isStored, const QStringList& problems) const;

    orbit::ElementCache m_cache;
    orbit::ElementAddress m_address;
    QByteArray m_before;  // left by the previous answer
    std::optional<UtcTime> m_lastTry;
};

}  // namespace boresight::fuzz
