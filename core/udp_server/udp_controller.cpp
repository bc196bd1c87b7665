// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/udp_server/udp_controller.h"

#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/rotctld/client_habits.h"
#include "core/rotctld/client_target.h"
#include "core/udp_server/pst_words.h"

#include <utility>

namespace boresight::udp {

using rotctld::LineOutcome;
using rotctld::Settling;

UdpController::UdpController(rotctld::Client client, const Shared& shared)
    : m_client(std::move(client)), m_shared(shared), m_budget(shared.clock.now())
{}

LineOutcome UdpController::obey(std::string_view datagram)
{
    LineOutcome outcome{.reply = {}, .result = {}};
    const Result<Command> command = read(datagram);
    if (command) {
        std::visit([&](const auto& wanted) { carryOut(wanted, outcome); }, *command);
    } else {
        outcome.result = tl::unexpected(command.error());
    }
    const bool isPlaceUnknown = command && std::holds_alternative<Target>(*command) && !outcome.point;
    if (!outcome.result && (!command || isPlaceUnknown)) {
        logRefusal(datagram, outcome.result.error());
    }
    return outcome;
}

// The program gets no answer, so the operator finds the reason only here. The rotator logs what it refuses itself.
void UdpController::logRefusal(std::string_view datagram, const Error& error) const
{
    if (error.code == ErrorCode::Busy && m_budget.isFlood()) {
        return;
    }
    m_shared.rotator.clientRemark(
        m_client, Text::tr("\"%1\" refused: %2").arg(rotctld::shownText(trimmed(datagram)), error.text));
}

Result<Command> UdpController::read(std::string_view datagram)
{
    Result<Command> command = m_shared.parse(datagram);
    if (datagram.size() > kLongest && !stops(command)) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("A datagram has at most %1 bytes.").arg(QString::number(kLongest)));
    }
    return command.and_then([&](const Command& wanted) { return admits(wanted).map([&] { return wanted; }); });
}

Result<> UdpController::admits(const Command& command)
{
    if (!moves(command)) {
        return {};
    }
    if (!m_shared.settling.isOver()) {
        return failure(ErrorCode::Refused, Text::tr("This computer slept or was blocked less than %1 s ago. The "
                                                    "command may be old. Send it again.")
                                               .arg(Settling::kTime.count()));
    }
    m_budget.count(m_shared.clock.now());
    return m_budget.admits();
}

void UdpController::carryOut(Ask question, LineOutcome& outcome)
{
    const Result<SkyPointing> place =
        question == Ask::TargetAzimuth ? m_shared.rotator.target() : m_shared.rotator.position(m_client);
    outcome.result = place.map([&](const SkyPointing& known) { outcome.reply = pstAnswer(question, known); });
}

void UdpController::carryOut(const Target& target, LineOutcome& outcome)
{
    const Result<SkyPointing> place = rotctld::completed(m_shared.rotator, target.azimuth, target.elevation);
    outcome.result = rotctld::pointTo(m_shared.rotator, m_client, place, outcome);
}

void UdpController::carryOut(const StopTurning& /*stop*/, LineOutcome& outcome)
{
    outcome.stop = true;
    outcome.result = m_shared.rotator.stop(m_client);
}

void UdpController::carryOut(const Park& /*park*/, LineOutcome& outcome)
{
    outcome.motion = true;
    outcome.result = m_shared.rotator.park(m_client);
}

void UdpController::carryOut(const Nothing& nothing, LineOutcome& outcome)
{
    outcome.became = nothing.why;
}

}  // namespace boresight::udp
