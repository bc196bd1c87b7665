// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_north.h"

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
#include "ui/north/calibration_words.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QShowEvent>
#include <QSignalBlocker>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr Angle kNearZenith = 5_deg;  // this near to the zenith an azimuth is not accurate

// The calibration in effect, from the history of the North panel. Null: none.
const CalibrationHistoryEntry* inForce(const StationStatus& status)
{
    const auto& history = calibrationOf(status).history;
    const auto found = std::ranges::find_if(history, &CalibrationHistoryEntry::inForce);
    return found == history.end() ? nullptr : &*found;
}

// Empty: north is unknown for this mount, or was found with other drives or at another place.
QString knownText(const StationStatus& status, Angle offset)
{
    if (offset == Angle{} || !calibrationOf(status).otherMount.isEmpty()) {
        return {};
    }
    const CalibrationHistoryEntry* const entry = inForce(status);
    return entry == nullptr ? GuideNorth::tr("North is known: azimuth offset %1, set by hand.").arg(angleText(offset))
                            : GuideNorth::tr("North is known: azimuth offset %1, from \"%2\" of %3.")
                                  .arg(angleText(offset), entry->title, minuteText(entry->when));
}

QString panelText(const StationStatus& status)
{
    return status.sensor.configured() ? GuideNorth::tr("Sensor, Sun, Moon (Ctrl+9)")
                                      : GuideNorth::tr("Sun, Moon (Ctrl+9)");
}

QString explanation(const QString& known, bool sensor, bool isXY)
{
    return isXY ? GuideNorth::tr(
                      "An X/Y mount needs no north. The profile has the direction of the X axis "
                      "(mount.x_axis_deg). Press Next.")
           : known.isEmpty() && !sensor ? GuideNorth::tr(
                                              "Point the antenna at a landmark with a known bearing, and type the "
                                              "bearing. Or use the Sun or the Moon. This mount has no sensor. To find "
                                              "north later, press Next. Everything else works without north.")
           : known.isEmpty()
               ? GuideNorth::tr(
                     "Point the antenna at a landmark with a known bearing, and type the bearing. Or use the sensor, "
                     "the Sun or the Moon. To find north later, press Next. Everything else works without north.")
               : known + QLatin1Char(' ') +
                     GuideNorth::tr("Press Confirm to keep it. To replace it, type the true azimuth of the antenna.");
}

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
      m_replace(new QCheckBox(tr("Replace the known north"), this)),
      m_hold(new HoldButtons(desk, *m_notice, tr("Move"), this)),
      m_set(new CommandButton(tr("Set north"), tr("Set the azimuth offset of the pointing model. Nothing moves."), desk,
                              *m_notice, this)),
      m_panel(makePushButton({.text = tr("Sensor, Sun, Moon (Ctrl+9)"),
                              .help = tr("Find north on the panel North. F3 returns to this step.")},
                             this))
{
    const QString help = tr("Moves the %1 slowly while held").arg(name(Axis::Azimuth));
    m_hold->addAxis(Axis::Azimuth, help, help);
    build();
    connect(m_truth, &QDoubleSpinBox::valueChanged, this, &GuideNorth::type);
    connect(m_truth->findChild<QLineEdit*>(), &QLineEdit::textEdited, this,
            &GuideNorth::type);  // also when the field was emptied
    connect(m_replace, &QCheckBox::toggled, this, &GuideNorth::showEffect);
    connect(m_set, &QPushButton::clicked, this, [this] { m_change.ask(*m_set, edit()); });
    connect(m_set, &CommandButton::accepted, this, &GuideNorth::taken);
    connect(m_panel, &QPushButton::clicked, this, &GuideNorth::panelWanted);
}

