// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

// The offsets that the sensor of a control box reports, whether they are those of the profile, and the button that
// saves them there. Hidden for a box that reports none. Gui thread.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class ValueLabel;

class SensorOffsetsRow : public QWidget
{
    Q_OBJECT

public:
    SensorOffsetsRow(ProfileDraft& draft, RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    [[nodiscard]] ProfileChange::Edit edit() const;

    ProfileChange m_change;
    std::string m_reported;
    ValueLabel* m_text;
    CommandButton* m_save;
};

}  // namespace boresight::ui
