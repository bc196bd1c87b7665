// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_page.h"

#include "core/profile/commissioning.h"
#include "ui/drives/protection_panel.h"
#include "ui/guide/guide_client.h"
#include "ui/guide/guide_connect.h"
#include "ui/guide/guide_directions.h"
#include "ui/guide/guide_north.h"
#include "ui/guide/guide_ready.h"
#include "ui/guide/guide_site.h"
#include "ui/guide/guide_travel.h"
#include "ui/guide/guide_zero.h"
#include "ui/guide/step_button.h"
#include "ui/kit/axes.h"
#include "ui/kit/command_button.h"
#include "ui/kit/focus_scroll.h"
#include "ui/kit/page_room.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"

#include <QButtonGroup>
#include <QScrollArea>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

namespace {

auto placeOf(GuideStep step)
{
    return std::ranges::find(kGuideSteps, step);
}

// The mount that the progress belongs to. The simulated mount, the real mount and a rotator of another kind share a
// profile, but the progress of one is not valid for another.
QString mountOf(const StationStatus& status)
{
    QString mount = QString::fromStdString(status.profile->mount.name);
    if (profile::kindOf(status.profile->azimuth.driver).countsItself ||
        profile::kindOf(status.profile->elevation.driver).countsItself) {
        mount += QStringLiteral(" (rotator)");
    }
    return status.simulated ? mount + QStringLiteral(" (simulated)") : mount;
}

// True for steps whose page moves the mount by hand.
bool moves(GuideStep step)
{
    return step == GuideStep::Directions || step == GuideStep::Travel || step == GuideStep::Level ||
           step == GuideStep::North;
}

}  // namespace

GuidePage::GuidePage(ProfileDraft& draft, RequestDesk& desk, HostDesk& host, const GuideProgress& progress,
                     QWidget* parent)
    : QWidget(parent),
      m_change(draft, desk),
      m_progress(progress),
      m_pages(new QStackedWidget(this)),
      m_title(new ValueLabel(tr("Step of the guide"), fonts::text(), {}, this)),
      m_hint(new ValueLabel(tr("What is in the way"), fonts::label(), {}, this))
{
    setAccessibleName(tr("Commissioning guide"));
    // The Tab key follows the order of creation.
    makeSteps();
    makePages(desk, host);
    m_back = makeButton(tr("Back"), tr("To the previous step (Alt+Left)"), &GuidePage::back);
    m_next = makeButton(tr("Next"), {}, &GuidePage::next);
    m_confirm = makeButton(tr("Confirm"), {}, &GuidePage::confirm);
    m_finish = makeButton(tr("Finish later"), tr("Show the panels. F3 returns to this step."), &GuidePage::finishLater);
    build();
    const auto addKey = [this](const QKeySequence& key, void (GuidePage::*act)()) {
        auto* const shortcut = new QShortcut(key, this);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        shortcut->setAutoRepeat(false);
        connect(shortcut, &QShortcut::activated, this, act);
    };
    addKey(Qt::ALT | Qt::Key_Left, &GuidePage::back);
    addKey(Qt::ALT | Qt::Key_Right, &GuidePage::next);
    showPage();
}

void GuidePage::makePages(RequestDesk& desk, HostDesk& host)
{
    auto* const connectPage = new GuideConnect(m_change, desk, host, m_pages);
    auto* const protection = new ProtectionPanel(desk, m_pages);
    protection->hideSwitches();
    auto* const directions = new GuideDirections(m_change, desk, m_pages);
    auto* const travel = new GuideTravel(m_change, desk, m_pages);
    auto* const level = new GuideZero(m_change, desk, m_pages);
    auto* const north = new GuideNorth(m_change, desk, m_pages);
    auto* const site = new GuideSite(m_change, desk, host, m_pages);
    auto* const client = new GuideClient(m_pages);
    auto* const ready = new GuideReady(m_pages);
    const auto add = [this](GuideStep step, auto* page) {
        m_pages->addWidget(page);
        m_show[step] = [page](const StationStatus& status) { page->showStatus(status); };
    };
    add(GuideStep::Connect, connectPage);
    add(GuideStep::Protection, protection);
    add(GuideStep::Directions, directions);
    add(GuideStep::Travel, travel);
    add(GuideStep::Level, level);
    add(GuideStep::North, north);
    add(GuideStep::Site, site);
    add(GuideStep::Client, client);
    m_pages->addWidget(ready);
    m_show[GuideStep::Ready] = [this, ready](const StationStatus& status) { ready->showStatus(status, m_progress); };
    connect(travel, &GuideTravel::done, this, [this] { take(GuideStep::Travel); });
    connect(level, &GuideZero::done, this, [this] { take(GuideStep::Level); });
    connect(north, &GuideNorth::panelWanted, this, &GuidePage::northWanted);
    connect(north, &GuideNorth::done, this, [this] { take(GuideStep::North); });
    connect(ready, &GuideReady::stepWanted, this, &GuidePage::go);
}

