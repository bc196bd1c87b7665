// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/asking_panel.h"

#include <array>

// All boards come from the factory with the same id. This part of the step Connect gives each board its own id. Only
// one board is on the bus. The operator says which axis it turns. The station writes the id, reads it back and stores
// it. Then the other board follows.
namespace boresight::ui {

class BusPicture;

class GuideBoards : public AskingPanel
{
    Q_OBJECT

public:
    explicit GuideBoards(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    // True if there is something to report or to do.
    [[nodiscard]] static bool isNeeded(const StationStatus& status);

private:
    void build();
    void showSentence(const DrivesStatus& drives);
    void assign(Axis axis);

    StationStatus m_status;
    BusPicture* m_picture;
    ValueLabel* m_sentence;
    ValueLabel* m_notice;
    std::array<CommandButton*, 2> m_buttons;  // by axis
};

}  // namespace boresight::ui
