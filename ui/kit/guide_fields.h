// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QDoubleSpinBox;
class QWidget;

// The fields on the pages of the guide, all alike: numbers with a decimal point, a unit, and a size that a gloved
// finger can hit.
namespace boresight::ui {

struct NumberField
{
    QString name;  // for a screen reader
    QString help;
    double min = 0.0;
    double max = 0.0;
    int decimals = 2;
    QString unit;
};

[[nodiscard]] QDoubleSpinBox* makeField(const NumberField& field, QWidget* parent);

}  // namespace boresight::ui
