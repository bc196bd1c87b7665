// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/console_run.h"

#include <utility>

namespace boresight::drive_check {
namespace {

using namespace std::chrono_literals;

constexpr auto kReplyTime = 50ms;
constexpr int kConsoleRunMaxTries = 3;
// Polls without text, one per tick. The command itself is not acknowledged, so its loss is detected by these polls.
constexpr int kEmptyWhenReading = 8;
constexpr int kEmptyWhenStoring = 100;

constexpr const char* kStopTelemetry = "tel stop";

moteus::DiagnosticClient::Settings clientSettings(int drive, ConsoleRun::Patience patience)
{
    return {.destination = static_cast<std::uint8_t>(drive),
            .maxEmptyAnswers = patience == ConsoleRun::Patience::Storing ? kEmptyWhenStoring : kEmptyWhenReading};
}

}  // namespace

ConsoleRun::ConsoleRun(int drive, std::vector<std::string> commands, Patience patience)
    : m_commands(std::move(commands)), m_client(clientSettings(drive, patience))
{}

std::string ConsoleRun::current() const
{
    return m_answers.size() < m_commands.size() ? m_commands[m_answers.size()] : std::string();
}

std::optional<CanFrame> ConsoleRun::frame(SteadyTime now)
{
    if (m_client.isBusy() && now - m_sent >= kReplyTime) {
        m_client.handleSilence();
    }
    if (m_client.isFinished()) {
        collect();
    }
    if (isFinished()) {
        return std::nullopt;
    }
    if (!m_client.isBusy()) {
        ++m_tries;
        if (const Result<> started = m_client.start(current()); !started) {
            m_trouble = started.error().text;
            return std::nullopt;
        }
    }
    std::optional<CanFrame> frame = m_client.nextFrame();
    if (frame) {
        m_sent = now;
    }
    return frame;
}

// Keeps an answer. After silence or confusion the command is sent again. An unfinished line of another program may be
// in front of ours. No drive refuses the first command, so a refusal of it counts as confusion.
void ConsoleRun::collect()
{
    Answer answer = m_client.takeAnswer();
    const bool refused = !answer && answer.error().code == ErrorCode::Refused;
    const bool confused = refused && current() == kStopTelemetry;
    if (answer || (refused && !confused)) {
        m_answers.push_back(std::move(answer));
        m_tries = 0;
    } else if (m_tries >= kConsoleRunMaxTries) {
        m_trouble = answer.error().text;
    }
}

}  // namespace boresight::drive_check
