// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/guide/guide_progress.h"

#include <QStackedWidget>

// Shows the panels, or the guide in their place. The guide is made when it is first opened. Gui thread.
namespace boresight::ui {

class GuidePage;
class HostDesk;
class LastStatus;
class PanelTabs;
class ProfileDraft;
class RequestDesk;

class GuideRoom : public QStackedWidget
{
    Q_OBJECT

public:
    // Uses none of the arguments while it is being destroyed.
    GuideRoom(PanelTabs& panels, const LastStatus& last, ProfileDraft& draft, RequestDesk& desk, HostDesk& host,
              GuideProgress progress, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    // Shows the guide if the last run of the program ended in it. It waits until the mount of the guide is known.
    void resume();
    void showGuide();
    void showStep(GuideStep step);
    void showPanels();
    void toggle();

Q_SIGNALS:
    void progressChanged(const boresight::ui::GuideProgress& progress);
    void guideShown(bool shown);

private:
    void makeGuide();
    [[nodiscard]] bool showsGuide() const;

    PanelTabs& m_panels;
    const LastStatus& m_last;
    ProfileDraft& m_draft;
    RequestDesk& m_desk;
    HostDesk& m_host;
    GuideProgress m_progress;  // as it was at the start
    GuidePage* m_guide = nullptr;
};

}  // namespace boresight::ui
