// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/jog_panel.h"

#include "ui/jog/jog_choices.h"
#include "ui/jog/third_axis_row.h"
#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <QGridLayout>

namespace boresight::ui {

JogPanel::JogPanel(const Clock& clock, const ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_pad(new JogPad(clock, desk, *m_notice, this)),
      m_choices(new JogChoices(draft, *m_pad, this)),
      m_trim(new ValueLabel(tr("Trim"), fonts::label(), {}, this)),
      m_clearTrim(new CommandButton(tr("Clear trim"), {}, desk, *m_notice, this)),
      m_thirdAxis(new ThirdAxisRow(desk, *m_notice, this))
{
    build();
    connect(m_clearTrim, &QPushButton::clicked, this, [this] { m_clearTrim->ask(request::ClearTrim{}); });
    connect(m_pad, &JogPad::interrupted, this, [this] { m_pilot.letGo(); });
}

void JogPanel::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(kGrid, kGrid / 2, kGrid, kGrid / 2);
    grid->setHorizontalSpacing(kGrid);
    grid->setVerticalSpacing(kGrid / 2);
    grid->addWidget(makeGroupCaption(tr("Move by hand"), this), 0, 0, 1, 2);
    grid->addWidget(m_pad, 1, 0);
    grid->addWidget(makeChoices(), 1, 1, Qt::AlignTop);
    grid->addWidget(m_thirdAxis, 2, 0, 1, 2);
    grid->addWidget(m_notice, 3, 0, 1, 2);
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

void JogPanel::showStatus(const StationStatus& status)
{
    m_status = status;
    m_choices->showStatus(status);
    m_pad->showStatus(status);
    m_thirdAxis->showStatus(status);
    showTrim();
}

void JogPanel::showTrim()
{
    const SkyPointing trim = m_status.trim.value_or(SkyPointing{});
    const auto filled = [&trim](const QString& words) {
        return words.arg(signedAngleText(trim.azimuth), signedAngleText(trim.elevation));
    };
    const bool isXY = hasXY(m_status);
    // One axis a line, because both beside "Clear trim" are too wide for a small window.
    m_trim->setValue(m_status.trim ? filled(isXY ? tr("X %1\nY %2") : tr("AZ %1\nEL %2")) : tr("No trim"),
                     m_status.trim ? Tone::Normal : Tone::Secondary);
    m_clearTrim->setBlocked(m_status.permissions.reason(Action::ClearTrim));
    m_clearTrim->setCommand(tr("Clear trim"), tr("%1. Your steps are added to the targets of the clients.")
                                                  .arg(filled(isXY ? tr("Trim: X %1 Y %2") : tr("Trim: AZ %1 EL %2"))));
}

void JogPanel::hold()
{
    m_pad->hold();
}

void JogPanel::beat()
{
    m_pad->disarmWhenUnused();
}

// Only if the operator sees the effect: this panel is in front, in the active window.
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
