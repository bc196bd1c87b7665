// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>
#include <QUrl>

#include <string>
#include <string_view>
#include <vector>

// Where element sets are downloaded from: an address, or a group of CelesTrak by its name. Pure.
namespace boresight::orbit {

struct ElementAddress
{
    // For messages, without parts that may be secret: "CelesTrak group stations", "https://example.org/a.json".
    QString name;
    QUrl url;
    QString file;  // the name of its file in the cache

    bool operator==(const ElementAddress&) const = default;
};

// True for an entry of a list of element files that is not a path: "celestrak:stations", "https://example.org/a.json".
[[nodiscard]] bool isElementAddress(std::string_view entry);

// Accepts https, and http only for mirrors on this computer.
[[nodiscard]] Result<ElementAddress> parseElementAddress(std::string_view entry);

// The valid addresses among the entries, each once.
[[nodiscard]] std::vector<ElementAddress> elementAddresses(const std::vector<std::string>& entries);

// Whether a download may go to this address. Needed because a server may redirect.
[[nodiscard]] bool isPermittedAddress(const QUrl& url);

}  // namespace boresight::orbit
