// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/sim/golden_vectors.h"

#include <QFile>
#include <QJsonDocument>

#include <limits>

namespace boresight::sim::golden {

QJsonArray vectors(const char* group)
{
    const QString other = qEnvironmentVariable("MOTEUS_GOLDEN");
    QFile file(other.isEmpty() ? QStringLiteral(BORESIGHT_TEST_DATA "/moteus_golden.json") : other);
    if (!file.open(QIODevice::ReadOnly)) {
        qFatal("cannot read %s", qPrintable(file.fileName()));
    }
    const QJsonArray found = QJsonDocument::fromJson(file.readAll()).object().value(QLatin1String(group)).toArray();
    if (found.isEmpty()) {
        qFatal("no vectors '%s' in %s", group, qPrintable(file.fileName()));
    }
    return found;
}

double number(const QJsonValue& value)
{
    if (value.isDouble()) {
        return value.toDouble();
    }
    const QString text = value.toString();
    if (text == QLatin1String("inf")) {
        return std::numeric_limits<double>::infinity();
    }
    return text == QLatin1String("-inf") ? -std::numeric_limits<double>::infinity()
                                         : std::numeric_limits<double>::quiet_NaN();
}

double number(const QJsonObject& object, const char* key, double absent)
{
    const QJsonValue value = object.value(QLatin1String(key));
    return value.isUndefined() ? absent : number(value);
}

}  // namespace boresight::sim::golden
