// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/jog_panel.h"

#include "ui/jog/go_to_bar.h"
#include "ui/jog/jog_choices.h"
#include "ui/jog/preset_bar.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <QGridLayout>

namespace boresight::ui {

JogPanel::JogPanel(const Clock& clock, ProfileDraft& draft, RequestDesk& desk, const QStringList& recentGoTos,
                   QWidget* parent)
    : QWidget(parent),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_pad(new JogPad(clock, desk, *m_notice, this)),
      m_choices(new JogChoices(*m_pad, this)),
      m_goTo(new GoToBar(desk, *m_notice, recentGoTos, this)),
      m_presets(new PresetBar(draft, desk, *m_notice, this)),
      m_horizon(new CommandButton(tr("Horizon"),
                                  tr("Elevation 0°, or the lowest permitted, at the azimuth that is "
                                     "entered. Without one the azimuth stays"),
                                  desk, *m_notice, this)),
      m_home(new CommandButton(tr("Home"), tr("Go to azimuth 0° and the lowest elevation"), desk, *m_notice, this)),
      m_park(new CommandButton(tr("Park"), {}, desk, *m_notice, this)),
      m_clearTrim(new CommandButton(tr("Clear trim"), {}, desk, *m_notice, this)),
      m_unwind(new CommandButton(
          tr("Unwind"), tr("Turn back by whole turns to the same direction, where the azimuth cable is wound least"),
          desk, *m_notice, this))
{
    build();
    connect(m_goTo, &GoToBar::recentChanged, this, &JogPanel::recentGoTosChanged);
    connect(m_horizon, &QPushButton::clicked, this, [this] { m_horizon->ask(request::Horizon{m_goTo->azimuth()}); });
    connect(m_home, &QPushButton::clicked, this, [this] { m_home->ask(request::Home{}); });
    connect(m_unwind, &QPushButton::clicked, this, [this] { m_unwind->ask(request::Unwind{}); });
    connect(m_park, &QPushButton::clicked, this, &JogPanel::parkOrUnpark);
    connect(m_clearTrim, &QPushButton::clicked, this, [this] { m_clearTrim->ask(request::ClearTrim{}); });
    connect(m_pad, &JogPad::interrupted, this, [this] { m_pilot.letGo(); });
}

void JogPanel::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(6, 6, 6, 6);
    grid->setSpacing(6);
    grid->addWidget(m_pad, 0, 0);
    grid->addWidget(m_choices, 0, 1);
    grid->addWidget(makePlaces(), 1, 0, 1, 2);
    grid->addWidget(makeLowest(), 2, 0, 1, 2);
    grid->setRowStretch(0, 1);
    grid->setColumnStretch(0, 1);
}

QWidget* JogPanel::makePlaces()
{
    auto* const box = new QWidget(this);
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    grid->addWidget(m_goTo, 0, 0);
    grid->addWidget(m_horizon, 0, 1);
    grid->addWidget(m_presets, 1, 0);
    grid->addWidget(m_park, 1, 1);
    grid->setColumnStretch(0, 1);
    return box;
}

QWidget* JogPanel::makeLowest()
{
    auto* const box = new QWidget(this);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(m_notice, 1);
    row->addWidget(m_clearTrim);
    row->addWidget(m_unwind);
    row->addWidget(m_home);
    m_notice->setStretching(true);
    m_notice->setLines(2);
    return box;
}

void JogPanel::showStatus(const StationStatus& status)
{
    m_status = status;
    m_choices->showStatus(status);
    m_pad->showStatus(status);
    m_presets->showStatus(status);
    const QString reason = status.permissions.reason(Action::Point);
    m_goTo->setBlocked(reason);
    m_horizon->setBlocked(reason);
    m_home->setBlocked(status.permissions.reason(Action::Home));
    m_unwind->setBlocked(status.permissions.reason(Action::Unwind));
    showPark();
    showTrim();
}

void JogPanel::showPark()
{
    if (m_status.state == StationState::Parked) {
        m_park->setCommand(tr("Unpark"), tr("Leave PARKED and hold this position; nothing moves"));
        m_park->setBlocked(m_status.permissions.reason(Action::Hold));
    } else {
        m_park->setCommand(tr("Park"), tr("Go to the park position %1 (Ctrl+P)").arg(axisText(m_status.profile->park)));
        m_park->setBlocked(m_status.permissions.reason(Action::Park));
    }
}

void JogPanel::showTrim()
{
    const SkyPointing trim = m_status.trim.value_or(SkyPointing{});
    m_clearTrim->setBlocked(m_status.trim ? QString() : tr("no target is trimmed"));
    m_clearTrim->setCommand(tr("Clear trim"),
                            tr("Trim az %1 el %2: the operator's steps, added to the targets of clients")
                                .arg(signedAngleText(trim.azimuth), signedAngleText(trim.elevation)));
}

void JogPanel::focusGoTo()
{
    m_goTo->focusFields();
}

void JogPanel::parkOrUnpark()
{
    m_status.state == StationState::Parked ? m_park->ask(request::Hold{}) : m_park->ask(request::Park{});
}

void JogPanel::park()
{
    const QString obstacle = m_status.permissions.reason(Action::Park);
    const QString reason =
        obstacle.isEmpty() && m_status.state == StationState::Parked ? tr("the mount is parked already") : obstacle;
    if (reason.isEmpty()) {
        m_park->ask(request::Park{});
    } else {
        m_notice->setValue(tr("Park: %1").arg(reason), Tone::Warning, Symbol::Warning);
    }
}

void JogPanel::hold()
{
    m_pad->hold();
}

void JogPanel::beat()
{
    m_pad->disarmWhenUnused();
}

// Only where the operator sees what it does: in front of this panel, in the active window.
void JogPanel::takeGamepad(const GamepadSample& sample)
{
    const bool permitted = isVisible() && window()->isActiveWindow() && m_status.permissions.allows(Action::Move);
    const Steering steering = m_pilot.take(sample, permitted);
    m_pad->steer(steering.azimuth, steering.elevation);
    if (m_pilot.takeStop()) {
        Q_EMIT stopPressed();
    }
}

void JogPanel::showGamepad(const QString& name)
{
    m_pilot.gone();
    m_pad->steer(0.0, 0.0);
    m_pad->setGamepad(name);
}

}  // namespace boresight::ui

#include "moc_jog_panel.cpp"
