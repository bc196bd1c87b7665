// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QString>
#include <QWidget>

class QDoubleSpinBox;
class QLineEdit;

// Which of the coming passes are listed: words of the name or number, a least height, and whether it must be a
// favourite. Gui thread.
namespace boresight::ui {

class ChoiceButton;

struct PassChoice
{
    QString words;  // all of them; empty: each satellite
    Angle lowest;   // passes that stay below are left out
    bool onlyFavourites = false;

    bool operator==(const PassChoice&) const = default;
};

class PassFilter : public QWidget
{
    Q_OBJECT

public:
    explicit PassFilter(QWidget* parent = nullptr);

    [[nodiscard]] PassChoice choice() const;
    void setOnlyFavourites(bool on);

Q_SIGNALS:
    void changed();

private:
    QLineEdit* m_words;
    QDoubleSpinBox* m_lowest;
    ChoiceButton* m_favourites;
};

}  // namespace boresight::ui
