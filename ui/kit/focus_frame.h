// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

// The frame around a list, table or text that has the keyboard focus. Qt shows only the selected line there, and
// nothing without a selected line. The frame takes no mouse clicks and no room. Gui thread.
namespace boresight::ui {

class FocusFrame : public QObject
{
    Q_OBJECT

public:
    explicit FocusFrame(QObject* parent);

private:
    void follow(QWidget* focused);

    QPointer<QWidget> m_frame;  // owned by the widget that it frames
};

}  // namespace boresight::ui