void GuidePage::makeSteps()
{
    for (const GuideStep step : kGuideSteps) {
        auto* const button = new StepButton(step, StepButton::Form::OfTheRow, this);
        m_buttons[step] = button;
        connect(button, &QAbstractButton::clicked, this, [this, step] { go(step); });
    }
}

void GuidePage::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* const steps = new QHBoxLayout;
    steps->setSpacing(2);
    auto* const group = new QButtonGroup(this);
    for (const GuideStep step : kGuideSteps) {
        steps->addWidget(m_buttons.at(step));
        group->addButton(m_buttons.at(step));
    }
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    for (QPushButton* const button : {m_back, m_next, m_confirm, m_finish}) {
        row->addWidget(button);
    }
    QSizePolicy stays = m_confirm->sizePolicy();  // the other buttons do not move when a step has nothing to confirm
    stays.setRetainSizeWhenHidden(true);
    m_confirm->setSizePolicy(stays);
    m_title->setStretching(true);
    m_hint->setStretching(true);
    m_hint->setLines(3);
    keepHeightOfShownPage(*m_pages);
    column->addLayout(steps);
    column->addWidget(m_title);
    column->addWidget(m_hint);                               // shown in place of the title
    column->addWidget(makeFocusScroll(*m_pages, *this), 1);  // the steps and the buttons stay in sight
    column->addLayout(row);
}

QPushButton* GuidePage::makeButton(const QString& text, const QString& help, void (GuidePage::*act)())
{
    QPushButton* const button = makePushButton({.text = text, .help = help}, this);
    connect(button, &QPushButton::clicked, this, act);
    return button;
}

void GuidePage::showStatus(const StationStatus& status)
{
    m_status = status;
    const QString mount = mountOf(status);
    if (mount != m_progress.mount) {  // the progress of another mount is not valid for this one
        const bool first = m_progress.mount.isEmpty();
        m_progress.mount = mount;
        if (!first) {
            m_progress.confirmed.clear();
            m_progress.skipped.clear();
            m_progress.current = GuideStep::Connect;
            showPage();
        }
        Q_EMIT progressChanged(m_progress);
    }
    if (!applies(m_progress.current, m_status)) {
        goOn();
    }
    if (isVisible()) {
        m_show.at(m_progress.current)(m_status);
        showSteps();
    }
}

void GuidePage::setOpen(bool on)
{
    if (on != m_progress.open) {
        m_progress.open = on;
        Q_EMIT progressChanged(m_progress);
    }
}

void GuidePage::focusStep()
{
    m_show.at(m_progress.current)(m_status);
    showSteps();
    m_buttons.at(m_progress.current)->setFocus();
}

void GuidePage::open(GuideStep step)
{
    go(step);
    focusStep();
}

void GuidePage::go(GuideStep step)
{
    m_progress.current = step;
    showPage();
    Q_EMIT progressChanged(m_progress);
}

void GuidePage::back()
{
    auto at = placeOf(m_progress.current);
    if (at == kGuideSteps.begin()) {
        return;
    }
    do {
        --at;
    } while (!applies(*at, m_status));  // ends, because the first step applies to every mount
    go(*at);
}

// A step is done only if the station shows it or the operator has confirmed it. Otherwise it counts as skipped.
void GuidePage::next()
{
    const GuideStep step = m_progress.current;
    if (step != GuideStep::Ready && reportOf(step, m_status, m_progress).state != StepState::Done) {
        m_progress.skipped.insert(step);
    }
    goOn();
}

