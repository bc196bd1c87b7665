// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QPushButton;

// The guide's step for north: where the antenna says it points, and where it really points. Only the azimuth offset of
// the pointing model changes, at once; the antenna stays where it is, and so do the numbers of its cable. The field
// shows what the beam reads until somebody types, and again when the step is left or another mount connected; and a
// north that is known is replaced only when that is ticked too.
// The North panel, which asks the sensor, the Sun or the Moon instead, is one press away.
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
    void panelWanted();  // the North panel

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
    bool m_typed = false;  // into m_truth
    bool m_known = false;  // where north is, before anything is typed
    QCheckBox* m_replace;
    HoldButtons* m_hold;
    CommandButton* m_set;
    QPushButton* m_panel;
};

}  // namespace boresight::ui
