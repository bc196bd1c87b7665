// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QStackedWidget;
class QTabWidget;

// Only the visible page needs height, so a panel never scrolls because of a hidden page. The width is that of the
// widest page, so that nothing moves when another page is shown. Gui thread.
namespace boresight::ui {

void keepHeightOfShownPage(QStackedWidget& pages);
void keepHeightOfShownPage(QTabWidget& tabs);

}  // namespace boresight::ui
