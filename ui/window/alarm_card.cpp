// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/alarm_card.h"

#include "core/alarms/catalogue.h"
#include "core/units/duration_text.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/push_button.h"
#include "ui/kit/symbol.h"
#include "ui/kit/value_label.h"
#include "ui/link/profile_draft.h"
#include "ui/window/flow_row.h"

#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace boresight::ui {

namespace {

constexpr std::chrono::seconds kSaidFor{10};  // time enough to read a path
constexpr int kCardMargin = 12;               // px
constexpr int kCardSymbol = 12;               // px
constexpr double kCardRadius = 6.0;           // px
constexpr int kAlarmEnds = 8;                 // px
constexpr int kTightAlarmEnds = 4;            // px
constexpr int kAlarmSpacing = 4;              // px
constexpr int kTightAlarmSpacing = 2;         // px
constexpr double kCardTint = 0.09;            // of the alarm's colour in the background

QFont boldOf(QFont font)
{
    font.setBold(true);
    return font;
}

QColor mixed(const QColor& ground, const QColor& colour, double part)
{
    const auto mix = [part](double a, double b) { return static_cast<float>((1.0 - part) * a + part * b); };
    return QColor::fromRgbF(mix(ground.redF(), colour.redF()), mix(ground.greenF(), colour.greenF()),
                            mix(ground.blueF(), colour.blueF()));
}

// The action that brings the station back to work, whatever the top alarm is about.
AlarmHelp recoveryOf(const StationStatus& status)
{
    if (status.state == StationState::Fault) {
        return AlarmHelp::Rearm;
    }
    return status.stopLatched ? AlarmHelp::ResetStop : AlarmHelp::None;
}

// The reason why the help button cannot act now. Empty if it can. Opening a panel is always possible.
QString whyNot(AlarmHelp help, const Permissions& may)
{
    switch (help) {
        case AlarmHelp::Rearm:
            return may.reason(Action::Rearm);
        case AlarmHelp::ResetStop:
            return may.reason(Action::ResetStop);
        case AlarmHelp::Unwind:
            return may.reason(Action::Unwind);
        case AlarmHelp::HoldAtEnd:
            return may.reason(Action::HoldAtEnd);
        case AlarmHelp::Reconnect:
            return may.reason(Action::Reconnect);
        case AlarmHelp::ParkNow:
            return may.reason(Action::Park);
        case AlarmHelp::OverrideWind:
            return may.reason(Action::OverrideWind);
        default:
            return {};
    }
}

// The other choice, where there are two.
AlarmHelp alternativeTo(AlarmHelp help)
{
    switch (help) {
        case AlarmHelp::Unwind:
            return AlarmHelp::HoldAtEnd;
        case AlarmHelp::ParkNow:
            return AlarmHelp::OverrideWind;
        default:
            return AlarmHelp::None;
    }
}

QString alternativeTip(AlarmHelp help)
{
    return help == AlarmHelp::HoldAtEnd
               ? AlarmCard::tr(
                     "Do not unwrap. The mount waits at the cable end until it can reach the target again. "
                     "Clients keep control")
               : AlarmCard::tr(
                     "The mount may move in the wind for the time of wind.override_min. Then the mount parks again");
}

// A latched STOP is no alarm of the station. The operator knows it, but needs the way back.
std::optional<Alarm> mostUrgent(const StationStatus& status)
{
    if (!status.alarms.empty()) {
        return status.alarms.front();
    }
    if (!status.stopLatched) {
        return std::nullopt;
    }
    const AlarmEntry& entry = alarmEntry("window.stop-latched");
    const AlarmText text = textOf(entry, {});
    return Alarm{.name = QLatin1String(entry.id),
                 .severity = entry.severity,
                 .what = text.what,
                 .action = text.action,
                 .remedy = text.remedy,
                 .help = entry.help,
                 .since = computerUtc(status)};
}

QString linesOf(QStringList sentences)
{
    sentences.removeAll(QString());
    return sentences.join(QLatin1Char('\n'));
}

// What the choice to unwrap loses, for a card that leaves out the sentence of the alarm about it.
QString unwrapCost(const StationStatus& status)
{
    const std::optional<CableEnd>& end = status.cableEnd;
    return end && end->turningBack && end->lostByHolding
               ? AlarmCard::tr("Unwrapping loses the target for %1.").arg(durationText(*end->turningBack))
               : QString();
}

// What the other choice loses. The way of a target that Boresight does not compute itself is an estimate.
QString holdCost(const StationStatus& status)
{
    const std::optional<CableEnd>& end = status.cableEnd;
    if (!end || !end->turningBack || !end->lostByHolding) {
        return {};
    }
    const QString sentence = status.tracked ? AlarmCard::tr("Holding at the end loses the target for %1.")
                                            : AlarmCard::tr(
                                                  "Holding at the end loses the target for about %1 if it keeps its "
                                                  "azimuth rate.");
    return sentence.arg(durationText(*end->lostByHolding));
}

QString listOf(const std::vector<Alarm>& alarms)
{
    QStringList all;
    for (const Alarm& alarm : alarms) {
        all << dateText(alarm.since) + (alarm.active ? QString() : AlarmCard::tr(", cleared")) + QLatin1Char('\n') +
                   linesOf({alarm.what, alarm.action, alarm.remedy});
    }
    return all.join(QStringLiteral("\n\n"));
}

}  // namespace

