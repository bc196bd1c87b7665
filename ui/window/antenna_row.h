// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/request_desk.h"

#include <QWidget>

// Which antenna is in use, to choose another one, and how wide its beam is. What the station refuses is told in the
// notice line. A button leads to where the antennas are edited. Not there where the mount has one antenna only. Gui
// thread.
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
    void editWanted();  // of the antennas

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
