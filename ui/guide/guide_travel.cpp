// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_travel.h"

#include "core/profile/commissioning.h"
#include "ui/guide/step_picture.h"
#include "ui/hold/hold_buttons.h"
#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/guide_fields.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"
#include "ui/limits/limit_bar.h"

#include <QDoubleSpinBox>
#include <QGridLayout>

namespace boresight::ui {

GuideTravel::GuideTravel(ProfileChange& change, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_change(change),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_use(new CommandButton(tr("Use these ends"), {}, desk, *m_notice, this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* const explanation = new ValueLabel(tr("What the ends are"), fonts::label(), {}, this);
    explanation->setStretching(true);
    explanation->setLines(3);
    explanation->setValue(tr("Type the ends, or jog to each end and set it here. Whole turns count: 370° is not 10°."));
    auto* const top = new QHBoxLayout;
    top->addWidget(explanation, 1);
    top->addWidget(new StepPicture(StepPicture::Scene::Travel, this));
    top->addWidget(m_use);
    column->addLayout(top);
    for (const Axis axis : kAxes) {
        column->addWidget(makeAxis(axis, desk));
    }
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    column->addStretch(1);
    column->addWidget(m_notice);
    connect(m_use, &QPushButton::clicked, this, [this] { m_change.ask(*m_use, edit()); });
    connect(m_use, &CommandButton::accepted, this, &GuideTravel::done);
}

QWidget* GuideTravel::makeAxis(Axis axis, RequestDesk& desk)
{
    auto* const box = new QWidget(this);
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    Row& row = m_rows[axisIndex(axis)];
    row.box = box;
    const auto field = [&](const QString& name) {
        return makeField({.name = name,
                          .help = tr("%1, a mechanical angle").arg(name),
                          .min = -3600.0,
                          .max = 3600.0,
                          .decimals = 1,
                          .unit = QStringLiteral("°")},
                         box);
    };
    row.min = field(tr("Lower end of %1").arg(name(axis)));
    row.max = field(tr("Upper end of %1").arg(name(axis)));
    row.min->setPrefix(tr("from "));
    row.max->setPrefix(tr("to "));
    row.minHere = makeHere(axis, *row.min, tr("lower"), box);
    row.maxHere = makeHere(axis, *row.max, tr("upper"), box);
    row.bar = new LimitBar(box);
    row.bar->setToolTip(tr("Travel of the %1. The pointer shows where it is now.").arg(name(axis)));
    row.hold = new HoldButtons(desk, *m_notice, tr("Move"), box);
    row.hold->addAxis(axis, tr("Towards the lower end of %1 while held").arg(name(axis)),
                      tr("Towards the upper end of %1 while held").arg(name(axis)));
    grid->addWidget(makeCaption(shortName(axis), box), 0, 0);
    grid->addWidget(row.min, 0, 1);
    grid->addWidget(row.minHere, 0, 2);
    grid->addWidget(row.max, 0, 3);
    grid->addWidget(row.maxHere, 0, 4);
    grid->addWidget(row.bar, 1, 1, 1, 2);
    grid->addWidget(row.hold, 1, 3, 1, 2);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return box;
}

QPushButton* GuideTravel::makeHere(Axis axis, QDoubleSpinBox& field, const QString& end, QWidget* parent)
{
    QPushButton* const button =
        makePushButton({.text = tr("Here"),
                        .name = tr("Set the %1 end of %2 here").arg(end, name(axis)),
                        .help = tr("The %1 end of %2 is the present position of the axis").arg(end, name(axis))},
                       parent);
    // The row has room for two fields and two buttons.
    button->setMinimumSize(button->fontMetrics().horizontalAdvance(button->text()) + 2 * kGrid, field.minimumHeight());
    connect(button, &QPushButton::clicked, this, [this, axis, &field] {
        if (const auto& actual = axisOf(m_status, axis).actual) {
            field.setValue(actual->degrees());
        }
    });
    return button;
}

void GuideTravel::showStatus(const StationStatus& status)
{
    m_status = status;
    for (const Axis axis : kAxes) {
        showAxis(axis);
    }
    m_use->setCommand(tr("Use these ends"),
                      status.drives ? tr("Write these ends into the profile and connect again. Then fix the limits of "
                                         "the drives (step Protect).")
                                    : tr("Write these ends into the profile and connect again. Nothing moves."));
    m_use->setBlocked(m_change.isAlready(edit()) ? tr("these are the ends in force")
                                                 : m_change.whyNot(m_status, edit()));
}

void GuideTravel::showAxis(Axis axis)
{
    Row& row = m_rows[axisIndex(axis)];
    row.box->setVisible(m_status.capabilities.has(axis));
    const TravelRange& travel = m_change.applied().axis(axis).geometry.travel;
    if (travel != row.shown) {
        row.shown = travel;
        row.min->setValue(travel.min.degrees());
        row.max->setValue(travel.max.degrees());
    }
    const AxisStatus& now = axisOf(m_status, axis);
    const bool known = isTurnKnown(m_status, axis) && freshness(now.age) == Freshness::Live;
    row.minHere->setEnabled(known);
    row.maxHere->setEnabled(known);
    row.bar->setRanges(travel, travel, entered(axis));
    row.bar->setActual(known ? now.actual : std::nullopt, freshness(now.age));
    row.hold->setRate(isTurnKnown(m_status, axis) ? m_status.profile->jog.normal : m_status.profile->jog.unwind);
    row.hold->showStatus(m_status);
}

// An end that was not edited keeps its exact value. The field shows it rounded.
TravelRange GuideTravel::entered(Axis axis) const
{
    const Row& row = m_rows[axisIndex(axis)];
    const auto end = [](const QDoubleSpinBox& field, Angle shown) {
        const bool untouched = std::abs(field.value() - shown.degrees()) < 0.051;
        return untouched ? shown : Angle::fromDegrees(field.value());
    };
    return {.min = end(*row.min, row.shown.min), .max = end(*row.max, row.shown.max)};
}

ProfileChange::Edit GuideTravel::edit() const
{
    return [azimuth = entered(Axis::Azimuth), elevation = entered(Axis::Elevation)](profile::Profile& profile) {
        profile::setTravel(profile, Axis::Azimuth, azimuth);
        profile::setTravel(profile, Axis::Elevation, elevation);
    };
}

}  // namespace boresight::ui

#include "moc_guide_travel.cpp"
