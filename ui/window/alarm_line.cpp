// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/alarm_line.h"

#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <QGridLayout>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr std::chrono::seconds kSaidFor{10};  // time enough to read a path

QSizePolicy keepsItsPlace()
{
    QSizePolicy policy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    policy.setRetainSizeWhenHidden(true);  // the layout does not move when a button comes or goes
    return policy;
}

}  // namespace

AlarmLine::AlarmLine(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_what(new ValueLabel(tr("Worst alarm"), fonts::text(), {}, this)),
      m_advice(new ValueLabel(tr("What was done and what to do"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_acknowledge(new CommandButton(tr("Acknowledge"), tr("Acknowledge all alarms (F8)"), desk, *m_notice, this)),
      m_recover(new CommandButton(tr("Reset stop"), {}, desk, *m_notice, this)),
      m_authority(new CommandButton(tr("Give to clients"), {}, desk, *m_notice, this))
{
    build();
    connect(m_acknowledge, &QPushButton::clicked, this, [this] { m_acknowledge->ask(request::AcknowledgeAlarms{}); });
    connect(m_recover, &QPushButton::clicked, this, [this] {
        m_recover->ask(m_state == StationState::Fault ? Request(request::Rearm{}) : Request(request::ResetStop{}));
    });
    connect(m_authority, &QPushButton::clicked, this, [this] {
        m_authority->ask(m_control == Authority::Operator ? Request(request::GiveAuthority{})
                                                          : Request(request::TakeAuthority{}));
    });
}

void AlarmLine::build()
{
    for (ValueLabel* const line : {m_what, m_advice, m_notice}) {
        line->setStretching(true);
    }
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(0);
    grid->addWidget(m_what, 0, 0);
    auto* const second = new QHBoxLayout;
    grid->addLayout(second, 1, 0);
    second->addWidget(m_advice, 1);
    second->addWidget(m_notice, 1);
    m_notice->setCollapsing(true);
    grid->setColumnStretch(0, 1);
    int column = 1;
    for (CommandButton* const button : {m_acknowledge, m_recover, m_authority}) {
        button->setSizePolicy(keepsItsPlace());
        grid->addWidget(button, 0, column++, 2, 1);
    }
}

void AlarmLine::showStatus(const StationStatus& status)
{
    m_state = status.state;
    m_control = status.authority;
    showWorst(status);
    showRecovery(status);
}

void AlarmLine::showWorst(const StationStatus& status)
{
    const auto waiting = std::count_if(status.alarms.begin(), status.alarms.end(),
                                       [](const Alarm& alarm) { return !alarm.acknowledged; });
    m_acknowledge->setVisible(waiting > 0 || m_acknowledge->isWaiting());
    m_flashing = waiting > 0;
    if (status.alarms.empty()) {
        m_what->setValue(tr("No alarm"), Tone::Secondary);
        m_what->setToolTip({});
        m_advice->setValue({});
        m_advice->setToolTip({});
        return;
    }
    const Alarm& worst = status.alarms.front();
    // The text may be longer than the line: what must be read stands before it.
    QString head = clockText(worst.since) + QLatin1Char('Z');
    if (waiting > 1) {
        head += tr("  (%1 unacknowledged)").arg(waiting);
    }
    if (!worst.active) {
        head += tr("  over:");
    }
    m_what->setValue(head + QStringLiteral("  ") + worst.what, toneOf(worst.severity), symbolOf(worst.severity));
    QStringList advice{worst.action, worst.remedy};
    advice.removeAll(QString());
    m_advice->setValue(advice.join(QLatin1Char(' ')));
    QString all;
    for (const Alarm& alarm : status.alarms) {
        all += dateText(alarm.since) + (alarm.active ? QString() : tr(", over")) + QLatin1Char('\n') + alarm.what +
               QLatin1Char('\n') + alarm.action + QLatin1Char('\n') + alarm.remedy + QStringLiteral("\n\n");
    }
    m_what->setToolTip(all.trimmed());
    m_advice->setToolTip(m_what->toolTip());
}

void AlarmLine::showRecovery(const StationStatus& status)
{
    const bool fault = status.state == StationState::Fault;
    m_recover->setCommand(fault ? tr("Re-arm") : tr("Reset stop"),
                          fault
                              ? tr("Clear the drive fault. The mount then stands in STANDBY; nothing moves by itself.")
                              : tr("Release STOP. The mount then stands in STANDBY; nothing moves by itself."));
    m_recover->setVisible(fault || status.stopLatched);
    const bool ours = status.authority == Authority::Operator;
    m_authority->setCommand(ours ? tr("Give to clients") : tr("Take control"),
                            ours ? tr("Let rotctld clients move the mount again")
                                 : tr("Keep the mount for the operator: motion commands of clients are refused"));
}

void AlarmLine::beat(SteadyTime now, bool flashing)
{
    m_what->setSymbolShown(flashing || !m_flashing);
    if (!m_said.isEmpty() && now - m_saidAt >= kSaidFor) {
        if (m_notice->text() == m_said) {
            m_notice->setValue({});
        }
        m_said.clear();
    }
}

void AlarmLine::sayForAWhile(const QString& what, SteadyTime now)
{
    m_notice->setValue(what);
    m_said = what;
    m_saidAt = now;
}

void AlarmLine::acknowledge()
{
    if (m_acknowledge->isVisible()) {
        m_acknowledge->ask(request::AcknowledgeAlarms{});
    }
}

}  // namespace boresight::ui

#include "moc_alarm_line.cpp"
