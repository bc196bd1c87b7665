// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/guide_room.h"

#include "ui/guide/guide_page.h"
#include "ui/kit/page_room.h"
#include "ui/north/calibration_panel.h"
#include "ui/passes/passes_panel.h"
#include "ui/window/last_status.h"
#include "ui/window/panel_tabs.h"

#include <utility>

namespace boresight::ui {

GuideRoom::GuideRoom(PanelTabs& panels, const LastStatus& last, ProfileDraft& draft, RequestDesk& desk, HostDesk& host,
                     GuideProgress progress, QWidget* parent)
    : QStackedWidget(parent),
      m_panels(panels),
      m_last(last),
      m_draft(draft),
      m_desk(desk),
      m_host(host),
      m_progress(std::move(progress))
{
    addWidget(&m_panels);
    keepHeightOfShownPage(*this);
    connect(&m_panels.passes(), &PassesPanel::siteWanted, this, [this] { showStep(GuideStep::Site); });
    connect(&m_panels, &PanelTabs::broughtUp, this, &GuideRoom::showPanels);
    connect(this, &QStackedWidget::currentChanged, this, [this] { Q_EMIT guideShown(showsGuide()); });
}

void GuideRoom::showStatus(const StationStatus& status)
{
    if (m_guide != nullptr) {
        m_guide->showStatus(status);
    }
}

void GuideRoom::makeGuide()
{
    m_guide = new GuidePage(m_draft, m_desk, m_host, m_progress, this);
    addWidget(m_guide);
    connect(m_guide, &GuidePage::northWanted, this, [this] { m_panels.bringUp(m_panels.north()); });
    connect(m_guide, &GuidePage::closeWanted, this, &GuideRoom::showPanels);
    connect(m_guide, &GuidePage::progressChanged, this, &GuideRoom::progressChanged);
    m_guide->showStatus(m_last.now());
}

void GuideRoom::resume()
{
    if (m_progress.open && m_guide == nullptr) {
        showGuide();
    }
}

void GuideRoom::showGuide()
{
    if (m_guide == nullptr) {
        makeGuide();
    }
    setCurrentWidget(m_guide);
    m_guide->setOpen(true);
    m_guide->focusStep();
}

void GuideRoom::showStep(GuideStep step)
{
    showGuide();
    m_guide->open(step);
}

void GuideRoom::showPanels()
{
    setCurrentWidget(&m_panels);
    if (m_guide != nullptr) {
        m_guide->setOpen(false);
    }
}

void GuideRoom::toggle()
{
    showsGuide() ? showPanels() : showGuide();
}

bool GuideRoom::showsGuide() const
{
    return currentWidget() != &m_panels;
}

}  // namespace boresight::ui

#include "moc_guide_room.cpp"
