// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/guide/guide_progress.h"
#include "ui/link/profile_change.h"

#include <QWidget>

#include <functional>
#include <map>

class QPushButton;
class QStackedWidget;

// Commissioning of a mount, step by step. It shows a row of the steps with their states, the page of the current step,
// and the buttons Back, Next, Confirm and Finish later. Confirm is for facts that only the operator can see. Next alone
// never makes a step done. The guide takes the place of the panels and covers nothing else. The key of a panel leads
// back to it, and the guide continues later at the same step. Everything in the guide can also be done in the panels.
namespace boresight::ui {

class HostDesk;
class StepButton;
class ValueLabel;

class GuidePage : public QWidget
{
    Q_OBJECT

public:
    GuidePage(ProfileDraft& draft, RequestDesk& desk, HostDesk& host, const GuideProgress& progress,
              QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void setOpen(bool on);  // stores whether the guide is shown
    void focusStep();       // gives the keyboard to the current step
    void open(GuideStep step);

    [[nodiscard]] const GuideProgress& progress() const { return m_progress; }

Q_SIGNALS:
    void closeWanted();
    void northWanted();  // asks for the panel with the other ways to find north
    void progressChanged(const boresight::ui::GuideProgress& progress);

private:
    void makePages(RequestDesk& desk, HostDesk& host);
    void makeSteps();
    void build();
    QPushButton* makeButton(const QString& text, const QString& help, void (GuidePage::*act)());
    void go(GuideStep step);
    void back();
    void next();
    void confirm();
    void take(GuideStep step);
    void goOn();
    void finishLater();
    void showSteps();
    void showButtons(const StepReport& report);
    void showPage();
    void showHint();

    ProfileChange m_change;
    GuideProgress m_progress;
    StationStatus m_status;
    std::map<GuideStep, StepButton*> m_buttons;
    std::map<GuideStep, std::function<void(const StationStatus&)>> m_show;  // shows the status on the page of a step
    QStackedWidget* m_pages;
    ValueLabel* m_title;
    ValueLabel* m_hint;
    QPushButton* m_back = nullptr;
    QPushButton* m_next = nullptr;
    QPushButton* m_confirm = nullptr;
    QPushButton* m_finish = nullptr;
};

}  // namespace boresight::ui
