// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/axis_check.h"

#include "core/base/text.h"

#include <algorithm>
#include <utility>

namespace boresight::drive_check {
namespace {

// Another tool may have switched the channel to text.
const std::string kOriginFormat = std::string("tel fmt ") + moteus::kMotorPositionChannel + " 0";
const std::string kGetOrigin = std::string("tel get ") + moteus::kMotorPositionChannel;
constexpr int kMostSilences = 5;  // heartbeats without an answer, 0.1 s each

std::string getCommand(const Protection& protection)
{
    return "conf get " + protection.key;
}

Reading asReading(const ConsoleRun::Answer& answer)
{
    if (!answer || answer->empty()) {
        return {.state = Reading::State::Unknown};
    }
    return {.state = Reading::State::Read, .text = answer->front()};
}

}  // namespace

AxisCheck::AxisCheck(const profile::Profile& profile, Axis axis)
    : m_axis(axis), m_id(profile.axis(axis).id), m_protections(protectionsOf(profile, axis)), m_heartbeat(m_id)
{
    forget();
}

void AxisCheck::profileChanged(const profile::Profile& /*before*/, const profile::Profile& after)
{
    m_next = protectionsOf(after, m_axis);
    if (m_step != Step::Reading && m_step != Step::Setting && m_step != Step::Storing) {
        takeNext();
    }
}

void AxisCheck::takeNext()
{
    if (m_next) {
        m_protections.want(*std::exchange(m_next, std::nullopt));
    }
}

void AxisCheck::forget()
{
    m_protections.forget();
    m_origin = {};
    m_step = Step::Idle;
    m_run.reset();
    m_complete = false;
    m_trouble.clear();
}

void AxisCheck::read(const moteus::Uuid& board)
{
    m_board = board;
    m_trouble.clear();
    m_complete = false;
    m_run.reset();
    m_heartbeat.begin(board);
    m_step = Step::Uptime;
}

void AxisCheck::startReading()
{
    std::vector<std::string> commands{"tel stop"};
    std::ranges::transform(m_protections.wanted(), std::back_inserter(commands), getCommand);
    commands.insert(commands.end(), {kOriginFormat, kGetOrigin});
    m_run.emplace(m_id, std::move(commands));
    m_step = Step::Reading;
}

void AxisCheck::readOrigin()
{
    m_run.reset();
    m_heartbeat.begin(m_board);
    m_step = Step::OriginUptime;
}

void AxisCheck::startOrigin()
{
    m_run.emplace(m_id, std::vector<std::string>{"tel stop", kOriginFormat, kGetOrigin});
    m_step = Step::Origin;
}

bool AxisCheck::isFixable() const
{
    const bool unstored = !m_fixTrouble.isEmpty();
    return unstored || m_protections.isAnyFixable();
}

void AxisCheck::fix()
{
    m_written.clear();
    std::vector<std::string> sets{"tel stop"};
    std::vector<std::string> gets;
    for (qsizetype i = 0; i < lines().size(); ++i) {
        const Protection& protection = m_protections.wanted()[i];
        if (lines()[i].fix.isEmpty()) {
            continue;
        }
        m_written.push_back(i);
        sets.push_back("conf set " + protection.key + ' ' + settingText(*protection.remedy));
        gets.push_back(getCommand(protection));
    }
    sets.insert(sets.end(), gets.begin(), gets.end());
    m_run.emplace(m_id, std::move(sets));
    m_step = Step::Setting;
    m_complete = false;
    m_fixTrouble =
        Text::tr("writing the settings of %1 was interrupted: some are in force but not stored").arg(axisText(m_axis));
}

std::optional<CanFrame> AxisCheck::frame(SteadyTime now)
{
    if (m_step == Step::Uptime) {
        if (m_heartbeat.silences() > kMostSilences) {
            fail(Text::tr("it does not answer"));
            return std::nullopt;
        }
        return m_heartbeat.frame(now);
    }
    if (!m_run) {
        return m_complete ? m_heartbeat.frame(now) : std::nullopt;
    }
    if (m_run->current() != kGetOrigin) {
        m_notYetAsked = now;
    }
    std::optional<CanFrame> frame = m_run->frame(now);
    if (m_run->isFinished()) {
        finishRun();
    }
    return frame;
}

void AxisCheck::take(const moteus::Reply& reply)
{
    if (reply.source != m_id) {
        return;
    }
    const int reboots = m_heartbeat.reboots();
    m_heartbeat.take(reply);
    if (m_heartbeat.reboots() != reboots) {
        m_fixTrouble.clear();  // the reading then shows the stored values
    }
    if (m_step == Step::Uptime && m_heartbeat.isAnswered()) {
        startReading();
    } else if (m_step == Step::OriginUptime && m_heartbeat.isAnswered()) {
        startOrigin();
    } else if (m_run) {
        m_run->take(reply);
    }
}

void AxisCheck::finishRun()
{
    if (m_step == Step::Origin) {
        finishOrigin();
    } else if (!m_run->trouble().isEmpty()) {
        fail(m_run->trouble());
    } else if (m_step == Step::Reading) {
        finishReading();
    } else if (m_step == Step::Setting) {
        finishSetting();
    } else {
        finishStoring();
    }
}

void AxisCheck::fail(const QString& why)
{
    m_trouble = Text::tr("the check of %1 ended early: %2").arg(axisText(m_axis), why);
    m_run.reset();
    m_step = Step::Idle;
}

void AxisCheck::finishReading()
{
    const auto first = m_run->answers().begin() + 1;
    std::vector<Reading> readings;
    std::transform(first, first + std::ssize(m_protections.wanted()), std::back_inserter(readings), asReading);
    m_protections.take(std::move(readings));
    keepOrigin(m_run->answers().back());
    m_run.reset();
    m_step = Step::Idle;
    m_complete = true;
    m_changes.note(m_axis, m_board, m_protections, m_written);
    m_written.clear();
    takeNext();
}

// Compares the values that read back. The answer of the drive proves nothing: it reads garbage as 0 without an error.
void AxisCheck::finishSetting()
{
    const auto& answers = m_run->answers();
    const std::size_t firstGet = answers.size() - m_written.size();
    for (std::size_t i = 0; i < m_written.size(); ++i) {
        const Protection& protection = m_protections.wanted()[m_written[i]];
        const Reading reading = asReading(answers[firstGet + i]);
        if (!tookEffect(*protection.remedy, reading)) {
            m_fixTrouble =
                Text::tr("nothing was stored in %1, because %2 was set to %3 and reads back %4")
                    .arg(axisText(m_axis), QString::fromStdString(protection.key),
                         QString::fromStdString(settingText(*protection.remedy)), foundText(protection, reading));
            return startReading();
        }
    }
    m_run.emplace(m_id, std::vector<std::string>{"conf write"}, ConsoleRun::Patience::Storing);
    m_step = Step::Storing;
}

void AxisCheck::finishStoring()
{
    const ConsoleRun::Answer& answer = m_run->answers().front();
    m_fixTrouble =
        answer ? QString() : Text::tr("%1 did not store its settings: %2").arg(axisText(m_axis), answer.error().text);
    startReading();
}

// Without an answer the old reading stays. It is too old to prove anything, so it is asked for again.
void AxisCheck::finishOrigin()
{
    if (m_run->trouble().isEmpty()) {
        keepOrigin(m_run->answers().back());
    }
    m_run.reset();
    m_step = Step::Idle;
}

void AxisCheck::keepOrigin(const ConsoleRun::Answer& telemetry)
{
    m_origin = {.origin = telemetry && !telemetry->empty() ? moteus::countOrigin(telemetry->front()) : std::nullopt,
                .asked = m_notYetAsked};
}

QString AxisCheck::progress() const
{
    if (m_step == Step::Origin || m_step == Step::OriginUptime) {
        return {};  // too short to show
    }
    if (!m_run) {
        return m_step == Step::Idle ? QString() : Text::tr("asking %1").arg(axisText(m_axis));
    }
    const QString command = QString::fromStdString(m_run->current());
    const QString key = command.section(QLatin1Char(' '), 2, 2);
    const bool storing = m_step == Step::Storing;
    const bool setting = command.startsWith(QLatin1String("conf set"));
    const QString sentence = storing   ? Text::tr("storing %1 of %2")
                             : setting ? Text::tr("writing %1 of %2")
                                       : Text::tr("reading %1 of %2");
    return sentence.arg(key.isEmpty() ? Text::tr("the settings") : key, axisText(m_axis));
}

}  // namespace boresight::drive_check
