// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/header_bar.h"

#include "core/plan/plan_words.h"
#include "ui/kit/axes.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/kit/widest.h"
#include "ui/look/glyph.h"
#include "ui/sky/range_words.h"
#include "ui/window/authority_button.h"
#include "ui/window/clock_words.h"
#include "ui/window/stop_button.h"

#include <QGridLayout>
#include <QStringList>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr QSize kMenuSize{44, 44};
constexpr long kLongestInMinutes = 6000;  // s
constexpr int kControlMargin = 8;         // px, around the name of the client in control

QString controlHelp(const StationStatus& status)
{
    QString text = HeaderBar::tr(
        "Who has control, and how many clients wait for it. While the operator has control, Boresight refuses motion "
        "commands of rotctld clients.");
    text += QLatin1Char('\n');
    text += status.listening.isEmpty() ? HeaderBar::tr("rotctld does not listen")
                                       : HeaderBar::tr("rotctld listens on %1").arg(status.listening);
    for (const ClientStatus& client : status.clients) {
        text += QLatin1Char('\n') + client.address;
        if (!client.program.isEmpty()) {
            text += QLatin1Char(' ') + client.program;
        }
        if (client.inControl) {
            text += HeaderBar::tr(", in control");
        }
        if (!client.lastCommand.isEmpty()) {
            text += HeaderBar::tr(", last command %1").arg(client.lastCommand);
        }
    }
    return text;
}

