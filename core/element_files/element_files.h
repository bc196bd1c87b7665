// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"

#include <QString>
#include <QStringList>

#include <vector>

// Element sets of files and folders. Blocking.
namespace boresight::orbit {

struct ElementFiles
{
    std::vector<ElementSet> sets;  // one of each number: the newest epoch wins. In the order of the numbers
    QStringList problems;          // "FILE:LINE: reason", or "FILE: reason"
};

// A folder: its files whose names end as files of elements do, without the folders in it. A file that is named itself
// may have any name, and may be a pipe.
[[nodiscard]] ElementFiles readElementFiles(const QStringList& paths);

}  // namespace boresight::orbit
