// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QWidget>

class QDoubleSpinBox;
class QPushButton;

namespace boresight::ui {

class ProfileDraft;

// Computes the beam width from dish and frequency, or from the gain. Use puts it into the draft. Gui thread.
class BeamBox : public QWidget
{
    Q_OBJECT

public:
    explicit BeamBox(ProfileDraft& draft, QWidget* parent = nullptr);

private:
    void build();
    void describe();
    void use(Angle width);
    [[nodiscard]] Angle widthOfDish() const;
    [[nodiscard]] Angle widthOfGain() const;

    ProfileDraft& m_draft;
    QDoubleSpinBox* m_diameter;   // m
    QDoubleSpinBox* m_frequency;  // MHz
    QDoubleSpinBox* m_gain;       // dBi
    QPushButton* m_useDish;
    QPushButton* m_useGain;
};

}  // namespace boresight::ui
