// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QPushButton;

// The guide's step for north. It shows the direction that the mount reports, and the operator enters the true
// direction. Only the azimuth offset of the pointing model changes, at once. The antenna does not move, and the angles
// of its cable do not change. The field shows the azimuth of the beam until the operator types. It shows it again after
// the operator has left the step or connected another mount. A known north is replaced only if the operator has ticked
// this. A button opens the North panel, which finds north with the sensor, the Sun or the Moon.
namespace boresight::ui {

class CommandButton;
class HoldButtons;
class ValueLabel;

class GuideNorth : public QWidget
{
    Q_OBJECT

public:
    GuideNorth(ProfileChange& change, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

Q_SIGNALS:
    void done();         // the station has taken the new north
    void panelWanted();  // asks for the North panel

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void type();
    void forget();
    void taken();
    void showKnown();
    void showEffect();
    [[nodiscard]] bool isBeamKnown() const;
    [[nodiscard]] AxisPosition axes() const;
    [[nodiscard]] QString whyNot() const;
    [[nodiscard]] ProfileChange::Edit edit() const;

    ProfileChange& m_change;
    StationStatus m_status;
    ValueLabel* m_notice;
    ValueLabel* m_explanation;
    ValueLabel* m_pointing;
    ValueLabel* m_effect;
    QDoubleSpinBox* m_truth;
    bool m_typed = false;  // the operator has typed into m_truth
    bool m_known = false;  // north was already known
    QCheckBox* m_replace;
    HoldButtons* m_hold;
    CommandButton* m_set;
    QPushButton* m_panel;
};

}  // namespace boresight::ui
