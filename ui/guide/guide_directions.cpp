// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_directions.h"

#include "core/profile/commissioning.h"
#include "ui/guide/direction_arrow.h"
#include "ui/hold/hold_buttons.h"
#include "ui/hold/jog_button.h"
#include "ui/kit/axes.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <QGridLayout>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr AngularRate kStill = 0.05_deg_s;

Turning turningOf(const AxisStatus& axis)
{
    const AngularRate rate = axis.rate.value_or(AngularRate{});
    if (axis.state != AxisState::Moving || abs(rate) < kStill) {
        return Turning::Rests;
    }
    return rate > AngularRate{} ? Turning::Grows : Turning::Shrinks;
}

bool sameMotor(const profile::AxisSettings& one, const profile::AxisSettings& other)
{
    return one.id == other.id && one.geometry.sign == other.geometry.sign;
}

// The buttons move the axes. On an X/Y mount these are X and Y.
QString hintOf(Axis axis, const pointing::MountGeometry& geometry)
{
    if (geometry.kind == pointing::Geometry::XY) {
        return axis == Axis::Azimuth ? GuideDirections::tr("X: AZ ↻ must lean the antenna to azimuth %1")
                                           .arg(azimuthText((geometry.xAxis + 90_deg).wrapped360(), 0))
                                     : GuideDirections::tr("Y: EL ↑ must lean the antenna to azimuth %1")
                                           .arg(azimuthText(geometry.xAxis.wrapped360(), 0));
    }
    return axis == Axis::Azimuth ? GuideDirections::tr("↻ must turn the antenna clockwise, seen from above")
                                 : GuideDirections::tr("↑ must raise the antenna");
}

}  // namespace

