// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <QString>

#include <vector>

// A device of this computer by which a mount may be reached, with its names for people and profiles. Plain value.
namespace boresight {

struct Adapter
{
    QString bus;              // as in a profile: its kind and a path that stays the same
    QString name;             // maker and product, as the device reports them
    QString detail;           // serial number or port, which distinguishes two devices of one kind
    bool recognised = false;  // known to be made for these drives; false: it may be any device
    bool simulated = false;   // a program answers instead of a real drive
    bool hasDrives = true;    // true: drives may answer; false: a rotator control box may answer
    QString serialPort;       // the port on which a rotator control box may answer instead; empty: none

    bool operator==(const Adapter&) const = default;
};

}  // namespace boresight

Q_DECLARE_METATYPE(std::vector<boresight::Adapter>)