void GuideNorth::build()
{
    for (ValueLabel* const label : {m_explanation, m_pointing, m_effect, m_notice}) {
        label->setStretching(true);
    }
    m_explanation->setLines(4);
    m_effect->setLines(3);
    m_notice->setCollapsing(true);
    m_replace->setFont(fonts::label());
    m_replace->setAccessibleName(m_replace->text());
    m_replace->setVisible(false);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(6);
    auto* const top = new QHBoxLayout;
    top->addWidget(m_explanation, 1);
    top->addWidget(new StepPicture(StepPicture::Scene::North, this));
    grid->addLayout(top, 0, 0, 1, 3);
    grid->addWidget(m_pointing, 1, 0, 1, 2);
    grid->addWidget(m_hold, 1, 2);
    grid->addWidget(makeCaption(tr("True azimuth"), *m_truth), 2, 0);
    grid->addWidget(m_truth, 2, 1);
    grid->addWidget(m_set, 2, 2);
    grid->addWidget(m_effect, 3, 0, 1, 3);
    grid->addWidget(m_panel, 4, 0, 1, 2, Qt::AlignLeft);
    grid->addWidget(m_replace, 4, 2,
                    Qt::AlignLeft);  // in an existing row, because a window of 700 px has no room for another one
    grid->addWidget(m_notice, 6, 0, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(5, 1);
}

void GuideNorth::showStatus(const StationStatus& status)
{
    const bool another =
        status.profile->bus != m_status.profile->bus || status.profile->mount.name != m_status.profile->mount.name;
    m_status = status;
    if (another) {
        forget();  // the value was typed for the other mount
    }
    m_hold->setRate(status.profile->jog.slow);
    m_hold->showStatus(status);
    showKnown();
    showEffect();
}

// The mount may have moved meanwhile, or north may have been found elsewhere. If only the window was hidden, the typed
// value stays.
void GuideNorth::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!event->spontaneous()) {
        forget();
        showEffect();
    }
}

// An empty field, or one with only a sign, still returns the previous number.
void GuideNorth::type()
{
    m_typed = m_truth->hasAcceptableInput();
    showEffect();
}

// The next value must be typed and confirmed again.
void GuideNorth::forget()
{
    m_typed = false;
    m_replace->setChecked(false);
}

void GuideNorth::taken()
{
    forget();
    Q_EMIT done();
}

void GuideNorth::showKnown()
{
    const QString known = knownText(m_status, m_change.applied().pointing.azimuthOffset);
    m_known = !known.isEmpty();
    m_explanation->setValue(explanation(known, m_status.sensor.configured(), hasXY(m_status)));
    m_panel->setText(panelText(m_status));
    m_panel->setAccessibleName(m_panel->text());
    m_replace->setVisible(m_known);
}

bool GuideNorth::isBeamKnown() const
{
    return m_status.actual && areTurnsKnown(m_status) && freshness(m_status.azimuth.age) != Freshness::NoData;
}

AxisPosition GuideNorth::axes() const
{
    return {.azimuth = m_status.azimuth.actual.value_or(Angle{}),
            .elevation = m_status.elevation.actual.value_or(Angle{})};
}

QString GuideNorth::whyNot() const
{
    if (hasXY(m_status)) {
        return tr("The direction of the X axis of an X/Y mount is a setting of the profile.");
    }
    for (const Axis axis : kAxes) {
        const QString reason = m_status.permissions.reason(setAction(axis));
        if (m_status.capabilities.has(axis) && !reason.isEmpty()) {
            return reason;
        }
    }
    if (abs(axes().elevation - 90_deg) < kNearZenith) {
        return tr("The antenna points up. Lower it first.");
    }
    if (m_status.antenna != pointing::kMainAntenna) {
        return tr("Antenna \"%1\" is in use. Choose \"main\" first.").arg(QString::fromStdString(m_status.antenna));
    }
    if (!m_typed) {
        return tr("Type the true azimuth first.");
    }
    if (m_known && !m_replace->isChecked()) {
        return tr("North is known. Tick \"Replace the known north\" first.");
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
    const bool known = isBeamKnown();
    const Angle beam = known ? m_status.actual->azimuth : Angle{};
    if (known && !m_typed && m_truth->hasAcceptableInput()) {  // otherwise the operator is typing
        const QSignalBlocker silent(m_truth);
        m_truth->setValue(beam.degrees());
    }
    m_pointing->setValue(tr("The mount reports %1").arg(known ? azimuthText(beam, 2) : noValue()));
    m_set->setBlocked(whyNot());
    if (!known || !m_typed) {
        m_effect->setValue({});
        return;
    }
    profile::Profile then = now;
    edit()(then);
    m_effect->setValue(
        tr("The azimuth offset changes from %1 to %2 at once. Nothing moves. Travel, cable and park keep their "
           "numbers. Horizon and keep-outs keep their true directions. To go back, press Undo on the page Profile.")
            .arg(angleText(now.pointing.azimuthOffset), angleText(then.pointing.azimuthOffset)),
        Tone::Secondary);
}

}  // namespace boresight::ui

#include "moc_guide_north.cpp"
