// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/touch_combo.h"

#include "ui/kit/command_button.h"
#include "ui/kit/theme.h"

#include <QSignalBlocker>

namespace boresight::ui {

TouchCombo::TouchCombo(const QString& name, const QString& help, QWidget* parent) : QComboBox(parent)
{
    setFont(fonts::label());
    setAccessibleName(name);
    setToolTip(help);
    setMinimumHeight(kTouchSize);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setInsertPolicy(QComboBox::NoInsert);
}

void TouchCombo::setLines(const QStringList& lines)
{
    const QSignalBlocker quiet(this);
    const QString typed = isEditable() ? currentText() : QString();
    clear();
    for (const QString& line : lines) {
        addItem(line);
        setItemData(count() - 1, QSize(0, kTouchSize), Qt::SizeHintRole);
    }
    setCurrentIndex(-1);
    if (isEditable()) {
        setEditText(typed);
    }
}

}  // namespace boresight::ui

#include "moc_touch_combo.cpp"
