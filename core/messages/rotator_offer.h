// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/axis_driver.h"

#include <QString>
#include <QStringList>

#include <string>

// A kind of rotator that a person can choose: its name, and how its address is entered. Its driver describes it, so no
// other code names it. Plain value.
namespace boresight {

struct RotatorOffer
{
    profile::AxisDriver driver = profile::AxisDriver::None;
    QString name;
    // True: its bus is one of the adapters of this computer. False: a person enters its address.
    bool isListed = false;
    // True: there are many models, and a person chooses one from a list (RotatorModels).
    bool hasModels = false;

    QString place;  // label of the field for the address
    QString placeHelp;
    QString example;
    QStringList usualPlaces;    // offered in addition to the places that were found
    bool onSerialPort = false;  // a path that a person enters is a serial port and has a speed
    std::string network;        // kind of bus for an entered HOST:PORT, and for a model
    int usualPort = 0;          // used if only a host is entered; 0: none

    QStringList promise;  // what Connect asks there, and what it does not change
    QStringList checks;   // what to check if nothing answers, in this order

    bool operator==(const RotatorOffer&) const = default;
};

}  // namespace boresight
