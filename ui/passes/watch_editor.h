// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

#include <cstdint>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

// The watch list of the profile. The operator selects an entry and changes its priority and lowest elevation, or
// removes it. Changes apply at once. Satellites are added on the page of the coming passes. Gui thread.
namespace boresight::ui {

class CommandButton;
class ProfileDraft;
class RequestDesk;
class ValueLabel;

class WatchEditor : public QWidget
{
    Q_OBJECT

public:
    WatchEditor(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    void showList(const StationStatus& status);
    void showChosen();
    void change();
    void remove();

    ProfileDraft& m_draft;
    std::vector<schedule::WatchEntry> m_entries;  // the entries that are shown
    QComboBox* m_satellite;
    QSpinBox* m_priority;
    QDoubleSpinBox* m_lowest;
    ValueLabel* m_refused;
    CommandButton* m_set;
    CommandButton* m_remove;
};

}  // namespace boresight::ui
