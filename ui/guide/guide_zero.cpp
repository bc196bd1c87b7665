// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_zero.h"

#include "core/profile/commissioning.h"
#include "ui/guide/step_picture.h"
#include "ui/hold/hold_buttons.h"
#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/guide_fields.h"
#include "ui/kit/value_label.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>

namespace boresight::ui {

namespace {

constexpr Axis kAxis = Axis::Elevation;

QString travelText(const TravelRange& range)
{
    return angleText(range.min, 1) + QStringLiteral("…") + angleText(range.max, 1);
}

}  // namespace

GuideZero::GuideZero(ProfileChange& change, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_change(change),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_explanation(new ValueLabel(tr("What to do"), fonts::label(), {}, this)),
      m_reading(new ValueLabel(tr("The angle that the %1 reports now").arg(name(kAxis)), fonts::text(), {}, this)),
      m_effect(new ValueLabel(tr("What the change does"), fonts::label(), {}, this)),
      m_entry(new QWidget(this)),
      m_truth(nullptr),
      m_endsStay(new QCheckBox(tr("Keep cable and stops physically where they are"), this)),
      m_hold(new HoldButtons(desk, *m_notice, tr("Move"), this)),
      m_set(new CommandButton(tr("Set"), tr("Write the new zero into the profile and connect again. Nothing moves."),
                              desk, *m_notice, this))
{
    m_truth = makeField({.name = tr("True elevation of the antenna"),
                         .help = tr("By a spirit level on the antenna: 0° is level"),
                         .min = -90.0,
                         .max = 180.0,
                         .unit = QStringLiteral("°")},
                        m_entry);
    const QString help = tr("Moves the %1 slowly while held").arg(name(kAxis));
    m_hold->addAxis(kAxis, help, help);
    m_endsStay->setChecked(true);
    build();
    connect(m_truth, &QDoubleSpinBox::valueChanged, this, &GuideZero::showEffect);
    connect(m_endsStay, &QCheckBox::toggled, this, &GuideZero::showEffect);
    connect(m_set, &QPushButton::clicked, this, &GuideZero::set);
    connect(m_set, &CommandButton::accepted, this, &GuideZero::done);
}

void GuideZero::build()
{
    for (ValueLabel* const label : {m_explanation, m_reading, m_effect, m_notice}) {
        label->setStretching(true);
    }
    m_explanation->setLines(2);
    m_effect->setLines(3);
    m_notice->setCollapsing(true);
    m_endsStay->setFont(fonts::label());
    m_endsStay->setAccessibleName(m_endsStay->text());
    m_endsStay->setToolTip(tr("Off: the ends keep their angles, so they move to other places of the mount"));
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(6);
    auto* const top = new QHBoxLayout;
    top->addWidget(m_explanation, 1);
    top->addWidget(new StepPicture(StepPicture::Scene::Level, this));
    grid->addLayout(top, 0, 0, 1, 3);
    grid->addWidget(m_reading, 1, 0, 1, 2);
    grid->addWidget(m_hold, 1, 2);
    auto* const entry = new QHBoxLayout(m_entry);
    entry->setContentsMargins(0, 0, 0, 0);
    entry->addWidget(makeCaption(tr("True value"), *m_truth));
    entry->addWidget(m_truth, 1);
    grid->addWidget(m_entry, 2, 0, 1, 2);
    grid->addWidget(m_set, 2, 2);
    grid->addWidget(m_endsStay, 3, 0, 1, 3);
    grid->addWidget(m_effect, 4, 0, 1, 3);
    grid->addWidget(m_notice, 6, 0, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(5, 1);
}

void GuideZero::showStatus(const StationStatus& status)
{
    m_status = status;
    m_hold->setRate(status.profile->jog.slow);
    m_hold->showStatus(status);
    const bool ownCount = profile::kindOf(status.profile->axis(kAxis).driver).countsItself;
    m_entry->setVisible(!ownCount);
    m_set->setVisible(!ownCount);
    m_endsStay->setVisible(!ownCount);
    m_effect->setVisible(!ownCount);
    m_explanation->setValue(
        ownCount
            ? tr("Bring the antenna level, by a spirit level on it. The box of the rotator must show 0° then. If not, "
                 "calibrate the box.")
            : tr("Bring the antenna level, by a spirit level on it, and set 0° here. Or type what an inclinometer "
                 "shows."));
    showEffect();
}

Angle GuideZero::truth() const
{
    return Angle::fromDegrees(m_truth->value());
}

QString GuideZero::whyNot() const
{
    // The axis must stand still while the zero is set, even if the change itself would be possible in motion.
    const QString reason = m_status.permissions.reason(setAction(kAxis));
    return reason.isEmpty() ? m_change.whyNot(m_status, edit()) : reason;
}

ProfileChange::Edit GuideZero::edit() const
{
    const Angle reading = axisOf(m_status, kAxis).actual.value_or(Angle{});
    const auto ends = m_endsStay->isChecked() ? profile::Ends::StayOnTheMount : profile::Ends::KeepTheirNumbers;
    return [reading, truth = truth(), ends](profile::Profile& profile) {
        profile::setReading(profile, kAxis, reading, truth, ends);
    };
}

void GuideZero::showEffect()
{
    const AxisStatus& now = axisOf(m_status, kAxis);
    const bool known = now.actual && isTurnKnown(m_status, kAxis) && freshness(now.age) != Freshness::NoData;
    m_reading->setValue(tr("Shown %1").arg(known ? angleText(*now.actual) : noValue()));
    m_set->setBlocked(whyNot());
    if (!known) {
        m_effect->setValue({});
        return;
    }
    profile::Profile then = m_change.applied();
    edit()(then);
    const QString by = signedAngleText(truth() - *now.actual);
    const QString ends = tr("travel %1, now %2")
                             .arg(travelText(then.axis(kAxis).geometry.travel),
                                  travelText(m_change.applied().axis(kAxis).geometry.travel));
    const QString bounds = !m_status.drives          ? QString()
                           : m_endsStay->isChecked() ? tr("The drives' own bounds stay right.")
                                                     : tr("Then fix the limits of the drives (step Protect).");
    m_effect->setValue(tr("Every angle changes by %1: %2. %3").arg(by, ends, bounds), Tone::Secondary);
}

void GuideZero::set()
{
    m_change.ask(*m_set, edit());
}

}  // namespace boresight::ui

#include "moc_guide_zero.cpp"
