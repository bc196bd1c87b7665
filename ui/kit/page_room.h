// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QStackedWidget;
class QString;
class QTabWidget;
class QWidget;

// The room of pages in the place of each other. Gui thread.
namespace boresight::ui {

// Only the visible page needs height, so a panel never scrolls because of a hidden page. The width is that of the
// widest page, so that nothing moves when another page is shown.
void keepHeightOfShownPage(QStackedWidget& pages);

// Adds a page that scrolls in a low window while the tabs stay in sight. Returns its tab.
int addScrollingPage(QTabWidget& tabs, QWidget& page, const QString& text);
// The tab of a page, whether it scrolls or not. -1: it is not one of these pages.
[[nodiscard]] int tabOf(const QTabWidget& tabs, const QWidget& page);
[[nodiscard]] QWidget* shownPage(const QTabWidget& tabs);

}  // namespace boresight::ui
