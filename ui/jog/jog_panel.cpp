// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/jog_panel.h"

#include "ui/jog/go_to_bar.h"
#include "ui/jog/jog_choices.h"
#include "ui/jog/preset_bar.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"
#include "ui/look/paint.h"

#include <QGridLayout>

namespace boresight::ui {

JogPanel::JogPanel(const Clock& clock, ProfileDraft& draft, RequestDesk& desk, const QStringList& recentGoTos,
                   QWidget* parent)
    : QWidget(parent),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_pad(new JogPad(clock, desk, *m_notice, this)),
      m_choices(new JogChoices(draft, *m_pad, this)),
      m_goTo(new GoToBar(desk, *m_notice, recentGoTos, this)),
      m_presets(new PresetBar(draft, desk, *m_notice, this)),
      m_horizon(new CommandButton(tr("Horizon"),
                                  tr("Go to elevation 0°, or the lowest permitted, at the entered azimuth. Without one "
                                     "the azimuth stays"),
                                  desk, *m_notice, this)),
      m_home(new CommandButton(tr("Home"), tr("Go to azimuth 0° and the lowest elevation"), desk, *m_notice, this)),
      m_park(new CommandButton(tr("Park"), {}, desk, *m_notice, this)),
      m_trim(new ValueLabel(tr("Trim"), fonts::label(), {}, this)),
      m_clearTrim(new CommandButton(tr("Clear trim"), {}, desk, *m_notice, this)),
      m_unwrap(new CommandButton(
          tr("Unwrap"),
          tr("Unwrap the cable: go back by whole turns to the same direction where the cable is least wound"), desk,
          *m_notice, this)),
      m_more(makePushButton({.text = tr("Presets ▾"),
                             .name = tr("Presets, home, horizon, unwrap"),
                             .help = tr("Show or hide the presets, Home, Horizon and Unwrap")},
                            this)),
      m_rare(new QWidget(this))
{
    build();
    connect(m_goTo, &GoToBar::recentChanged, this, &JogPanel::recentGoTosChanged);
    connect(m_horizon, &QPushButton::clicked, this, [this] { m_horizon->ask(request::Horizon{m_goTo->azimuth()}); });
    connect(m_home, &QPushButton::clicked, this, [this] { m_home->ask(request::Home{}); });
    connect(m_unwrap, &QPushButton::clicked, this, [this] { m_unwrap->ask(request::Unwind{}); });
    connect(m_park, &QPushButton::clicked, this, &JogPanel::parkOrUnpark);
    connect(m_clearTrim, &QPushButton::clicked, this, [this] { m_clearTrim->ask(request::ClearTrim{}); });
    connect(m_pad, &JogPad::interrupted, this, [this] { m_pilot.letGo(); });
}

void JogPanel::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(kGrid, kGrid / 2, kGrid, kGrid / 2);
    grid->setHorizontalSpacing(2 * kGrid);
    grid->setVerticalSpacing(kGrid / 2);
    grid->addWidget(makeGroupCaption(tr("Move by hand"), this), 0, 0, 1, 2);
    grid->addWidget(m_pad, 1, 0);
    grid->addWidget(makeChoices(), 1, 1, Qt::AlignTop);
    grid->addWidget(m_notice, 2, 0, 1, 2);
    grid->addWidget(makePlaces(), 3, 0, 1, 2);
    grid->addWidget(m_rare, 4, 0, 1, 2);
    fillRare();
    grid->setRowStretch(1, 1);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    m_notice->setStretching(true);
    m_notice->setLines(2);
}

QWidget* JogPanel::makeChoices()
{
    auto* const box = new QWidget(this);
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kGrid / 2);
    grid->addWidget(m_choices, 0, 0, 1, 2);
    grid->addWidget(m_trim, 1, 0);
    grid->addWidget(m_clearTrim, 1, 1);
    m_trim->setStretching(true);
    m_trim->setLines(2);
    return box;
}

QWidget* JogPanel::makePlaces()
{
    auto* const box = new QWidget(this);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGrid / 2);
    row->addWidget(m_goTo, 1);
    row->addWidget(m_park);
    row->addWidget(m_more);
    setEmphasis(*m_more, Emphasis::Quiet);
    m_more->setCheckable(true);
    connect(m_more, &QPushButton::toggled, this, [this](bool on) {
        m_trim->setVisible(!on);  // their room, at 1024×700
        m_clearTrim->setVisible(!on);
        m_rare->setVisible(on);
    });
    return box;
}

// What is needed once a night at most is out of the way until it is asked for.
void JogPanel::fillRare()
{
    auto* const row = new QHBoxLayout(m_rare);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGrid / 2);
    row->addWidget(m_presets, 1);
    for (CommandButton* const button : {m_home, m_horizon, m_unwrap}) {
        setEmphasis(*button, Emphasis::Quiet);
        row->addWidget(button);
    }
    m_rare->hide();
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
    m_unwrap->setBlocked(status.permissions.reason(Action::Unwind));
    showPark();
    showTrim();
}

void JogPanel::showPark()
{
    if (m_status.state == StationState::Parked) {
        m_park->setCommand(tr("Unpark"), tr("Leave PARKED and hold this position. Nothing moves."));
        m_park->setBlocked(m_status.permissions.reason(Action::Hold));
    } else {
        m_park->setCommand(tr("Park"), tr("Go to the park position %1 (Ctrl+P)").arg(axisText(m_status.profile->park)));
        m_park->setBlocked(m_status.permissions.reason(Action::Park));
    }
}

void JogPanel::showTrim()
{
    const SkyPointing trim = m_status.trim.value_or(SkyPointing{});
    const QString text = tr("Trim: AZ %1 EL %2").arg(signedAngleText(trim.azimuth), signedAngleText(trim.elevation));
    m_trim->setValue(m_status.trim ? text : tr("No trim"), m_status.trim ? Tone::Normal : Tone::Secondary);
    m_clearTrim->setBlocked(m_status.permissions.reason(Action::ClearTrim));
    m_clearTrim->setCommand(tr("Clear trim"), tr("%1. Your steps are added to the targets of the clients.").arg(text));
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
        obstacle.isEmpty() && m_status.state == StationState::Parked ? tr("The mount is already parked.") : obstacle;
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

// Only where the operator sees the effect: in front of this panel, in the active window.
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
