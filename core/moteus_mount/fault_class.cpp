// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/fault_class.h"

namespace boresight {

using supervision::LossClass;

// Each code is described in core/moteus/faults.cpp. 33 and 44 mostly come from a sagging supply. But the code does not
// separate that from a burnt bridge, which a second attempt would damage further, so a person must look. 34 and 40 come
// from the supply only. 41 comes while somebody writes settings. With 49 and 50 the axis is blocked, or its gains are
// wrong.
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