AlarmCard::AlarmCard(const ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_what(new ValueLabel(tr("Worst alarm"), boldOf(fonts::text()), {}, this)),
      m_advice(new ValueLabel(tr("What was done and what to do"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_since(new ValueLabel(tr("When the alarm came"), fonts::small(), QStringLiteral("00:00:00Z"), this)),
      m_help(new CommandButton({}, {}, desk, *m_notice, this)),
      m_alternative(new CommandButton({}, {}, desk, *m_notice, this)),
      m_recover(new CommandButton(buttonText(AlarmHelp::ResetStop), {}, desk, *m_notice, this)),
      m_acknowledge(new CommandButton(tr("Acknowledge"), tr("Acknowledge all alarms (F8)"), desk, *m_notice, this)),
      m_count(makePushButton({.text = {}, .name = tr("All alarms"), .help = tr("Open the list of alarms")}, this)),
      m_more(makePushButton(
          {.text = tr("More"), .name = tr("Whole alarm"), .help = tr("Open the whole alarm in the log")}, this))
{
    build();
    connect(m_help, &QPushButton::clicked, this, [this] { help(m_shown ? m_shown->help : AlarmHelp::None, *m_help); });
    connect(m_alternative, &QPushButton::clicked, this,
            [this] { help(m_shown ? alternativeTo(m_shown->help) : AlarmHelp::None, *m_alternative); });
    connect(m_recover, &QPushButton::clicked, this, [this] { help(m_recovery, *m_recover); });
    connect(m_acknowledge, &QPushButton::clicked, this, [this] { m_acknowledge->ask(request::AcknowledgeAlarms{}); });
    connect(m_count, &QPushButton::clicked, this, &AlarmCard::listWanted);
    connect(m_more, &QPushButton::clicked, this, [this] {
        if (m_shown) {
            Q_EMIT lineWanted(*m_shown);
        }
    });
    m_notice->installEventFilter(this);
    hide();
}

void AlarmCard::build()
{
    for (ValueLabel* const label : {m_what, m_advice, m_notice}) {
        label->setWrapping(true);
        label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    }
    for (ValueLabel* const label : {m_what, m_advice}) {
        label->setCursor(Qt::PointingHandCursor);
    }
    m_notice->setCollapsing(true);
    m_count->setFlat(true);
    m_more->setFlat(true);
    m_more->hide();
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    // A click leaves the keyboard where it was, so the next Esc stops the mount.
    for (QWidget* const button :
         std::initializer_list<QWidget*>{m_help, m_alternative, m_recover, m_more, m_count, m_acknowledge}) {
        button->setFocusPolicy(Qt::TabFocus);
    }
    auto* const buttons = new FlowRow;
    for (QWidget* const part : std::initializer_list<QWidget*>{m_help, m_alternative, m_recover}) {
        buttons->addWidget(part);
    }
    // These buttons are at the other end of the row. So a second press on a button that has just disappeared does not
    // acknowledge the alarm.
    for (QWidget* const part : std::initializer_list<QWidget*>{m_since, m_more, m_count, m_acknowledge}) {
        buttons->addWidget(part);
        buttons->setAlignment(part, Qt::AlignRight);
    }
    auto* const column = new QVBoxLayout(this);
    column->addWidget(m_what);
    column->addWidget(m_advice);
    column->addWidget(m_notice);
    column->addLayout(buttons);
    setTight(false);
}

void AlarmCard::setTight(bool tight)
{
    const int ends = tight ? kTightAlarmEnds : kAlarmEnds;
    m_what->setFont(boldOf(tight ? fonts::label() : fonts::text()));
    layout()->setContentsMargins(2 * kCardMargin + kCardSymbol, ends, kCardMargin, ends);
    layout()->setSpacing(tight ? kTightAlarmSpacing : kAlarmSpacing);
}

// An alarm that was acknowledged has been read. The choice is still open. An alarm that has ended asks for nothing but
// the Re-arm of its fault, and its action belongs to the past.
QString AlarmCard::adviceIn(AlarmForm form) const
{
    if (!m_shown) {
        return {};
    }
    const Alarm& alarm = *m_shown;
    const bool isRead = alarm.acknowledged;
    const bool asks = alarm.active || (alarm.help == AlarmHelp::Rearm && m_recovery == AlarmHelp::Rearm);
    const QString did = isRead || !asks || form == AlarmForm::Remedy ? QString() : alarm.action;
    const QString remedy = isRead || !asks ? QString() : alarm.remedy;
    const QString lines = linesOf({did, remedy, did.isEmpty() ? m_unwrapCost : QString(), m_holdCost});
    return form == AlarmForm::Lines ? lines : QString(lines).replace(QLatin1Char('\n'), QLatin1Char(' '));
}

// Computed without a layout, because it is needed for each of twenty status values a second.
int AlarmCard::heightWith(AlarmForm form, int width) const
{
    const int text = width - layout()->contentsMargins().left() - layout()->contentsMargins().right();
    const int now = m_advice->text().isEmpty() ? 0 : m_advice->heightForWidth(text);
    const QString advice = adviceIn(form);
    return heightForWidth(width) - now + (advice.isEmpty() ? 0 : m_advice->heightWith(advice, text));
}

QString AlarmCard::wholeText() const
{
    return m_what->text() + adviceIn(AlarmForm::Lines);
}

void AlarmCard::setForm(AlarmForm form)
{
    if (form == std::exchange(m_form, form)) {
        return;
    }
    m_advice->setValue(adviceIn(form));
    showTimeOrMore();
}

void AlarmCard::showTimeOrMore()
{
    const bool isBrief = m_form == AlarmForm::Remedy;
    m_more->setVisible(isBrief && m_shown);
    m_since->setVisible(!isBrief && !m_since->text().isEmpty());
}

void AlarmCard::showStatus(const StationStatus& status)
{
    const AlarmHelp before = std::exchange(m_recovery, recoveryOf(status));
    m_shown = mostUrgent(status);
    showAlarm(status);
    const AlarmHelp offeredBefore =
        std::exchange(m_offered, m_shown && m_shown->active ? m_shown->help : AlarmHelp::None);
    if (isVisible() && (before != m_recovery || offeredBefore != m_offered)) {
        m_guard.begin();
    }
    showButtons(status);
    showCount(status);
    showWhetherNeeded();
    update();
}

void AlarmCard::showAlarm(const StationStatus& status)
{
    for (ValueLabel* const label : {m_what, m_advice}) {
        label->setVisible(m_shown.has_value());
    }
    m_since->setValue(status.alarms.empty() ? QString() : clockText(status.alarms.front().since) + QLatin1Char('Z'),
                      Tone::Secondary);
    showTimeOrMore();
    if (!m_shown) {
        m_what->setValue({});
        m_advice->setValue({});
        m_what->setToolTip({});
        m_advice->setToolTip({});
        return;
    }
    const Alarm& alarm = *m_shown;
    m_what->setValue(alarm.active ? alarm.what : tr("Cleared: %1").arg(alarm.what));
    const bool mayChoose = alarm.active && alarm.help == AlarmHelp::Unwind;
    m_unwrapCost = mayChoose ? unwrapCost(status) : QString();
    m_holdCost = mayChoose ? holdCost(status) : QString();
    m_advice->setValue(adviceIn(m_form));
    m_advice->setVisible(!m_advice->text().isEmpty());
    m_what->setToolTip(listOf(status.alarms));
    m_advice->setToolTip(m_what->toolTip());
}

void AlarmCard::showButtons(const StationStatus& status)
{
    const AlarmHelp shown = m_offered;
    // Re-arm and Reset stop are shown once, while a fault or STOP is latched.
    const bool recovers = shown == AlarmHelp::Rearm || shown == AlarmHelp::ResetStop;
    m_help->setVisible(shown != AlarmHelp::None && !recovers);
    m_help->setCommand(buttonText(shown), m_shown ? m_shown->remedy : QString());
    m_help->setBlocked(whyNot(shown, status.permissions));
    const AlarmHelp alternative = alternativeTo(shown);
    m_alternative->setVisible(alternative != AlarmHelp::None && m_recovery == AlarmHelp::None);
    m_alternative->setCommand(buttonText(alternative), alternativeTip(alternative));
    m_alternative->setBlocked(whyNot(alternative, status.permissions));
    m_recover->setVisible(m_recovery != AlarmHelp::None);
    m_recover->setBlocked(whyNot(m_recovery, status.permissions));
    m_recover->setCommand(buttonText(m_recovery == AlarmHelp::None ? AlarmHelp::ResetStop : m_recovery),
                          m_recovery == AlarmHelp::Rearm
                              ? tr("Clear the drive fault. The mount then stands in STANDBY. Nothing moves by itself.")
                              : tr("Release STOP. The mount then stands in STANDBY. Nothing moves by itself."));
}

void AlarmCard::showCount(const StationStatus& status)
{
    const auto waiting = std::ranges::count_if(status.alarms, [](const Alarm& alarm) { return !alarm.acknowledged; });
    m_acknowledge->setVisible(waiting > 0 || m_acknowledge->isWaiting());
    m_flashing = waiting > 0;
    m_count->setText(tr("1 of %1").arg(status.alarms.size()));
    m_count->setToolTip(tr("Open the list of alarms. Not acknowledged: %1").arg(waiting));
    m_count->setVisible(status.alarms.size() > 1);
    // A card without buttons needs no row of their height.
    const bool hasButtons = std::ranges::any_of(
        std::initializer_list<const QWidget*>{m_help, m_alternative, m_recover, m_more, m_count, m_acknowledge},
        [](const QWidget* button) { return !button->isHidden(); });
    m_since->setFixedHeight(hasButtons ? kTouchSize : m_since->fontMetrics().height());
}

void AlarmCard::showWhetherNeeded()
{
    const bool needed = m_shown || m_recovery != AlarmHelp::None || !m_notice->text().isEmpty();
    if (isVisibleTo(parentWidget()) != needed) {
        setVisible(needed);
    }
}

// The notice may appear or disappear at any time.
bool AlarmCard::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) {
        showWhetherNeeded();
    }
    return QWidget::eventFilter(watched, event);
}

void AlarmCard::help(AlarmHelp help, CommandButton& button)
{
    if (!m_guard.isOver()) {
        return;
    }
    switch (help) {
        case AlarmHelp::None:
            return;
        case AlarmHelp::Rearm:
            button.ask(request::Rearm{});
            return;
        case AlarmHelp::ResetStop:
            button.ask(request::ResetStop{});
            return;
        case AlarmHelp::Unwind:
            button.ask(request::Unwind{});
            return;
        case AlarmHelp::HoldAtEnd:
            button.ask(request::HoldAtEnd{});
            return;
        case AlarmHelp::ParkNow:
            button.ask(request::Park{});
            return;
        case AlarmHelp::OverrideWind:
            button.ask(request::OverrideWind{});
            return;
        case AlarmHelp::UseNewTime:
            button.ask(request::UseNewTime{});
            return;
        case AlarmHelp::Reconnect:
            button.ask(request::Reconnect{m_draft.applied()});
            return;
        case AlarmHelp::MovePark:
        case AlarmHelp::OpenProtection:
        case AlarmHelp::OpenDrives:
        case AlarmHelp::OpenClients:
        case AlarmHelp::OpenLimits:
        case AlarmHelp::OpenNorth:
        case AlarmHelp::OpenProfile:
        case AlarmHelp::ConfirmWrap:
        case AlarmHelp::OpenHomeRun:
        case AlarmHelp::OpenGuide:
            Q_EMIT panelWanted(help);
            return;
    }
}

void AlarmCard::paintEvent(QPaintEvent*)
{
    const Theme& theme = currentTheme();
    const bool urgent = m_shown && m_shown->active;
    const QColor colour = urgent ? theme.colour(toneOf(m_shown->severity)) : theme.grid;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.0));
    painter.setBrush(mixed(theme.window, colour, urgent ? kCardTint : 0.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCardRadius, kCardRadius);
    if (m_shown && m_symbolShown) {
        const double line = m_what->fontMetrics().height();
        const QRectF box(kCardMargin, m_what->y() + 0.5 * (line - kCardSymbol), kCardSymbol, kCardSymbol);
        drawSymbol(painter, symbolOf(m_shown->severity), box, theme.colour(toneOf(m_shown->severity)));
    }
}

void AlarmCard::mouseReleaseEvent(QMouseEvent* event)
{
    const auto isOn = [event](const QWidget* text) {
        return text->isVisible() && text->geometry().contains(event->pos());
    };
    if (event->button() == Qt::LeftButton && m_shown && (isOn(m_what) || isOn(m_advice))) {
        Q_EMIT lineWanted(*m_shown);
    }
}

void AlarmCard::beat(SteadyTime now, bool flashing)
{
    const bool symbolShown = flashing || !m_flashing;
    if (symbolShown != std::exchange(m_symbolShown, symbolShown)) {
        update();
    }
    if (m_said && now - m_said->at >= kSaidFor) {
        if (m_notice->text() == m_said->what) {
            m_notice->setValue({});
        }
        m_said.reset();
    }
}

void AlarmCard::sayForAWhile(const QString& what, SteadyTime now)
{
    m_notice->setValue(what);
    m_said = Said{.what = what, .at = now};
}

void AlarmCard::acknowledge()
{
    if (m_acknowledge->isVisible()) {
        m_acknowledge->ask(request::AcknowledgeAlarms{});
    }
}

}  // namespace boresight::ui

#include "moc_alarm_card.cpp"
