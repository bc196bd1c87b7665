// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

#include <cstdint>
#include <optional>

// Below every step of the North panel: what is proposed, every figure before and after, Apply, Discard and Undo. What
// is applied or discarded is the proposal that stood there when the button was pressed; were it another one by then,
// the station refuses.
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
    std::uint64_t m_pressed = 0;  // that was shown when Apply or Discard was pressed
};

}  // namespace boresight::ui
