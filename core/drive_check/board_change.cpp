// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/board_change.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/drive_check/protections.h"
#include "core/moteus/describe.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight::drive_check {
namespace {

// A gear of 150:1 is 0.006666667, so six digits after the point, as the drive writes them, are too few.
std::string changeText(double value)
{
    return formatFixed(value, value == std::round(value) ? 0 : 9);
}

QString boardText(const std::optional<moteus::Uuid>& uuid)
{
    return uuid ? QString::fromStdString(moteus::uuidText(*uuid)) : Text::tr("UUID unread");
}

Result<> refused(const QString& why)
{
    return failure(ErrorCode::Refused, why);
}

// The console answers with one line, or with none if the firmware has no such setting.
Reading readingOf(const ConsoleRun::Answer& answer)
{
    const bool has = answer && !answer->empty();
    return {.state = has ? Reading::State::Read : Reading::State::Unknown,
            .text = has ? answer->front() : std::string()};
}

QString notStored(const QString& why)
{
    return Text::tr("%1 Nothing was stored. Switch the board off and on to restore its old settings.").arg(why);
}

}  // namespace

BoardChange::BoardChange() : m_scan(moteus::kDiagnosticHostId, {moteus::versionQuery()}) {}

void BoardChange::begin(const BoardOrder& order, SteadyTime now)
{
    m_order = order;
    m_settings = {{order.key, order.value}};
    m_outcome.reset();
    look(Step::Looking, now);
}

void BoardChange::look(Step step, SteadyTime now)
{
    m_run.reset();
    m_scan.begin(now);
    m_step = step;
}

void BoardChange::run(Step step, int id, std::vector<std::string> commands)
{
    m_run.emplace(id, std::move(commands),
                  step == Step::Storing ? ConsoleRun::Patience::Storing : ConsoleRun::Patience::Reading);
    m_step = step;
}

std::vector<CanFrame> BoardChange::frames(SteadyTime now)
{
    if (m_step == Step::Idle) {
        return {};
    }
    if (!m_run) {
        std::vector<CanFrame> frames = m_scan.frames(now);
        if (!m_scan.isRunning()) {
            finishLook();
        }
        return frames;
    }
    const std::optional<CanFrame> frame = m_run->frame(now);
    if (m_run->isFinished()) {
        finishRun(now);
    }
    return frame ? std::vector{*frame} : std::vector<CanFrame>{};
}

void BoardChange::take(const moteus::Reply& reply)
{
    if (m_run) {
        m_run->take(reply);
    } else if (m_step != Step::Idle) {
        m_scan.take(reply);
    }
}

void BoardChange::finishLook()
{
    if (m_step == Step::Looking) {
        if (const Result<> may = mayChange(); !may) {
            return end(may);
        }
        return m_order.scaled.empty() ? set() : read(Step::Reading, m_order.id, m_order.scaled);
    }
    if (const Result<> changed = isChanged(); !changed) {
        return end(changed);
    }
    read(Step::ReadingBack, m_order.newId, m_settings);
}

// Each run begins with a command that every board answers. The answer proves that the console works.
void BoardChange::read(Step step, int id, const std::vector<BoardSetting>& settings)
{
    std::vector<std::string> commands{"tel stop"};
    for (const BoardSetting& one : settings) {
        commands.push_back("conf get " + one.key);
    }
    run(step, id, std::move(commands));
}

void BoardChange::set()
{
    std::vector<std::string> commands{"tel stop"};
    for (const BoardSetting& one : m_settings) {
        commands.push_back("conf set " + one.key + ' ' + changeText(one.value));
    }
    run(Step::Setting, m_order.id, std::move(commands));
}

Result<> BoardChange::mayChange() const
{
    const auto& there = m_scan.controllers();
    const auto sharing = [&](int id) { return std::ranges::count(there, id, &FoundController::id) > 1; };
    const auto unclear =
        std::ranges::find_if(there, [&](const FoundController& one) { return one.isUnreadable() || sharing(one.id); });
    if (unclear != there.end() && (m_order.alone || unclear->id == m_order.id)) {
        return refused(Text::tr("Two boards with the id %1 are still connected. Disconnect one of them. Nothing was "
                                "changed.")
                           .arg(unclear->id));
    }
    const FoundController* const board = boardAt(m_order.id);
    if (board == nullptr) {
        return refused(Text::tr("No board with the id %1 answers. Nothing was changed.").arg(m_order.id));
    }
    if (board->known.uuid() != m_order.board) {
        return refused(Text::tr("The connected board %1 is not the board that you confirmed. Nothing was changed.")
                           .arg(boardText(board->known.uuid())));
    }
    if (m_order.alone && there.size() > 1) {
        return refused(
            Text::tr("More than one board is connected. Leave only the board to change. Nothing was changed."));
    }
    return {};
}

