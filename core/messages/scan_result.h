// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

// What a look at a bus that no station works on has found: plain values for the operator.
namespace boresight {

struct ScannedDrive
{
    int id = 0;
    QString uuid;  // empty if it did not tell
    QString firmware;
    std::optional<double> voltage;      // V
    std::optional<double> temperature;  // °C

    bool operator==(const ScannedDrive&) const = default;
};

struct ScanResult
{
    QString bus;
    std::vector<ScannedDrive> drives;  // by their ids
    QStringList problems;              // what is wrong and what to do about it; also why nobody could be asked
    bool simulated = false;            // a program has answered, and no real drive

    bool operator==(const ScanResult&) const = default;
};

}  // namespace boresight

Q_DECLARE_METATYPE(boresight::ScanResult)
