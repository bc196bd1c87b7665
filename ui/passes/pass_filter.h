// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QString>
#include <QWidget>

class QDoubleSpinBox;
class QLineEdit;

// The filter of the list of passes: words of the name or number, the lowest maximum elevation, and favourites only. Gui
// thread.
namespace boresight::ui {

class ChoiceButton;

struct PassChoice
{
    QString words;  // all of these words must occur; empty: every satellite
    Angle lowest;   // passes whose highest elevation is lower are hidden
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
