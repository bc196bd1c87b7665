// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/page_room.h"

#include "ui/kit/focus_scroll.h"

#include <QScrollArea>
#include <QStackedWidget>
#include <QTabWidget>

namespace boresight::ui {
namespace {

void giveHeightToShownPage(const QStackedWidget& pages)
{
    for (int i = 0; i < pages.count(); ++i) {
        QSizePolicy policy = pages.widget(i)->sizePolicy();
        policy.setVerticalPolicy(i == pages.currentIndex() ? QSizePolicy::Preferred : QSizePolicy::Ignored);
        pages.widget(i)->setSizePolicy(policy);
    }
}

QWidget* pageOf(QWidget* inTab)
{
    const auto* const scroll = qobject_cast<QScrollArea*>(inTab);
    return scroll != nullptr ? scroll->widget() : inTab;
}

}  // namespace

void keepHeightOfShownPage(QStackedWidget& pages)
{
    giveHeightToShownPage(pages);
    QObject::connect(&pages, &QStackedWidget::currentChanged, &pages, [&pages] { giveHeightToShownPage(pages); });
}

int addScrollingPage(QTabWidget& tabs, QWidget& page, const QString& text)
{
    return tabs.addTab(makeFocusScroll(page, tabs), text);
}

int tabOf(const QTabWidget& tabs, const QWidget& page)
{
    for (int tab = 0; tab < tabs.count(); ++tab) {
        if (pageOf(tabs.widget(tab)) == &page) {
            return tab;
        }
    }
    return -1;
}

QWidget* shownPage(const QTabWidget& tabs)
{
    return pageOf(tabs.currentWidget());
}

}  // namespace boresight::ui
