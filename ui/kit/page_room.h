// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QStackedWidget;
class QTabWidget;

// Only the page that is shown asks for height. A panel then scrolls for its own contents, never for those of a hidden
// page. The width stays that of the widest page, so that nothing moves when another one is shown. Gui thread.
namespace boresight::ui {

void keepHeightOfShownPage(QStackedWidget& pages);
void keepHeightOfShownPage(QTabWidget& tabs);

}  // namespace boresight::ui
