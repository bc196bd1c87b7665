// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_server/emulated_box.h"

#include "core/rotctld/client_target.h"

#include <utility>

namespace boresight::gs232 {
namespace {

constexpr int kSpeedOfTheLevel = -1;

}  // namespace

EmulatedBox::EmulatedBox(rotctld::Client client, rotctld::Rotator& rotator, Dialect dialect)
    : m_client(std::move(client)), m_rotator(rotator), m_dialect(dialect)
{}

rotctld::LineOutcome EmulatedBox::obey(std::string_view line)
{
    rotctld::LineOutcome outcome{.reply = std::string(kAccepted), .result = {}};
    if (const auto command = parseCommand(line)) {
        std::visit([&](const auto& wanted) { carryOut(wanted, outcome); }, *command);
    } else {
        outcome.result = tl::unexpected(command.error());
    }
    if (!outcome.result) {
        outcome.reply = kRefusal;
    }
    return outcome;
}

void EmulatedBox::carryOut(Ask question, rotctld::LineOutcome& outcome)
{
    outcome.result = m_rotator.position(m_client)
                         .and_then([&](const SkyPointing& place) { return answerTo(question, place, m_dialect); })
                         .map([&](const std::string& answer) { outcome.reply = answer; });
}

void EmulatedBox::carryOut(const PointTo& place, rotctld::LineOutcome& outcome)
{
    const Result<SkyPointing> target = rotctld::completed(m_rotator, place.azimuth, place.elevation);
    outcome.result = rotctld::pointTo(m_rotator, m_client, target, outcome);
}

void EmulatedBox::carryOut(const Turn& turn, rotctld::LineOutcome& outcome)
{
    outcome.motion = true;
    outcome.result = m_rotator.move(m_client, turn.direction, kSpeedOfTheLevel);
}

void EmulatedBox::carryOut(const StopTurning&, rotctld::LineOutcome& outcome)
{
    outcome.stop = true;
    outcome.result = m_rotator.stop(m_client);
}

void EmulatedBox::carryOut(const Speed& speed, rotctld::LineOutcome& outcome)
{
    outcome.result = m_rotator.setSpeedLevel(m_client, speed.level);
}

rotctld::StartConversation talkGs232(rotctld::Rotator& rotator, const Clock& clock, Dialect dialect)
{
    return [&rotator, &clock, dialect](rotctld::Client client) -> std::unique_ptr<rotctld::Conversation> {
        auto box = std::make_unique<EmulatedBox>(client, rotator, dialect);
        return std::make_unique<rotctld::LineSession>(std::move(client), std::move(box), rotator, clock);
    };
}

}  // namespace boresight::gs232