Result<> BoardChange::isChanged() const
{
    const FoundController* const board = boardAt(m_order.newId);
    if (board == nullptr || board->known.uuid() != m_order.board) {
        return refused(notStored(Text::tr("The board does not answer with the id %1.").arg(m_order.newId)));
    }
    const auto& there = m_scan.controllers();
    if (std::ranges::count(there, m_order.newId, &FoundController::id) > 1 || (m_order.alone && there.size() > 1)) {
        return refused(notStored(Text::tr("Another board appeared on the bus.")));
    }
    return {};
}

const FoundController* BoardChange::boardAt(int id) const
{
    const auto found = std::ranges::find(m_scan.controllers(), id, &FoundController::id);
    return found != m_scan.controllers().end() && !found->isUnreadable() ? &*found : nullptr;
}

void BoardChange::finishRun(SteadyTime now)
{
    switch (m_step) {
        case Step::Reading:
            return finishReading();
        case Step::Setting:
            return finishSetting(now);
        case Step::ReadingBack:
            return finishReadingBack();
        default:
            break;
    }
    const QString why = troubleOfRun();
    end(why.isEmpty() ? Result<>{}
                      : refused(Text::tr("%1. The new settings are in force. It is unknown whether the board stored "
                                         "them. Switch it off and on, then check again.")
                                    .arg(why)));
}

QString BoardChange::troubleOfRun() const
{
    const auto& answers = m_run->answers();
    const auto bad = std::ranges::find_if(answers, [](const ConsoleRun::Answer& answer) { return !answer; });
    return !m_run->trouble().isEmpty() ? m_run->trouble() : bad != answers.end() ? bad->error().text : QString();
}

void BoardChange::finishReading()
{
    if (!m_run->trouble().isEmpty()) {
        return end(refused(Text::tr("%1. Nothing was changed.").arg(m_run->trouble())));
    }
    for (std::size_t i = 0; i < m_order.scaled.size(); ++i) {
        const BoardSetting& scaled = m_order.scaled[i];
        const auto present = readingOf(m_run->answers()[1 + i]).value();
        if (present && std::isfinite(*present)) {
            m_settings.push_back({scaled.key, *present * scaled.value});
        } else if (!scaled.optional) {
            return end(
                refused(Text::tr("%1 cannot be read. Nothing was changed.").arg(QString::fromStdString(scaled.key))));
        }
    }
    set();
}

void BoardChange::finishSetting(SteadyTime now)
{
    const auto& answers = m_run->answers();
    if (answers.empty()) {
        return end(refused(Text::tr("%1. Nothing was changed.").arg(m_run->trouble())));
    }
    if (answers.size() > 1 && !answers[1]) {
        return end(refused(Text::tr("%1. Nothing was changed.").arg(answers[1].error().text)));
    }
    look(Step::LookingAgain, now);  // after a new id, silence is the expected answer
}

void BoardChange::finishReadingBack()
{
    if (const QString why = troubleOfRun(); !why.isEmpty()) {
        return end(refused(notStored(Text::tr("%1.").arg(why))));
    }
    for (std::size_t i = 0; i < m_settings.size(); ++i) {
        const Reading reading = readingOf(m_run->answers()[1 + i]);
        if (!tookEffect(m_settings[i].value, reading)) {
            return end(refused(notStored(Text::tr("%1 was set to %2 and reads back %3.")
                                             .arg(QString::fromStdString(m_settings[i].key),
                                                  QString::fromStdString(changeText(m_settings[i].value)),
                                                  QString::fromStdString(reading.text)))));
        }
    }
    run(Step::Storing, m_order.newId, {"tel stop", "conf write"});
}

void BoardChange::end(Result<> outcome)
{
    m_run.reset();
    m_step = Step::Idle;
    m_outcome = std::move(outcome);
}

QString BoardChange::progress() const
{
    switch (m_step) {
        case Step::Looking:
            return Text::tr("Listing the connected boards.");
        case Step::Reading:
            return Text::tr("Reading the settings that depend on %1.").arg(m_order.what);
        case Step::Setting:
            return Text::tr("Setting %1.").arg(m_order.what);
        case Step::LookingAgain:
            return Text::tr("Checking that the same board answers.");
        case Step::ReadingBack:
            return Text::tr("Reading back %1.").arg(m_order.what);
        case Step::Storing:
            return Text::tr("Storing %1.").arg(m_order.what);
        case Step::Idle:
            break;
    }
    return {};
}

}  // namespace boresight::drive_check
