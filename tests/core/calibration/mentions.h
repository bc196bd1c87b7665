// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <gmock/gmock.h>

#include <string>

namespace boresight::calibration {

// A sentence that contains this text.
inline auto mentions(const std::string& part)
{
    return testing::Property(&QString::toStdString, testing::HasSubstr(part));
}

}  // namespace boresight::calibration
