// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace boresight::ui {

// How the page of the coming passes looks, kept from one run to the next.
struct PassesLayout
{
    int view = 0;  // of PassViews
    bool onlyFavourites = false;
    QStringList columns = {};  // of PassColumns; empty: as many as there is room for

    bool operator==(const PassesLayout&) const = default;
};

}  // namespace boresight::ui
