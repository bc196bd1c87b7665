// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/select_by_click.h"

#include <QFocusEvent>
#include <QLineEdit>

namespace boresight::ui {

SelectByClick::SelectByClick(QLineEdit& field) : QObject(&field), m_field(field)
{
    m_field.installEventFilter(this);
}

// The focus comes before the press, and the press places the cursor. So the release selects.
bool SelectByClick::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusIn) {
        m_isEntering = static_cast<QFocusEvent*>(event)->reason() == Qt::MouseFocusReason;
    } else if (event->type() == QEvent::MouseButtonRelease && m_isEntering) {
        m_isEntering = false;
        if (!m_field.hasSelectedText()) {
            m_field.selectAll();
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace boresight::ui

#include "moc_select_by_click.cpp"