void GuidePage::confirm()
{
    if (m_confirm->isEnabled()) {
        take(m_progress.current);
    }
}

void GuidePage::take(GuideStep step)
{
    m_progress.confirmed.insert(step);
    m_progress.skipped.erase(step);
    showSteps();
    Q_EMIT progressChanged(m_progress);
}

void GuidePage::goOn()
{
    const auto next = std::find_if(placeOf(m_progress.current) + 1, kGuideSteps.end(),
                                   [this](GuideStep step) { return applies(step, m_status); });
    if (next == kGuideSteps.end()) {
        finishLater();
    } else {
        go(*next);
    }
}

void GuidePage::finishLater()
{
    Q_EMIT progressChanged(m_progress);
    Q_EMIT closeWanted();
}

void GuidePage::showPage()
{
    const GuideStep step = m_progress.current;
    const auto at = placeOf(step);
    m_title->hide();  // hidden until the new page is laid out, because title and page together would widen the window
    m_hint->hide();
    const int index = static_cast<int>(at - kGuideSteps.begin());
    m_pages->setCurrentIndex(index);
    m_buttons.at(step)->setChecked(true);
    m_back->setEnabled(at != kGuideSteps.begin());
    m_next->setText(step == GuideStep::Ready ? tr("Finish") : tr("Next"));
    m_next->setAccessibleName(m_next->text());
    if (isVisible()) {
        m_show.at(step)(m_status);
    }
    showSteps();
}

void GuidePage::showSteps()
{
    for (const auto& [step, button] : m_buttons) {
        button->setNumber(numberOf(step, m_status));
        button->showReport(reportOf(step, m_status, m_progress));
        button->setVisible(applies(step, m_status));
    }
    showButtons(reportOf(m_progress.current, m_status, m_progress));
    showHint();
}

void GuidePage::showButtons(const StepReport& report)
{
    const GuideStep step = m_progress.current;
    const bool done = report.state == StepState::Done;
    m_title->setValue(tr("%1 (%2)").arg(title(step), word(report.state)));
    m_next->setToolTip(step == GuideStep::Ready ? tr("Leave the guide. F3 opens it again")
                       : done                   ? tr("This step is done. Go to the next one (Alt+Right)")
                              : tr("%1 Next marks this step as skipped (Alt+Right).").arg(report.why));
    const QString what = confirmation(step);
    m_confirm->setVisible(!what.isEmpty());
    m_confirm->setEnabled(!done && report.state != StepState::NeedsYou);
    m_confirm->setToolTip(done ? tr("This step is done") : report.state == StepState::NeedsYou ? report.why : what);
    m_confirm->setAccessibleName(tr("Confirm: %1").arg(what));
}

// The reason why the mount cannot move, and where to remove it.
void GuidePage::showHint()
{
    const GuideStep step = m_progress.current;
    // The page of this step needs the full height of the smallest window, and shows its own errors.
    const bool full = step == GuideStep::Protection;
    QString hint;
    if (const auto axis = askingAxis(m_status); axis && !full) {
        hint = (*axis == Axis::Azimuth
                    ? tr("The cable wrap of the %1 is unknown. Press Ctrl+9 to enter it. F3 returns here")
                    : tr("The position of the %1 is unknown. Press Ctrl+9 to enter it. F3 returns here"))
                   .arg(name(*axis));
    } else if (moves(step) && !drivesOf(m_status).armingObstacle.isEmpty() &&
               drivesOf(m_status).driveCheck == DriveCheckState::Done) {
        hint = tr("Nothing may move before step %1 (%2) is done: %3")
                   .arg(numberOf(GuideStep::Protection, m_status))
                   .arg(name(GuideStep::Protection), drivesOf(m_status).armingObstacle);
    } else if (moves(step)) {
        hint = m_status.permissions.reason(Action::Move);
    }
    m_hint->setValue(hint, Tone::Warning, hint.isEmpty() ? Symbol::None : Symbol::Warning);
    m_hint->setVisible(!hint.isEmpty());
    m_title->setVisible(hint.isEmpty() && !full);
}

}  // namespace boresight::ui

#include "moc_guide_page.cpp"
