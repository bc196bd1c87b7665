// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"

#include <QString>
#include <QStringList>

#include <vector>

// Reads element sets from files and folders, including those of Gpredict, without copying them. Blocking.
namespace boresight::orbit {

struct ElementFiles
{
    std::vector<ElementSet> sets;  // one per number, with the newest epoch; sorted by number
    QStringList problems;          // "FILE:LINE: reason" or "FILE: reason"; also if two files disagree
};

// A folder stands for its files with an extension of element files, without subfolders. The folder of Gpredict stands
// for its satdata, and a NAME.mod for the satellites of that module. A file that is named directly may have any name
// and may be a pipe.
[[nodiscard]] ElementFiles readElementFiles(const QStringList& paths);

}  // namespace boresight::orbit
