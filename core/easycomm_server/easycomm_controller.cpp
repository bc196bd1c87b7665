// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/easycomm_server/easycomm_controller.h"

#include "core/base/text.h"
#include "core/base/version.h"
#include "core/rotctld/client_target.h"

#include <utility>

namespace boresight::easycomm {
namespace {

constexpr int kSpeedOfTheLevel = -1;

}  // namespace

EasycommController::EasycommController(rotctld::Client client, rotctld::Rotator& rotator, Version version)
    : m_client(std::move(client)), m_rotator(rotator), m_version(version)
{}

rotctld::LineOutcome EasycommController::obey(std::string_view line)
{
    rotctld::LineOutcome outcome{.reply = {}, .result = {}};
    const auto commands = parseLine(line, m_version);
    if (!commands) {
        outcome.result = tl::unexpected(commands.error());
        if (hasStop(line)) {  // a stop counts even if the rest of the line is refused
            (void)carryOut(StopTurning{}, outcome);
        }
        outcome.reply = m_version == Version::One ? std::string() : alarmOf(commands.error()).append(kLineEnd);
        return outcome;
    }
    std::string alarm;
    for (const Command& command : *commands) {
        const auto answer = std::visit([&](const auto& wanted) { return carryOut(wanted, outcome); }, command);
        if (!answer) {
            outcome.result = outcome.result ? tl::unexpected(answer.error()) : outcome.result;
            alarm = alarm.empty() ? alarmFor(answer.error(), std::holds_alternative<Ask>(command)) : alarm;
        } else if (!answer->empty()) {
            outcome.reply.append(outcome.reply.empty() ? "" : " ").append(*answer);
        }
    }
    for (std::string* const part : {&alarm, &outcome.reply}) {
        part->append(part->empty() ? std::string_view() : kLineEnd);
    }
    outcome.reply.insert(0, alarm);
    return outcome;
}

// A client that asks reads the answer. A client that commands may never read, so the same refusal in a row is sent
// once.
std::string EasycommController::alarmFor(const Error& error, bool asked)
{
    const bool known = !asked && (m_version == Version::One || std::exchange(m_reported, error.code) == error.code);
    return known ? std::string() : alarmOf(error);
}

Result<std::string> EasycommController::carryOut(Ask question, rotctld::LineOutcome& /*outcome*/)
{
    switch (question) {
        case Ask::Azimuth:
            return m_rotator.position(m_client).map([](const SkyPointing& now) { return azimuthAnswer(now.azimuth); });
        case Ask::Elevation:
            return m_rotator.position(m_client).map(
                [](const SkyPointing& now) { return elevationAnswer(now.elevation); });
        case Ask::Version:
            return "VEBoresight-" + std::string(kVersion);
        case Ask::Status:
            return status();
        case Ask::Errors:
            break;
    }
    return std::string(m_rotator.position(m_client) ? kNoErrors : kSensorError);
}

std::string EasycommController::status()
{
    const rotctld::MotionFlags now = m_rotator.motion();
    const bool moving = now.movingLeft || now.movingRight || now.movingUp || now.movingDown;
    return std::string(!m_rotator.position(m_client) ? kInError : moving ? kMoving : kIdle);
}

Result<std::string> EasycommController::carryOut(const Target& target, rotctld::LineOutcome& outcome)
{
    const Result<SkyPointing> place = rotctld::completed(m_rotator, target.azimuth, target.elevation);
    return done(rotctld::pointTo(m_rotator, m_client, place, outcome));
}

Result<std::string> EasycommController::carryOut(const Turn& turn, rotctld::LineOutcome& outcome)
{
    outcome.motion = true;
    if (turn.rate == AngularRate{}) {  // some programs turn by rates and also send zero while nothing turns
        return std::exchange(m_turns, false) ? done(m_rotator.stop(m_client)) : std::string();
    }
    m_turns = true;
    if (!turn.rate) {
        return done(m_rotator.move(m_client, turn.direction, kSpeedOfTheLevel));
    }
    const Result<QString> turned = m_rotator.moveAt(m_client, turn.direction, *turn.rate);
    outcome.became = turned.value_or(QString());
    return done(turned.map([](const QString&) {}));
}

Result<std::string> EasycommController::carryOut(const StopTurning&, rotctld::LineOutcome& outcome)
{
    outcome.stop = true;
    m_turns = false;
    return done(m_rotator.stop(m_client));
}

Result<std::string> EasycommController::carryOut(const Park&, rotctld::LineOutcome& outcome)
{
    outcome.motion = true;
    return done(m_rotator.park(m_client));
}

// A real controller moves to its home position and is then ready again. Here a reset only re-arms.
Result<std::string> EasycommController::carryOut(const Reset&, rotctld::LineOutcome& /*outcome*/)
{
    return done(m_rotator.reset(m_client, 1));
}

Result<std::string> EasycommController::done(const Result<>& outcome)
{
    return outcome.map([&] {
        m_reported.reset();
        return std::string();
    });
}

Result<std::string> EasycommController::carryOut(const NotForARotator&, rotctld::LineOutcome& outcome)
{
    if (outcome.became.isEmpty() && !outcome.motion) {
        outcome.became = Text::tr("the line has no command for a rotator");
    }
    return std::string();
}

rotctld::StartConversation talkEasycomm(rotctld::Rotator& rotator, const Clock& clock, Version version)
{
    return [&rotator, &clock, version](rotctld::Client client) -> std::unique_ptr<rotctld::Conversation> {
        auto controller = std::make_unique<EasycommController>(client, rotator, version);
        return std::make_unique<rotctld::LineSession>(std::move(client), std::move(controller), rotator, clock);
    };
}

}  // namespace boresight::easycomm
