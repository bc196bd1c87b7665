// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

// The recorded replies of Hamlib's rotctld (tests/data/rotctld_cases.json), and where Boresight differs on purpose. A
// player of an exchange returns an empty text when the replies were the same.
namespace boresight::fakes {

using PlayExchange = std::function<std::string(const QJsonObject&)>;
// The table of core/rotctld/HAMLIB.md, "Differences from Hamlib": name of the exchange -> number of the difference.
using RotctldDifferences = std::map<std::string, int>;

[[nodiscard]] const std::vector<QJsonObject>& recordedExchanges();
[[nodiscard]] std::set<std::string> recordedGroups();
[[nodiscard]] RotctldDifferences rotctldDifferences();  // of the server, with any mount behind it

void expectGroupAsRecorded(const std::string& group, const RotctldDifferences& differences, const PlayExchange& play);
// A difference that does not occur any more must be removed from the table.
void expectRealDifferences(const RotctldDifferences& differences, const PlayExchange& play);

}  // namespace boresight::fakes
