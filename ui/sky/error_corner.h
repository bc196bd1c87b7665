// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/budget/error_budget.h"
#include "core/units/quantity.h"

#include <QList>
#include <QObject>

#include <optional>

class QWidget;

// The upper right corner of the plot: how far the mount is off its target, as large as the corner permits, the loss in
// dB, the total of the error budget, and a button around the number that opens the budget. Its widgets belong to the
// plot. Gui thread.
namespace boresight::ui {

class BudgetCard;
class OffButton;
class SkyFrame;
class ValueLabel;

class ErrorCorner : public QObject
{
    Q_OBJECT

public:
    explicit ErrorCorner(QWidget& plot);

    // The result is true if other parts are shown than before.
    bool showOffTarget(const std::optional<Angle>& error, Angle beamWidth, bool unplanned);
    // New words once a second, because nobody reads faster. `utc` is that of the status. The result is as above.
    bool showBudget(const std::optional<budget::ErrorBudget>& budget, UtcTime utc);
    void place(const SkyFrame& frame, int gap);  // px

    [[nodiscard]] QList<QWidget*> parts() const;            // those that have a place beside the disc
    [[nodiscard]] QList<const ValueLabel*> words() const;   // for a picture of the plot
    [[nodiscard]] bool isEmpty(const QWidget& part) const;  // it shows nothing now

private:
    void openBudget();

    QWidget& m_plot;
    ValueLabel* m_caption;
    ValueLabel* m_off;
    ValueLabel* m_loss;   // dB
    ValueLabel* m_total;  // of the budget
    OffButton* m_open;
    BudgetCard* m_card;
    std::optional<budget::ErrorBudget> m_budget;
    UtcTime m_worded{};  // when the words of the budget were made
    bool m_totalFits = false;
};

}  // namespace boresight::ui
