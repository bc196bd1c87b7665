// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

class QPushButton;
class QTableView;

// Step 1 of finding north: an average of the sensor while the mount stands still. It is accurate to some degrees: only
// a swing shows the deviation of the compass. Details replaces the dial and shows all that the sensor reports.
// More than 15 members: the widgets that it composes.
namespace boresight::ui {

class CommandButton;
class CompassDial;
class DeclinationBox;
class RequestDesk;
class RunLine;
class SensorDetails;
class SensorLevels;
class ValueLabel;

class SensorPage : public QWidget
{
    Q_OBJECT

public:
    SensorPage(RequestDesk& desk, ProfileDraft& draft, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

Q_SIGNALS:
    void settingsWanted(const QString& words);  // settings of the profile with these words in their name or meaning

private:
    void build();
    void showNeedles(const StationStatus& status);
    void showAverage(const StationStatus& status);
    void showOffer(const StationStatus& status);
    [[nodiscard]] QWidget* makeRunLine();
    void showDetails(bool on);
    void copyDetails() const;
    void press();

    ProfileChange m_profileChange;
    bool m_running = false;
    bool m_offers = false;  // the mount has a simulated sensor that the profile does not name
    QWidget* m_overview;
    SensorDetails* m_details;
    QTableView* m_table;
    QPushButton* m_openDetails;
    QPushButton* m_copy;
    CompassDial* m_dial;
    SensorLevels* m_levels;
    ValueLabel* m_sensor;
    ValueLabel* m_axis;
    ValueLabel* m_difference;
    ValueLabel* m_truth;
    ValueLabel* m_offset;
    RunLine* m_run;
    ValueLabel* m_notice;
    DeclinationBox* m_declination;
    CommandButton* m_measure;
};

}  // namespace boresight::ui
