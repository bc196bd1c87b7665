// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/window/link_labels.h"

#include <QWidget>

class QToolButton;

// The top row, visible with every panel: the state in a word with its reason, the target and its source, the links,
// UTC, the SIMULATED tag, STOP. Shows the status and decides nothing.
namespace boresight::ui {

class StopButton;
class AuthorityButton;
class ValueLabel;

class HeaderBar : public QWidget
{
    Q_OBJECT

public:
    // `authority` is the button below the name of the client in control.
    explicit HeaderBar(AuthorityButton& authority, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void setOnlySimulated();  // shows the word SIMULATED
    void setStopRequested();  // until the status says STOPPED
    void setStopRefused();

    [[nodiscard]] const QWidget& menuButton() const;

Q_SIGNALS:
    void stopPressed();
    void menuWanted();

private:
    void build(AuthorityButton& authority);
    void showState(const StationStatus& status);
    void showTarget(const StationStatus& status);
    [[nodiscard]] QString inTwoLines(QStringList parts) const;
    [[nodiscard]] bool isWhole(const QString& text) const;
    [[nodiscard]] QString withSecondLine(const QString& doing, const QString& second) const;
    void showControl(const StationStatus& status);
    void showClock(const StationStatus& status);

    ValueLabel* m_state;
    ValueLabel* m_reason;
    ValueLabel* m_limited;
    ValueLabel* m_target;
    LinkLabels m_links;
    ValueLabel* m_control;
    ValueLabel* m_utc;
    ValueLabel* m_clock;  // how far it may be off
    ValueLabel* m_simulated;
    QToolButton* m_menu;
    StopButton* m_stop;
    bool m_stopRequested = false;
};

}  // namespace boresight::ui