GuideDirections::GuideDirections(ProfileChange& change, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_change(change),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_swap(new CommandButton(tr("The other axis moved:\nswap the motors"),
                               tr("Azimuth and elevation exchange their motors. Boresight connects again."), desk,
                               *m_notice, this)),
      m_confirm(new CommandButton(tr("Both directions are right"), {}, desk, *m_notice, this)),
      m_atTheBox(new ValueLabel(tr("If a direction is wrong"), fonts::label(), {}, this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* const grid = new QGridLayout;
    grid->setSpacing(6);
    for (const Axis axis : kAxes) {
        addAxis(*grid, axis, desk);
    }
    grid->setColumnStretch(1, 1);
    grid->setHorizontalSpacing(10);
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    for (CommandButton* const button : {m_swap, m_confirm}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button);
    }
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    m_atTheBox->setStretching(true);
    m_atTheBox->setCollapsing(true);
    m_atTheBox->setLines(2);
    column->addLayout(grid);
    column->addWidget(m_atTheBox);
    column->addStretch(1);
    column->addLayout(row);
    column->addWidget(m_notice);
    connect(m_swap, &QPushButton::clicked, this, [this] { m_change.ask(*m_swap, &profile::swapMotors); });
    connect(m_confirm, &QPushButton::clicked, this, [this] {
        m_change.ask(*m_confirm, [](profile::Profile& p) { p.mount.directions = profile::Directions::Confirmed; });
    });
}

void GuideDirections::addAxis(QGridLayout& grid, Axis axis, RequestDesk& desk)
{
    const bool azimuth = axis == Axis::Azimuth;
    Row& row = m_rows[axisIndex(axis)];
    row.arrow = new DirectionArrow(axis, this);
    row.hold = new HoldButtons(desk, *m_notice, tr("Test move"), this);
    const QString rate = rateText(kRate);
    if (azimuth) {
        row.hold->addButton(JogDirection::Left, tr("AZ ↺\n(hold)"),
                            tr("Turn azimuth counter-clockwise at %1 while held").arg(rate));
        row.hold->addButton(JogDirection::Right, tr("AZ ↻\n(hold)"),
                            tr("Turn azimuth clockwise at %1 while held").arg(rate));
    } else {
        row.hold->addButton(JogDirection::Down, tr("EL ↓\n(hold)"), tr("Lower elevation at %1 while held").arg(rate));
        row.hold->addButton(JogDirection::Up, tr("EL ↑\n(hold)"), tr("Raise elevation at %1 while held").arg(rate));
    }
    row.hold->setKeyHeld(true);
    row.moved = new ValueLabel(tr("Test move of the %1").arg(name(axis)), fonts::label(), {}, this);
    row.moved->setStretching(true);
    row.reverse =
        new CommandButton(azimuth ? tr("AZ moved the wrong way") : tr("EL moved the wrong way"),
                          tr("The motor of the %1 counts the other way. Boresight connects again.").arg(name(axis)),
                          desk, *m_notice, this);
    const int line = 2 * static_cast<int>(axisIndex(axis));
    grid.addWidget(row.arrow, line, 0, 2, 1);
    grid.addWidget(row.moved, line, 1, 1, 2);
    grid.addWidget(row.hold, line + 1, 1);
    grid.addWidget(row.reverse, line + 1, 2);
    connect(row.reverse, &QPushButton::clicked, this, [this, axis] { reverse(axis); });
}

void GuideDirections::showStatus(const StationStatus& status)
{
    for (const Axis axis : kAxes) {
        if (!sameMotor(status.profile->axis(axis), m_status.profile->axis(axis))) {
            m_rows[axisIndex(axis)].origin.reset();  // the observed motion was that of another motor or direction
        }
    }
    m_status = status;
    for (const Axis axis : kAxes) {
        follow(axis);
    }
    showButtons();
}

void GuideDirections::follow(Axis axis)
{
    Row& row = m_rows[axisIndex(axis)];
    const bool ownCount = profile::kindOf(m_status.profile->axis(axis).driver).countsItself;
    for (QWidget* const part : std::initializer_list<QWidget*>{row.arrow, row.hold, row.moved}) {
        part->setVisible(m_status.capabilities.has(axis));
    }
    row.reverse->setVisible(m_status.capabilities.has(axis) && !ownCount);
    const AxisStatus& now = axisOf(m_status, axis);
    row.arrow->setTurning(turningOf(now));
    row.hold->setRate(std::min(kRate, m_status.profile->jog.unwind));
    row.hold->showStatus(m_status);
    const bool turnKnown = isTurnKnown(m_status, axis);
    if (!row.origin || turnKnown != row.turnKnown) {
        row.origin = now.actual;
        row.farthest = {};
        row.turnKnown = turnKnown;
    }
    const Angle moved = now.actual && row.origin ? *now.actual - *row.origin : Angle{};
    if (now.state == AxisState::Moving) {
        row.farthest = std::max(row.farthest, abs(moved));
    }
    const QString hint = hintOf(axis, m_status.profile->pointing.geometry);
    row.moved->setValue(row.farthest < kSeen ? hint : tr("%1. Now %2.").arg(hint, signedAngleText(moved, 1)),
                        row.farthest < kSeen ? Tone::Normal : Tone::Secondary);
}

void GuideDirections::showButtons()
{
    const bool both =
        m_status.drives && std::ranges::all_of(kAxes, [this](Axis axis) { return driveOf(m_status, axis).present; });
    const bool single = missingAxis(m_status).has_value();
    m_swap->setVisible(!single && m_status.drives);  // otherwise there is nothing to exchange
    const bool ownCount = std::ranges::any_of(
        kAxes, [this](Axis axis) { return profile::kindOf(m_status.profile->axis(axis).driver).countsItself; });
    m_atTheBox->setValue(ownCount ? tr("The box of the rotator decides the direction. If an axis moves the wrong way, "
                                       "reverse it at its motor or at the box.")
                                  : QString());
    m_swap->setBlocked(both ? m_change.whyNot(m_status, &profile::swapMotors)
                            : tr("only one axis has a motor that can be exchanged"));
    for (const Axis axis : kAxes) {
        const auto turned = [axis](profile::Profile& profile) { profile::reverse(profile, axis, std::nullopt); };
        m_rows[axisIndex(axis)].reverse->setBlocked(m_change.whyNot(m_status, turned));
    }
    const auto unseen = std::ranges::find_if(kAxes, [this](Axis axis) {
        return m_status.capabilities.has(axis) && m_rows[axisIndex(axis)].farthest < kSeen;
    });
    const bool confirmed = m_status.profile->mount.directions == profile::Directions::Confirmed;
    const auto confirm = [](profile::Profile& p) { p.mount.directions = profile::Directions::Confirmed; };
    m_confirm->setCommand(single ? tr("The direction is right") : tr("Both directions are right"),
                          tr("From now on the mount may move faster and farther"));
    m_confirm->setBlocked(confirmed               ? tr("it is confirmed already")
                          : unseen != kAxes.end() ? tr("move the %1 a little first, and look at it").arg(name(*unseen))
                                                  : m_change.whyNot(m_status, confirm));
}

void GuideDirections::reverse(Axis axis)
{
    const std::optional<Angle> reading =
        isTurnKnown(m_status, axis) ? axisOf(m_status, axis).actual : std::optional<Angle>();
    m_change.ask(*m_rows[axisIndex(axis)].reverse,
                 [axis, reading](profile::Profile& profile) { profile::reverse(profile, axis, reading); });
}

}  // namespace boresight::ui

#include "moc_guide_directions.cpp"
