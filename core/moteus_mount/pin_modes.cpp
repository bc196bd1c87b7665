// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/pin_modes.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/moteus/codec.h"
#include "core/moteus/diagnostic.h"

#include <algorithm>

namespace boresight {
namespace {

constexpr std::chrono::seconds kNextReading{10};

QString keyOf(const contacts::BoardPin& pin)
{
    return QStringLiteral("aux%1.pins.%2.mode").arg(pin.port).arg(pin.number);
}

}  // namespace

void PinModes::take(const CanFrame& frame)
{
    const auto reply = moteus::decodeReply(frame);
    if (!reply || reply->prefix != 0 || reply->destination != moteus::kDiagnosticHostId) {
        return;
    }
    if (const auto found = m_boards.find(reply->source); found != m_boards.end() && found->second.run) {
        found->second.run->take(*reply);
    }
}

void PinModes::begin(Board& board)
{
    std::vector<std::string> commands{"tel stop"};
    for (const contacts::BoardPin& pin : board.asked) {
        commands.push_back("conf get " + keyOf(pin).toStdString());
    }
    board.run.emplace(board.asked.front().board, std::move(commands));
}

// A firmware without this key refuses the question, so the mode stays unknown.
void PinModes::finish(Board& board, SteadyTime now)
{
    const auto& answers = board.run->answers();
    for (std::size_t i = 0; i < board.asked.size() && i + 1 < answers.size(); ++i) {
        const auto& lines = answers[i + 1];  // after that of "tel stop"
        const auto mode = lines && !lines->empty() ? parseInteger(lines->front()) : std::nullopt;
        board.modes[i] = mode ? std::optional(static_cast<int>(*mode)) : std::nullopt;
    }
    board.run.reset();
    board.nextTry = now + kNextReading;
}

std::vector<CanFrame> PinModes::frames(const std::vector<contacts::BoardPin>& pins,
                                       const std::function<bool(int board)>& mayAsk, SteadyTime now)
{
    std::map<int, std::vector<contacts::BoardPin>> named;
    for (const contacts::BoardPin& pin : pins) {
        named[pin.board].push_back(pin);
    }
    std::erase_if(m_boards, [&](const auto& one) { return !named.contains(one.first); });
    std::vector<CanFrame> frames;
    for (const auto& [id, wanted] : named) {
        Board& board = m_boards[id];
        if (board.asked != wanted) {
            board = {.asked = wanted, .modes = std::vector<std::optional<int>>(wanted.size())};
        }
        if (!mayAsk(id)) {
            board.run.reset();
            continue;
        }
        const bool isKnown = std::ranges::all_of(board.modes, [](const auto& mode) { return mode.has_value(); });
        if (!board.run && !isKnown && now >= board.nextTry) {
            begin(board);
        }
        if (!board.run) {
            continue;
        }
        if (const auto frame = board.run->frame(now)) {
            frames.push_back(*frame);
        }
        if (board.run->isFinished()) {
            finish(board, now);
        }
    }
    return frames;
}

QString PinModes::problem(const contacts::BoardPin& pin) const
{
    const auto found = m_boards.find(pin.board);
    if (found == m_boards.end()) {
        return {};
    }
    const Board& board = found->second;
    const auto at = std::ranges::find(board.asked, pin);
    const auto mode =
        at == board.asked.end() ? std::nullopt : board.modes[static_cast<std::size_t>(at - board.asked.begin())];
    if (!mode || *mode == kDigitalInput) {
        return {};
    }
    return Text::tr("The pin is no input: %1 of board %2 is %3. Set it to %4 with moteus tview and store it")
        .arg(keyOf(pin))
        .arg(pin.board)
        .arg(*mode)
        .arg(kDigitalInput);
}

}  // namespace boresight
