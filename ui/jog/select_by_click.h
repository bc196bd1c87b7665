// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QLineEdit;

// The click that gives a field the keyboard selects its whole text, so that typing replaces the text. The next click
// places the cursor, and a drag selects as usual. Gui thread.
namespace boresight::ui {

class SelectByClick : public QObject
{
    Q_OBJECT

public:
    explicit SelectByClick(QLineEdit& field);  // belongs to the field

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLineEdit& m_field;
    bool m_isEntering = false;  // the mouse gave the field the keyboard, and its button is not released yet
};

}  // namespace boresight::ui