QString minutesText(Seconds time)
{
    const auto whole = std::max(0L, std::lround(time.count()));
    if (whole >= kLongestInMinutes) {
        return HeaderBar::tr("%1 h %2 min").arg(whole / 3600).arg(whole / 60 % 60);
    }
    return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

QString trackingText(const TrackedTarget& tracked, UtcTime now)
{
    if (!tracked.next) {
        return HeaderBar::tr("Tracking %1").arg(tracked.name);
    }
    const QString time = minutesText(*tracked.next - now);
    return tracked.isUp ? HeaderBar::tr("Tracking %1, sets in %2").arg(tracked.name, time)
                        : HeaderBar::tr("Waiting for %1, rises in %2").arg(tracked.name, time);
}

// How the mount drives the pass, in words. Empty: it follows the target, which is nothing special.
QString plannedText(const StationStatus& status)
{
    const plan::SharedVariant plan = status.tracked ? status.tracked->plan : nullptr;
    return plan && !plan::isPlain(*plan) ? plan::summaryText(*plan) : QString();
}

// Whether the special part of a plan is still to come. If that is the whole pass: whether the pass is.
bool isAhead(const plan::PlanVariant& plan, UtcTime now)
{
    return now < (plan.unwrap ? plan.unwrap->to : plan.ramp ? plan.ramp->to : plan.moments.front().utc);
}

// The action of the mount in one sentence: the action, the remaining time, the source. The least important part is
// last.
QStringList doing(const StationStatus& status)
{
    if (status.tracked) {
        return {trackingText(*status.tracked, status.utc)};
    }
    QStringList parts{status.targetText};
    if (status.slew) {
        parts << HeaderBar::tr("there in %1 s").arg(std::ceil(status.slew->remaining.count()), 0, 'f', 0);
    }
    // The text of a motion that the wind began says so.
    if (!status.commander.name.isEmpty() && status.commander.name != QLatin1String("wind")) {
        parts << HeaderBar::tr("by %1").arg(sourceText(status.commander.name));
    }
    parts.first()[0] = parts.first()[0].toUpper();
    return parts;
}

// The pass that the mount waits for while the schedule is armed: it will move by itself.
QString armedText(const ScheduleStatus& schedule, UtcTime now)
{
    const auto next = std::ranges::find_if(schedule.plan.chosen,
                                           [&](const schedule::WatchedPass& pass) { return pass.begins() > now; });
    return next == schedule.plan.chosen.end()
               ? HeaderBar::tr("Schedule armed")
               : HeaderBar::tr("Schedule armed: %1 in %2").arg(next->name, waitText(next->begins() - now));
}

QString whoControls(const StationStatus& status)
{
    if (status.authority == Authority::Operator) {
        return HeaderBar::tr("you");
    }
    const auto leader = std::ranges::find_if(status.clients, &ClientStatus::inControl);
    if (leader == status.clients.end()) {
        return HeaderBar::tr("clients");
    }
    return leader->program.isEmpty() ? leader->address : leader->program;
}

// The source that has control, and the number of clients that wait for it. If there is little room, only the names and
// numbers: the complete text is in the tooltip.
QString controlText(const StationStatus& status, int room)
{
    const QString who = whoControls(status);
    const auto waiting = std::ranges::count_if(status.clients, &ClientStatus::wanting);
    const QString whole = waiting == 0 ? HeaderBar::tr("Control: %1").arg(who)
                                       : HeaderBar::tr("Control: %1, %2 waiting").arg(who).arg(waiting);
    const QFontMetrics metrics(fonts::label());
    if (metrics.horizontalAdvance(whole) <= room - kControlMargin) {
        return whole;
    }
    const QString more = waiting == 0 ? QString() : HeaderBar::tr(", +%1").arg(waiting);
    return metrics.elidedText(who, Qt::ElideRight, room - kControlMargin - metrics.horizontalAdvance(more)) + more;
}

QString notListening(int room)
{
    const QString whole = HeaderBar::tr("Clients cannot connect");
    return QFontMetrics(fonts::label()).horizontalAdvance(whole) <= room - kRowHeight ? whole
                                                                                      : HeaderBar::tr("no clients");
}

// The width if there is little room. A longer name of a program is cut.
int widestControl()
{
    const QFontMetrics metrics(fonts::label());
    return std::max(metrics.horizontalAdvance(HeaderBar::tr("Control: %1").arg(HeaderBar::tr("clients"))),
                    metrics.horizontalAdvance(HeaderBar::tr("no clients")) + kRowHeight / 2) +
           kControlMargin;
}

// True if the alarm that is on the card says why the station is in this state.
bool isAlarmText(const StationStatus& status)
{
    return !status.alarms.empty() && status.alarms.front().active &&
           status.alarms.front().what.startsWith(status.stateReason, Qt::CaseInsensitive);
}

Tone stateTone(const StationStatus& status)
{
    switch (status.state) {
        case StationState::Disconnected:
            return drivesOf(status).released ? Tone::Warning : Tone::Alarm;  // the operator wanted the release
        case StationState::Fault:
            return Tone::Alarm;
        case StationState::Stopped:
            return Tone::Warning;
        default:
            return Tone::Normal;
    }
}

Symbol stateSymbol(Tone tone)
{
    return tone == Tone::Alarm ? Symbol::Alarm : tone == Tone::Warning ? Symbol::Warning : Symbol::None;
}

}  // namespace

HeaderBar::HeaderBar(AuthorityButton& authority, QWidget* parent)
    : QWidget(parent),
      m_state(new ValueLabel(tr("Station state"), fonts::state(), widestStationState(fonts::state()), this)),
      m_reason(new ValueLabel(tr("Reason of the state"), fonts::label(), {}, this)),
      m_limited(new ValueLabel(tr("Target limited"), fonts::text(), tr("AT LIMIT"), this)),
      m_target(new ValueLabel(tr("Target and its source"), fonts::text(), {}, this)),
      m_links(this),
      m_control(new ValueLabel(tr("Who has control"), fonts::label(), {}, this)),
      m_utc(new ValueLabel(tr("UTC"), fonts::clock(), QStringLiteral("00:00:00Z?"), this)),
      m_clock(new ValueLabel(tr("Error of the clock"), fonts::label(), widestClockErrorText(), this)),
      m_simulated(new ValueLabel(tr("Simulated mount"), fonts::label(), tr("SIMULATED"), this)),
      m_menu(new QToolButton(this)),
      m_stop(new StopButton(this))
{
    build(authority);
    connect(m_stop, &StopButton::pressed, this, &HeaderBar::stopPressed);
    connect(m_menu, &QToolButton::clicked, this, &HeaderBar::menuWanted);
}

