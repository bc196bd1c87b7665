// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/focus_scroll.h"

#include "ui/kit/theme.h"

#include <QApplication>
#include <QScrollArea>
#include <QScrollBar>

namespace boresight::ui {

QScrollArea* makeFocusScroll(QWidget& page, QWidget& parent)
{
    auto* const scroll = new QScrollArea(&parent);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);  // content with as little height as there is
    scroll->setWidget(&page);
    page.setAutoFillBackground(false);  // the card below shows through
    scroll->viewport()->setAutoFillBackground(false);
    scroll->setMinimumWidth(page.minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    QObject::connect(qApp, &QApplication::focusChanged, scroll, [scroll](const QWidget* before, QWidget* now) {
        const bool isControl = before != nullptr && now != nullptr && now->focusPolicy() != Qt::NoFocus;
        if (isControl && scroll->widget()->isAncestorOf(now) && QGuiApplication::mouseButtons() == Qt::NoButton) {
            scroll->ensureWidgetVisible(now, 0, kGrid);
        }
    });
    return scroll;
}

}  // namespace boresight::ui
