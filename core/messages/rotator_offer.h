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
    QStringList usualPlaces;    // offered besides what is found
    bool onSerialPort = false;  // an entered path is a serial port, which has a speed
    std::string network;        // the kind of bus of an entered HOST:PORT, or of each model
    int usualPort = 0;          // where only a host is entered; 0: none is usual

    QStringList promise;  // what Connect asks there, and what it leaves alone
    QStringList checks;   // in this order, when nothing answers

    bool operator==(const RotatorOffer&) const = default;
};

}  // namespace boresight
