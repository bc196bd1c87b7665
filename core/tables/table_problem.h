// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <tl/expected.hpp>

// Why a text is not a valid table. A table with an error is refused as a whole, because a jump in it would move the
// mount. Pure value.
namespace boresight::tables {

struct TableProblem
{
    int line = 1;
    QString reason;  // sentences: what is wrong, what to do

    bool operator==(const TableProblem&) const = default;
};

template <class T>
using TableReading = tl::expected<T, TableProblem>;

}  // namespace boresight::tables
