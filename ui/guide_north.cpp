// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide_north.h"

#include "core/pointing/pointing_model.h"
#include "core/profile/commissioning.h"
#include "ui/axes.h"
#include "ui/command_button.h"
#include "ui/format.h"
#include "ui/guide_fields.h"
#include "ui/hold_buttons.h"
#include "ui/jog_button.h"
#include "ui/value_label.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>

namespace boresight::ui {

namespace {
constexpr Angle kNearZenith = 5_deg;  // so near to it an azimuth says little
}  // namespace

GuideNorth::GuideNorth(ProfileChange& change, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_change(change),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_explanation(new ValueLabel(tr("What to do"), fonts::label(), {}, this)),
      m_pointing(new ValueLabel(tr("Where the antenna points now"), fonts::text(), {}, this)),
      m_effect(new ValueLabel(tr("What the change does"), fonts::label(), {}, this)),
      m_truth(makeField({.name = tr("True azimuth of the antenna"),
                         .help = tr("The direction the antenna points to, from true north"),
                         .min = -360.0,
                         .max = 360.0,
                         .unit = QStringLiteral("°")},
                        this)),
      m_hold(new HoldButtons(desk, *m_notice, tr("Move"), {}, this)),
      m_set(new CommandButton(tr("Set north"), tr("Sets the azimuth offset of the pointing model; nothing moves"), desk,
                              *m_notice, this)),
      m_panel(new QPushButton(tr("Sensor, Sun, Moon (Ctrl+9)"), this))
{
    m_explanation->setValue(
        tr("Point the antenna at a landmark whose bearing is known, and type the bearing. Or ask the sensor, the Sun "
           "or the Moon. Without any press Skip: north can wait, everything else works."));
    const auto add = [this](JogDirection direction, const QString& text) {
        m_hold->addButton(direction, text, tr("Moves the %1 slowly while held").arg(name(Axis::Azimuth)));
    };
    add(JogDirection::Left, tr("AZ ↺ hold"));
    add(JogDirection::Right, tr("AZ ↻ hold"));
    m_hold->setKeyHeld(true);
    build();
    connect(m_truth, &QDoubleSpinBox::valueChanged, this, &GuideNorth::showEffect);
    connect(m_set, &QPushButton::clicked, this, [this] { m_change.ask(*m_set, edit()); });
    connect(m_set, &CommandButton::accepted, this, &GuideNorth::done);
    connect(m_panel, &QPushButton::clicked, this, &GuideNorth::panelWanted);
}

void GuideNorth::build()
{
    for (ValueLabel* const label : {m_explanation, m_pointing, m_effect, m_notice}) {
        label->setStretching(true);
    }
    m_explanation->setLines(3);
    m_effect->setLines(3);
    m_notice->setCollapsing(true);
    m_panel->setFont(fonts::label());
    m_panel->setAutoDefault(false);
    m_panel->setMinimumHeight(kTouchSize);
    m_panel->setAccessibleName(m_panel->text());
    m_panel->setToolTip(tr("To the panel North, which finds it by them; F3 comes back"));
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(6);
    auto* const caption = makeCaption(tr("It really points to"), this);
    caption->setBuddy(m_truth);
    grid->addWidget(m_explanation, 0, 0, 1, 3);
    grid->addWidget(m_pointing, 1, 0, 1, 2);
    grid->addWidget(m_hold, 1, 2);
    grid->addWidget(caption, 2, 0);
    grid->addWidget(m_truth, 2, 1);
    grid->addWidget(m_set, 2, 2);
    grid->addWidget(m_effect, 3, 0, 1, 3);
    grid->addWidget(m_panel, 4, 0, 1, 3, Qt::AlignLeft);
    grid->addWidget(m_notice, 6, 0, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(5, 1);
}

void GuideNorth::showStatus(const StationStatus& status)
{
    m_status = status;
    m_hold->setRate(status.profile->jog.slow);
    m_hold->showStatus(status);
    showEffect();
}

AxisPosition GuideNorth::axes() const
{
    return {.azimuth = m_status.azimuth.actual.value_or(Angle{}),
            .elevation = m_status.elevation.actual.value_or(Angle{})};
}

QString GuideNorth::whyNot() const
{
    for (const Axis axis : kAxes) {
        const AxisStatus& now = axisOf(m_status, axis);
        if (!now.actual || freshness(now.age) != Freshness::Live) {
            return tr("the drive does not say where the %1 is").arg(name(axis));
        }
        if (!isTurnKnown(m_status, axis)) {
            return tr("which turn the %1 is on is not known yet").arg(name(axis));
        }
        if (now.state == AxisState::Moving) {
            return tr("the mount moves: stop it first");
        }
    }
    if (abs(axes().elevation - 90_deg) < kNearZenith) {
        return tr("the antenna looks up: lower it first");
    }
    return m_change.whyNot(m_status, edit());
}

ProfileChange::Edit GuideNorth::edit() const
{
    return [axes = axes(), truth = Angle::fromDegrees(m_truth->value())](profile::Profile& profile) {
        profile::setNorth(profile, axes, truth);
    };
}

void GuideNorth::showEffect()
{
    const profile::Profile& now = m_change.applied();
    const bool known =
        m_status.actual && areTurnsKnown(m_status) && freshness(m_status.azimuth.age) != Freshness::NoData;
    const SkyPointing beam = pointing::upright(pointing::PointingModel(now.pointing).toSky(axes()));
    m_pointing->setValue(tr("It says it points to %1").arg(known ? angleText(beam.azimuth) : noValue()));
    m_set->setBlocked(whyNot());
    if (!known) {
        m_effect->setValue({});
        return;
    }
    profile::Profile then = now;
    edit()(then);
    m_effect->setValue(tr("Azimuth offset %1 → %2, in force at once. Nothing moves; travel, cable and park keep their "
                          "numbers, horizon "
                          "and keep-outs are true directions and stay.")
                           .arg(angleText(now.pointing.azimuthOffset), angleText(then.pointing.azimuthOffset)),
                       Tone::Secondary);
}

}  // namespace boresight::ui
