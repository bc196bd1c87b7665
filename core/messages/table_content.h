// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/targets/target.h"

#include <QDateTime>
#include <QString>

#include <chrono>
#include <memory>

// The content of the file of a table as it was read for the window. Plain value that never changes, so threads share
// it.
namespace boresight {

// After this time nobody waits for a file any more. A blocked folder of another computer may take longer.
inline constexpr std::chrono::seconds kLongestTableReading{30};

struct TableContent
{
    // Each change of the file gives another state.
    struct State
    {
        bool exists = false;
        qint64 bytes = 0;
        QDateTime changed;

        bool operator==(const State&) const = default;
    };

    QString path;
    State state;
    Result<targets::Target> table;  // or why it is no table: "FILE:LINE: reason"
};

using SharedTableContent = std::shared_ptr<const TableContent>;

}  // namespace boresight
