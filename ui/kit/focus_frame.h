// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

// The frame around a list, table or text that has the keyboard: Qt shows there only which line is chosen, and nothing
// at all where none is. Takes no mouse and no room. Gui thread.
namespace boresight::ui {

class FocusFrame : public QObject
{
    Q_OBJECT

public:
    explicit FocusFrame(QObject* parent);

private:
    void follow(QWidget* focused);

    QPointer<QWidget> m_frame;  // belongs to what it frames
};

}  // namespace boresight::ui
