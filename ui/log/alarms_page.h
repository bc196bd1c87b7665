// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

#include <optional>

// The alarms: what happened, what Boresight did, what to do, and whether it is over. One of them or all can be
// acknowledged. The page also decides when a new alarm is heard: once, unless the operator has switched the sound off.
namespace boresight::ui {

class AlarmModel;
class AlarmOrder;
class CommandButton;
class LinesView;
class RequestDesk;

class AlarmsPage : public QWidget
{
    Q_OBJECT

public:
    AlarmsPage(RequestDesk& desk, bool sound, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

Q_SIGNALS:
    void beepWanted();
    void soundChanged(bool on);

private:
    void addSound();
    void acknowledgeSelected();
    void blockAcknowledge();
    [[nodiscard]] std::optional<int> selectedRow() const;
    [[nodiscard]] QString whyNotSelected() const;

    AlarmModel* m_model;
    AlarmOrder* m_order;
    LinesView* m_view;
    CommandButton* m_acknowledge;
    CommandButton* m_acknowledgeAll;
    bool m_sound;
};

}  // namespace boresight::ui
