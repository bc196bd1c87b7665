// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/elements/element_address.h"

#include <QByteArray>
#include <QString>

#include <optional>

// The downloaded element sets of this user: one file per address with the last good answer, and beside it the state
// that the next request needs. All programs share the cache. Blocking.
namespace boresight::orbit {

// The state of one address. Reading the elements does not need it.
struct CacheState
{
    QByteArray etag;  // of the answer in the cache, as the server sent it
    QByteArray lastModified;
    std::optional<UtcTime> lastTry;  // time of the last request, whatever its result was
    std::optional<UtcTime> fetched;  // when the server sent the content of the cache or confirmed it as unchanged
    int failures = 0;                // number of failed requests in a row
    QString problem;                 // of the last request; empty: none

    bool operator==(const CacheState&) const = default;
};

class ElementCache
{
public:
    explicit ElementCache(QString folder) : m_folder(std::move(folder)) {}

    // boresight/elements in the cache folder of this user ($XDG_CACHE_HOME).
    [[nodiscard]] static QString userFolder();

    [[nodiscard]] QString fileOf(const ElementAddress& address) const;
    // A broken or missing state counts as if no request was ever made.
    [[nodiscard]] CacheState state(const ElementAddress& address) const;
    [[nodiscard]] Result<> keepState(const ElementAddress& address, const CacheState& state) const;
    // All or nothing: if the content cannot be stored, the old answer stays.
    [[nodiscard]] Result<> keepContent(const ElementAddress& address, const QByteArray& content) const;

private:
    [[nodiscard]] Result<> keep(const QString& path, const QByteArray& bytes) const;

    QString m_folder;
};

}  // namespace boresight::orbit
