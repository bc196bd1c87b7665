// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

#include <cstdint>
#include <optional>

// The bar below every step of the North panel: the proposal with every value before and after, Apply, Discard and Undo.
// Apply and Discard refer to the proposal that was shown when the button was pressed. If there is another proposal by
// then, the station refuses.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class ValueLabel;

class CalibrationBar : public QWidget
{
    Q_OBJECT

public:
    explicit CalibrationBar(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    void showChange(const std::optional<CalibrationProposal>& proposal);

    ValueLabel* m_title;
    ValueLabel* m_change;
    ValueLabel* m_notice;
    CommandButton* m_apply;
    CommandButton* m_discard;
    CommandButton* m_undo;
    std::uint64_t m_shown = 0;    // number of the proposal
    std::uint64_t m_pressed = 0;  // the proposal that was shown when Apply or Discard was pressed
};

}  // namespace boresight::ui
