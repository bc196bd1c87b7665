// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/axis_driver.h"

#include <QString>
#include <QStringList>

#include <string>

// A kind of rotator as a person chooses it: what it is called, and how its place is entered. Its driver describes it,
// so that nobody else names it. Plain value.
namespace boresight {

struct RotatorOffer
{
    profile::AxisDriver driver = profile::AxisDriver::None;
    QString name;
    // Its bus is one of the adapters of this computer. Else a person enters where it answers.
    bool isListed = false;
    // One of many models: a person chooses it from a list that is asked for.
    bool hasModels = false;

    QString place;  // what is entered is called so
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
