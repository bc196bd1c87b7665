// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;

// The guide's step for elevation 0°. It shows the reading of the axis, takes the true elevation, and shows the new ends
// of travel before the change is made. The antenna does not move.
namespace boresight::ui {

class CommandButton;
class HoldButtons;
class ValueLabel;

class GuideZero : public QWidget
{
    Q_OBJECT

public:
    GuideZero(ProfileChange& change, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

Q_SIGNALS:
    void done();  // the station has accepted the new zero

private:
    void build();
    void showEffect();
    void set();
    [[nodiscard]] Angle truth() const;
    [[nodiscard]] QString whyNot() const;
    [[nodiscard]] ProfileChange::Edit edit() const;

    ProfileChange& m_change;
    StationStatus m_status;
    ValueLabel* m_notice;
    ValueLabel* m_explanation;
    ValueLabel* m_reading;
    ValueLabel* m_effect;
    QWidget* m_entry;  // the row for the true value
    QDoubleSpinBox* m_truth;
    QCheckBox* m_endsStay;
    HoldButtons* m_hold;
    CommandButton* m_set;
};

}  // namespace boresight::ui
