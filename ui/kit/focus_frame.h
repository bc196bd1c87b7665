// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

// The frame around a list, table or text that has the keyboard. Qt only shows which line is selected there, and nothing
// if no line is. It takes neither mouse clicks nor room. Gui thread.
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
