// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

// What Hamlib's rotctld was recorded to answer (tests/data/rotctld_cases.json), and where ours answers otherwise on
// purpose. Whoever plays an exchange returns an empty text when the replies were the same.
namespace boresight::fakes {

using PlayExchange = std::function<std::string(const QJsonObject&)>;
// core/rotctld/HAMLIB.md, "Where we differ": name of the exchange -> number of the difference.
using RotctldDifferences = std::map<std::string, int>;

[[nodiscard]] const std::vector<QJsonObject>& recordedExchanges();
[[nodiscard]] std::set<std::string> recordedGroups();
[[nodiscard]] RotctldDifferences rotctldDifferences();  // of the server, whatever mount is behind it

void expectGroupAsRecorded(const std::string& group, const RotctldDifferences& differences, const PlayExchange& play);
// A difference that is none any more must leave the table.
void expectRealDifferences(const RotctldDifferences& differences, const PlayExchange& play);

}  // namespace boresight::fakes
