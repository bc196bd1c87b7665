// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/elements/element_address.h"

#include <QByteArray>
#include <QString>

#include <optional>

// The downloaded element sets of this user: of each address a file with the last good answer, and beside it what the
// next question to the server needs. All programs share them. Blocking.
namespace boresight::orbit {

// Of one address. Nothing in it is needed to read the elements.
struct CacheState
{
    QByteArray etag;  // of the answer in the cache, as the server gave it
    QByteArray lastModified;
    std::optional<UtcTime> lastTry;  // the server was asked, whatever came of it
    std::optional<UtcTime> fetched;  // the server gave what the cache has, or said that it is still so
    int failures = 0;                // of the last tries, one after another
    QString problem;                 // of the last try; empty: none

    bool operator==(const CacheState&) const = default;
};

class ElementCache
{
public:
    explicit ElementCache(QString folder) : m_folder(std::move(folder)) {}

    // boresight/elements in the cache folder of this user ($XDG_CACHE_HOME).
    [[nodiscard]] static QString userFolder();

    [[nodiscard]] QString fileOf(const ElementAddress& address) const;
    // What is broken or absent is as if nobody had asked yet.
    [[nodiscard]] CacheState state(const ElementAddress& address) const;
    [[nodiscard]] Result<> keepState(const ElementAddress& address, const CacheState& state) const;
    // All or nothing: what cannot be stored leaves the old answer as it is.
    [[nodiscard]] Result<> keepContent(const ElementAddress& address, const QByteArray& content) const;

private:
    [[nodiscard]] Result<> keep(const QString& path, const QByteArray& bytes) const;

    QString m_folder;
};

}  // namespace boresight::orbit
