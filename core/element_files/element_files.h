// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"

#include <QString>
#include <QStringList>

#include <vector>

// Element sets of files and folders, those of Gpredict included, which stay where they are. Blocking.
namespace boresight::orbit {

struct ElementFiles
{
    std::vector<ElementSet> sets;  // one of each number: the newest epoch wins. In the order of the numbers
    QStringList problems;          // "FILE:LINE: reason", or "FILE: reason"; also where two files disagree
};

// A folder: its files whose names end as files of elements do, without the folders in it. The folder of Gpredict stands
// for its satdata, and a NAME.mod for the satellites of that module. Another file that is named itself may have any
// name, and may be a pipe.
[[nodiscard]] ElementFiles readElementFiles(const QStringList& paths);

}  // namespace boresight::orbit
