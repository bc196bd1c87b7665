// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

// The result of a scan of a bus that no station is using. Plain values for the operator.
namespace boresight {

struct ScannedDrive
{
    int id = 0;
    QString uuid;  // empty: the drive did not report it
    QString firmware;
    std::optional<double> voltage;      // V
    std::optional<double> temperature;  // °C

    bool operator==(const ScannedDrive&) const = default;
};

struct ScanResult
{
    QString bus;
    std::vector<ScannedDrive> drives;  // ordered by id
    QStringList problems;              // faults with their remedies; also why the bus could not be scanned
    bool simulated = false;            // a program has answered instead of a real drive

    bool operator==(const ScanResult&) const = default;
};

}  // namespace boresight

Q_DECLARE_METATYPE(boresight::ScanResult)
