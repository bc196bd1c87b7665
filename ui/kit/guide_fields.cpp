// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/guide_fields.h"

#include "ui/kit/decimal_box.h"
#include "ui/kit/theme.h"

namespace boresight::ui {

namespace {
constexpr int kHeight = 36;  // px; four rows of them fit at 1024×700
}

QDoubleSpinBox* makeField(const NumberField& field, QWidget* parent)
{
    auto* const box = new DecimalBox(parent);
    box->setFont(fonts::label());
    box->setDecimals(field.decimals);
    box->setRange(field.min, field.max);
    box->setSuffix(field.unit);
    box->setMinimumHeight(kHeight);
    box->setAccessibleName(field.name);
    box->setToolTip(field.help);
    return box;
}

}  // namespace boresight::ui
