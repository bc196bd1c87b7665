// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace boresight::ui {

// The layout of the page of the coming passes, stored for the next start.
struct PassesLayout
{
    int view = 0;  // PassViews::View
    bool onlyFavourites = false;
    QStringList columns = {};  // PassColumns::chosen(); empty: as many as there is room for

    bool operator==(const PassesLayout&) const = default;
};

}  // namespace boresight::ui
