// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/places_bar.h"

#include "core/pointing/pointing_model.h"
#include "ui/jog/go_to_bar.h"
#include "ui/jog/nearest_offer.h"
#include "ui/jog/preset_bar.h"
#include "ui/kit/axes.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"
#include "ui/look/paint.h"

#include <QPainter>
#include <QVBoxLayout>

namespace boresight::ui {

PlacesBar::PlacesBar(ProfileDraft& draft, RequestDesk& desk, const QStringList& recentGoTos, QWidget* parent)
    : QWidget(parent),
      m_notice(new ValueLabel(tr("Refused direction"), fonts::label(), {}, this)),
      m_offer(new NearestOffer(desk, *m_notice, this)),
      m_goTo(new GoToBar(desk, *m_notice, *m_offer, recentGoTos, this)),
      m_park(new CommandButton(tr("Park"), {}, desk, *m_notice, this)),
      m_more(makePushButton({.text = tr("Presets ▾"),
                             .name = tr("Presets, home, horizon, unwrap"),
                             .help = tr("Show or hide the presets, Home, Horizon and Unwrap")},
                            this)),
      m_rare(new QWidget(this)),
      m_presets(new PresetBar(draft, desk, *m_notice, this)),
      m_home(new CommandButton(tr("Home"), tr("Go to azimuth 0° and the lowest elevation"), desk, *m_notice, this)),
      m_horizon(new CommandButton(tr("Horizon"),
                                  tr("Go to elevation 0°, or to the lowest permitted elevation. If an azimuth is "
                                     "entered, go there. If not, the azimuth stays."),
                                  desk, *m_notice, this)),
      m_unwrap(new CommandButton(
          tr("Unwrap"),
          tr("Go back by whole turns. The mount then points to the same direction with the cable least wound."), desk,
          *m_notice, this))
{
    build();
    connect(m_goTo, &GoToBar::recentChanged, this, &PlacesBar::recentGoTosChanged);
    connect(m_horizon, &QPushButton::clicked, this, [this] { m_horizon->ask(request::Horizon{m_goTo->azimuth()}); });
    connect(m_home, &QPushButton::clicked, this, [this] { m_home->ask(request::Home{}); });
    connect(m_unwrap, &QPushButton::clicked, this, [this] { m_unwrap->ask(request::Unwind{}); });
    connect(m_park, &QPushButton::clicked, this, &PlacesBar::parkOrUnpark);
    connect(m_park, &CommandButton::refused, this, &PlacesBar::offerBesidePark);
    connect(m_park, &CommandButton::accepted, m_offer, &NearestOffer::drop);
    connect(m_more, &QPushButton::toggled, m_rare, &QWidget::setVisible);
}

void PlacesBar::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, 2, kGrid, 2);
    column->setSpacing(kGrid / 2);
    auto* const refusal = new QHBoxLayout;
    column->addLayout(refusal);
    refusal->addWidget(m_notice, 1);
    refusal->addWidget(m_offer);
    fillRare();
    column->addWidget(m_rare);
    column->addWidget(makeFirstRow());
    m_notice->setWrapping(true);
    m_notice->setCollapsing(true);
}

QWidget* PlacesBar::makeFirstRow()
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
    return box;
}

void PlacesBar::fillRare()
{
    auto* const column = new QVBoxLayout(m_rare);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid / 2);
    column->addWidget(m_presets);
    // a separate row, so that the column of the panels does not become wider at 1024 px
    auto* const row = new QHBoxLayout;
    column->addLayout(row);
    row->setSpacing(kGrid / 2);
    row->addStretch(1);
    for (CommandButton* const button : {m_home, m_horizon, m_unwrap}) {
        setEmphasis(*button, Emphasis::Quiet);
        row->addWidget(button);
    }
    m_rare->hide();
}

void PlacesBar::showStatus(const StationStatus& status)
{
    m_status = status;
    m_presets->showStatus(status);
    const QString reason = status.permissions.reason(Action::Point);
    m_goTo->setBlocked(reason);
    m_goTo->setPresent(status.actual);
    m_horizon->setBlocked(status.permissions.reason(Action::Horizon));
    m_home->setCommand(tr("Home"), hasXY(status) ? tr("Go to X 0° and Y 0°: the beam points to the zenith")
                                                 : tr("Go to azimuth 0° and the lowest elevation"));
    m_home->setBlocked(status.permissions.reason(Action::Home));
    m_unwrap->setBlocked(status.permissions.reason(Action::Unwind));
    showPark();
}

bool PlacesBar::leave()
{
    if (!m_more->isChecked() || !m_more->hasFocus()) {
        return false;  // after Go or a preset the first Esc stops
    }
    m_more->setChecked(false);
    return true;
}

void PlacesBar::showPark()
{
    if (m_status.state == StationState::Parked) {
        m_park->setCommand(tr("Unpark"), tr("Leave PARKED and hold this position. Nothing moves."));
        m_park->setBlocked(m_status.permissions.reason(Action::Hold));
    } else {
        m_park->setCommand(tr("Park"), tr("Go to the park position %1 (Ctrl+P)").arg(axisText(m_status.profile->park)));
        m_park->setBlocked(m_status.permissions.reason(Action::Park));
    }
}

void PlacesBar::focusGoTo()
{
    m_goTo->focusFields();
}

void PlacesBar::parkOrUnpark()
{
    m_status.state == StationState::Parked ? m_park->ask(request::Hold{}) : m_park->ask(request::Park{});
}

// The park position may have become forbidden by a horizon or keep-out that was added later.
void PlacesBar::offerBesidePark()
{
    if (m_status.state != StationState::Parked) {
        m_offer->offerFor(pointing::PointingModel(termsOf(m_status)).toSky(m_status.profile->park));
    }
}

void PlacesBar::park()
{
    const QString obstacle = m_status.permissions.reason(Action::Park);
    const QString reason =
        obstacle.isEmpty() && m_status.state == StationState::Parked ? tr("The mount is already parked.") : obstacle;
    if (reason.isEmpty()) {
        m_park->ask(request::Park{});
    } else {
        m_notice->setValue(tr("Park: %1").arg(reason), Tone::Warning, Symbol::Warning);
        offerBesidePark();
    }
}

void PlacesBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintCard(painter, rect());
}

}  // namespace boresight::ui

#include "moc_places_bar.cpp"
