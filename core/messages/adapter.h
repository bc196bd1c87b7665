// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <QString>

#include <vector>

// What a mount may be reached by, with the names that people and profiles use. Plain value.
namespace boresight {

struct Adapter
{
    QString bus;              // as a profile names it: its kind, and the path that stays the same
    QString name;             // as it calls itself: maker and product
    QString detail;           // serial number, port: what tells two of a kind apart
    bool recognised = false;  // made for these drives; else it may be something else altogether
    bool simulated = false;   // a program answers there, and no real drive
    bool hasDrives = true;    // may have; else the box of a rotator answers there
    QString serialPort;       // where the box of a rotator may answer instead; empty: nowhere

    bool operator==(const Adapter&) const = default;
};

}  // namespace boresight

Q_DECLARE_METATYPE(std::vector<boresight::Adapter>)
