// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

// The recorded behaviour of real firmware: tests/data/moteus_golden.json, or another file of the same schema named by
// the environment variable MOTEUS_GOLDEN.
namespace boresight::sim::golden {

[[nodiscard]] QJsonArray vectors(const char* group);

// A number, or one of the texts "nan", "inf", "-inf"; `absent` if the key is missing.
[[nodiscard]] double number(const QJsonObject& object, const char* key, double absent);
[[nodiscard]] double number(const QJsonValue& value);

}  // namespace boresight::sim::golden
