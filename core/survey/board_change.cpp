// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/survey/board_change.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/moteus/describe.h"
#include "core/survey/protections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight::survey {
namespace {

// A gear of 150:1 is 0.006666667. The drive itself writes six digits.
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

QString notStored(const QString& why)
{
    return Text::tr("%1 Nothing was stored. Switch the board off and on, then it has its old settings again.").arg(why);
}

}  // namespace

BoardChange::BoardChange() : m_scan(moteus::kDiagnosticHostId, {moteus::versionQuery()}) {}

void BoardChange::begin(const BoardOrder& order, SteadyTime now)
{
    m_order = order;
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
        const std::string set = "conf set " + m_order.key + ' ' + changeText(m_order.value);
        // The first command is one whose answer is sure to come: what follows reaches the console.
        return run(Step::Setting, m_order.id, {"tel stop", set});
    }
    if (const Result<> changed = isChanged(); !changed) {
        return end(changed);
    }
    run(Step::ReadingBack, m_order.newId, {"tel stop", "conf get " + m_order.key});
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
        return refused(Text::tr("No board answers under the id %1. Nothing was changed.").arg(m_order.id));
    }
    if (board->known.uuid() != m_order.board) {
        return refused(Text::tr("Another board is connected than the one you confirmed: %1. Nothing was changed.")
                           .arg(boardText(board->known.uuid())));
    }
    if (m_order.alone && there.size() > 1) {
        return refused(
            Text::tr("Another board is connected too. Leave only the one that shall be changed. Nothing was "
                     "changed."));
    }
    return {};
}

Result<> BoardChange::isChanged() const
{
    const FoundController* const board = boardAt(m_order.newId);
    if (board == nullptr || board->known.uuid() != m_order.board) {
        return refused(notStored(Text::tr("The board does not answer under the id %1.").arg(m_order.newId)));
    }
    const auto& there = m_scan.controllers();
    if (std::ranges::count(there, m_order.newId, &FoundController::id) > 1 || (m_order.alone && there.size() > 1)) {
        return refused(notStored(Text::tr("Another board was connected meanwhile.")));
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
    const auto& answers = m_run->answers();
    if (m_step == Step::Setting) {
        if (answers.empty()) {
            return end(refused(Text::tr("%1 Nothing was changed.").arg(m_run->trouble())));
        }
        if (answers.size() > 1 && !answers[1]) {
            return end(refused(Text::tr("%1. Nothing was changed.").arg(answers[1].error().text)));
        }
        return look(Step::LookingAgain, now);  // silence after a new id is as it should be
    }
    if (!m_run->trouble().isEmpty() || !answers.back()) {
        const QString why = m_run->trouble().isEmpty() ? answers.back().error().text : m_run->trouble();
        return end(refused(notStored(Text::tr("%1.").arg(why))));
    }
    if (m_step == Step::ReadingBack) {
        const Reading reading{.state = Reading::State::Read,
                              .text = answers.back()->empty() ? std::string() : answers.back()->front()};
        if (!tookEffect(m_order.value, reading)) {
            return end(refused(notStored(
                Text::tr("The board was set to %1 and reads back %2.")
                    .arg(QString::fromStdString(changeText(m_order.value)), QString::fromStdString(reading.text)))));
        }
        return run(Step::Storing, m_order.newId, {"conf write"});
    }
    end({});
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
            return Text::tr("Looking which boards are connected.");
        case Step::Setting:
            return Text::tr("Setting %1.").arg(m_order.what);
        case Step::LookingAgain:
            return Text::tr("Looking whether the same board answers.");
        case Step::ReadingBack:
            return Text::tr("Reading back %1.").arg(m_order.what);
        case Step::Storing:
            return Text::tr("Storing %1.").arg(m_order.what);
        case Step::Idle:
            break;
    }
    return {};
}

}  // namespace boresight::survey
