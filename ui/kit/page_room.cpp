// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/page_room.h"

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

}  // namespace

void keepHeightOfShownPage(QStackedWidget& pages)
{
    giveHeightToShownPage(pages);
    QObject::connect(&pages, &QStackedWidget::currentChanged, &pages, [&pages] { giveHeightToShownPage(pages); });
}

void keepHeightOfShownPage(QTabWidget& tabs)
{
    auto* const pages = tabs.findChild<QStackedWidget*>(QString(), Qt::FindDirectChildrenOnly);
    Q_ASSERT(pages != nullptr);
    keepHeightOfShownPage(*pages);
}

}  // namespace boresight::ui
