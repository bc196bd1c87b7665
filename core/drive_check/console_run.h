// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/moteus/diagnostic.h"

#include <optional>
#include <string>
#include <vector>

// A list of console commands for one drive, each repeated until it is answered. Lost frames are repeated. A drive that
// stays silent ends the run. At most one frame per call, so a run never loads the bus. Pure.
namespace boresight::drive_check {

class ConsoleRun
{
public:
    enum class Patience
    {
        Reading,  // an answer comes within milliseconds
        Storing,  // `conf write` erases and writes flash
    };
    using Answer = Result<moteus::DiagnosticClient::Lines>;  // Refused: the drive answered ERR

    ConsoleRun(int drive, std::vector<std::string> commands, Patience patience = Patience::Reading);

    [[nodiscard]] std::optional<CanFrame> frame(SteadyTime now);
    void take(const moteus::Reply& reply) { m_client.handleReply(reply); }

    [[nodiscard]] bool isFinished() const { return m_answers.size() == m_commands.size() || !m_trouble.isEmpty(); }
    [[nodiscard]] const QString& trouble() const { return m_trouble; }              // why the run ended early
    [[nodiscard]] const std::vector<Answer>& answers() const { return m_answers; }  // in the order of the commands
    [[nodiscard]] std::string current() const;                                      // the command in progress

private:
    void collect();

    std::vector<std::string> m_commands;
    moteus::DiagnosticClient m_client;
    std::vector<Answer> m_answers;
    QString m_trouble;
    SteadyTime m_sent{};
    int m_tries = 0;
};

}  // namespace boresight::drive_check
