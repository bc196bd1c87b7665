// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/fault_class.h"

namespace boresight {

using supervision::LossClass;

LossClass classOfFault(int code)
{
    switch (code) {
        case 35:
        case 42:
        case 43:
            return LossClass::Encoder;
        case 36:
        case 39:
        case 41:
        case 45:
        case 47:
        case 48:
            return LossClass::Configuration;
        case 34:
        case 40:
            return LossClass::Supply;
        case 38:
            return LossClass::OverTemperature;
        case 49:
        case 50:
            return LossClass::Motion;
        default:
            return LossClass::Driver;
    }
}

}  // namespace boresight
