// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/request_desk.h"

#include <QWidget>

// Shows the antenna in use and its beam width, and lets the operator choose another. A refusal of the station is shown
// in the notice line. A button opens the page where the antennas are edited. Hidden for a mount with one antenna only.
// Gui thread.
namespace boresight::ui {

class TouchCombo;
class ValueLabel;

class AntennaRow : public QWidget
{
    Q_OBJECT

public:
    AntennaRow(RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    [[nodiscard]] bool hasChoice() const { return m_names.size() > 1; }

Q_SIGNALS:
    void editWanted();  // opens the page of the antennas

private:
    void choose(int index);

    RequestDesk& m_desk;
    ValueLabel& m_notice;
    TouchCombo* m_antennas;
    ValueLabel* m_beam;
    QStringList m_names;
    QString m_inUse;
    QString m_help;
};

}  // namespace boresight::ui