void HeaderBar::build(AuthorityButton& authority)
{
    for (ValueLabel* const wide : {m_reason, m_target, m_control}) {
        wide->setStretching(true);
    }
    m_reason->setBySentences(true);
    for (ValueLabel* const marked : {m_state, m_limited}) {
        marked->setSymbolRoom(true);
    }
    m_target->setLines(2);
    m_simulated->setOutlined(true);
    m_simulated->setToolTip(
        tr("No real drive is connected. Settings and results stay in the simulation of this mount."));
    m_simulated->setAlignment(Qt::AlignCenter);
    m_utc->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_clock->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* const grid = new QGridLayout(this);
    auto* const targetRow = new QHBoxLayout;
    grid->addLayout(targetRow, 0, 1);
    targetRow->setSpacing(4);
    targetRow->addWidget(m_limited);
    targetRow->addWidget(m_target, 1);
    for (QWidget* const link : m_links.besideTheTarget()) {
        targetRow->addWidget(link);  // the row below has no room for it at 1024 px
    }
    auto* const linkRow = new QHBoxLayout;
    grid->addLayout(linkRow, 1, 1);
    linkRow->setSpacing(1);
    for (QWidget* const link : m_links.ofTheMount()) {
        linkRow->addWidget(link);
    }
    linkRow->addStretch(1);
    auto* const control = new QVBoxLayout;
    control->setSpacing(2);
    control->addWidget(m_control);
    control->addWidget(&authority, 0, Qt::AlignLeft);

    grid->setContentsMargins(4, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(2);
    grid->addWidget(m_state, 0, 0);
    grid->addWidget(m_reason, 1, 0);
    grid->addLayout(control, 0, 2, 2, 1);
    auto* const time = new QVBoxLayout;
    time->setSpacing(0);
    for (ValueLabel* const line : {m_utc, m_clock, m_simulated}) {
        time->addWidget(line, 0, Qt::AlignRight);
    }
    grid->addLayout(time, 0, 3, 2, 1, Qt::AlignVCenter);
    m_menu->setIcon(glyphIcon(Glyph::Menu));
    m_menu->setFixedSize(kMenuSize);
    m_menu->setFocusPolicy(Qt::TabFocus);
    m_menu->setAccessibleName(tr("Menu"));
    m_menu->setToolTip(tr("Menu: theme, full screen, language, guide, keys, diagnostics (F10 or Alt)"));
    grid->addWidget(m_menu, 0, 4, 2, 1, Qt::AlignCenter);
    grid->addWidget(m_stop, 0, 5, 2, 1, Qt::AlignCenter);
    grid->setColumnStretch(1, 3);
    grid->setColumnStretch(2, 1);
    grid->setColumnMinimumWidth(2, widestControl());
}

const QWidget& HeaderBar::menuButton() const
{
    return *m_menu;
}

void HeaderBar::showStatus(const StationStatus& status)
{
    showState(status);
    showTarget(status);
    m_links.showStatus(status);
    showControl(status);
    showClock(status);
    m_simulated->setValue(status.simulated ? tr("SIMULATED") : QString(), Tone::Advisory);
}

void HeaderBar::showClock(const StationStatus& status)
{
    const bool isSet = status.clock.synchronised;
    m_utc->setValue(utcText(status), isSet ? Tone::Normal : Tone::Warning);
    m_clock->setValue(clockErrorText(status), isSet ? Tone::Secondary : Tone::Warning);
    for (ValueLabel* const line : {m_utc, m_clock}) {
        line->setToolTip(clockHelp(status));
    }
}

void HeaderBar::showState(const StationStatus& status)
{
    const Tone tone = stateTone(status);
    m_state->setValue(word(status.state), tone, stateSymbol(tone));
    // The action of the mount is shown beside it, and the alarm in its card: once each.
    const bool isShown = status.stateReason == status.targetText || isAlarmText(status);
    m_reason->setValue(isShown ? QString() : status.stateReason, Tone::Secondary);
    const bool latched = status.stopLatched;
    m_stopRequested = m_stopRequested && !latched;
    m_stop->setPhase(latched           ? StopButton::Phase::Latched
                     : m_stopRequested ? StopButton::Phase::Requested
                                       : StopButton::Phase::Ready);
}

void HeaderBar::showTarget(const StationStatus& status)
{
    m_limited->setVisible(status.limited);
    m_limited->setValue(status.limited ? tr("AT LIMIT") : QString(), Tone::Warning, Symbol::Warning);
    m_limited->setToolTip(tr("The target is outside the limits. The mount goes to the nearest permitted point.\n%1")
                              .arg(status.limitedReason));
    const QString planned = plannedText(status);
    m_target->setToolTip(planned.isEmpty() ? QString()
                                           : trackingText(*status.tracked, status.utc) + QLatin1Char('\n') + planned);
    const bool rests = status.state == StationState::Standby || status.state == StationState::Hold ||
                       status.state == StationState::Parked;
    if (status.schedule->armed && !status.tracked && rests) {
        m_target->setValue(armedText(*status.schedule, status.utc));
        return;
    }
    if (status.targetText.isEmpty()) {
        m_target->setValue(tr("no target"), Tone::Secondary);
        return;
    }
    const bool isPlanAhead = !planned.isEmpty() && isAhead(*status.tracked->plan, status.utc);
    const QString text = inTwoLines(doing(status));
    const QString withPlan = isPlanAhead ? withSecondLine(text, planned) : text;
    m_target->setValue(withPlan != text ? withPlan : withSecondLine(text, trackedRangeText(status)));
}

// As many parts as fit into two lines. The client in control is shown beside them.
QString HeaderBar::inTwoLines(QStringList parts) const
{
    const QString comma = QStringLiteral(", ");
    while (parts.size() > 1 && !isWhole(parts.join(comma))) {
        parts.removeLast();
    }
    return parts.join(comma);
}

bool HeaderBar::isWhole(const QString& text) const
{
    return m_target->heightWith(text, m_target->width()) <=
           m_target->heightWith(QStringLiteral("1\n2"), m_target->width());
}

// The second line, if both lines fit completely.
QString HeaderBar::withSecondLine(const QString& doing, const QString& second) const
{
    const QString both = doing + QLatin1Char('\n') + second;
    return !second.isEmpty() && isWhole(both) ? both : doing;
}

void HeaderBar::showControl(const StationStatus& status)
{
    const bool ours = status.authority == Authority::Operator;
    if (status.listening.isEmpty()) {
        m_control->setValue(notListening(m_control->width()), Tone::Warning, Symbol::Warning);
    } else {
        m_control->setValue(controlText(status, m_control->width()), ours ? Tone::Normal : Tone::Secondary);
    }
    m_control->setToolTip(controlHelp(status));
}

void HeaderBar::setOnlySimulated()
{
    m_simulated->setToolTip(tr("Boresight was started with --simulate. No mount is real until the program ends."));
}

void HeaderBar::setStopRequested()
{
    m_stopRequested = true;
    if (m_stop->phase() != StopButton::Phase::Latched) {
        m_stop->setPhase(StopButton::Phase::Requested);
    }
}

void HeaderBar::setStopRefused()
{
    m_stopRequested = false;
    if (m_stop->phase() == StopButton::Phase::Requested) {
        m_stop->setPhase(StopButton::Phase::Ready);
    }
}

}  // namespace boresight::ui

#include "moc_header_bar.cpp"
