// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/asking_panel.h"

#include <QWidget>

#include <memory>
#include <optional>

// The bar below every step of the North panel: the proposal with every value before and after, Apply, Discard and Undo.
// Apply and Discard refer to the proposal that was shown when the button was pressed. If there is another proposal by
// then, the station refuses. An unreliable result is applied only after the operator has confirmed it.
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

Q_SIGNALS:
    void confirmationWanted(const boresight::ui::Question& question);  // before an unreliable result is applied

private:
    void build();
    void apply();
    void showApply(const StationStatus& status);
    void showChange(const std::optional<CalibrationProposal>& proposal);

    ValueLabel* m_title;
    ValueLabel* m_change;
    ValueLabel* m_notice;
    CommandButton* m_apply;
    CommandButton* m_discard;
    CommandButton* m_undo;
    std::shared_ptr<const CalibrationStatus> m_shown;
    std::shared_ptr<const CalibrationStatus> m_pressed;  // that was shown when Apply or Discard was pressed
};

}  // namespace boresight::ui
