// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_server/emulated_box.h"

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

// The station always points both axes.
void EmulatedBox::carryOut(const PointTo& place, rotctld::LineOutcome& outcome)
{
    outcome.motion = true;
    if (place.elevation) {
        m_kept.reset();
    }
    const Result<Angle> elevation = place.elevation ? Result<Angle>(*place.elevation) : keptElevation();
    outcome.result = elevation
                         .and_then([&](Angle wanted) {
                             const Angle azimuth = m_rotator.limits().turned(place.azimuth);
                             outcome.point = SkyPointing{.azimuth = azimuth, .elevation = wanted};
                             return m_rotator.pointTo(m_client, {.azimuth = azimuth, .elevation = wanted});
                         })
                         .map([&](const QString& became) { outcome.became = became; });
}

// The elevation at the first M. A mount that is a little off its target would creep if each M used the present
// elevation.
Result<Angle> EmulatedBox::keptElevation()
{
    constexpr Angle kBeside = Angle::fromDegrees(1.5);
    return m_rotator.position(m_client).map([&](const SkyPointing& now) {
        if (!m_kept || abs(*m_kept - now.elevation) > kBeside) {
            m_kept = m_rotator.limits().nearest(now).elevation;
        }
        return *m_kept;
    });
}

void EmulatedBox::carryOut(const Turn& turn, rotctld::LineOutcome& outcome)
{
    m_kept.reset();
    outcome.motion = true;
    outcome.result = m_rotator.move(m_client, turn.direction, kSpeedOfTheLevel);
}

void EmulatedBox::carryOut(const StopTurning&, rotctld::LineOutcome& outcome)
{
    m_kept.reset();
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
