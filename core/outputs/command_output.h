// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/outputs/output.h"
#include "core/programs/program_runner.h"

#include <QStringList>

#include <memory>
#include <optional>

// Runs a program of the operator, with "on" or "off" as its last argument. The "off" run does not wait for an "on" run
// that is still going. That "on" run may take effect last, so "off" is run once more after both have ended.
namespace boresight::outputs {

class CommandOutput final : public Output
{
    Q_OBJECT

public:
    // The limits are short, because the transmitter waits for the program.
    static constexpr programs::Limits kLimits{
        .longest = std::chrono::seconds(2), .patience = std::chrono::seconds(2), .most = 1};

    CommandOutput(const QString& program, const QStringList& arguments, const programs::Limits& limits = kLimits,
                  QObject* parent = nullptr);
    // Waits at most limits.patience for a program that is still running.
    ~CommandOutput() override;

    void set(bool on) override;
    [[nodiscard]] bool isIdle() const override { return !m_on.runs && !m_off.runs; }

private:
    // There is one side for "on" and one for "off".
    struct Side
    {
        std::unique_ptr<programs::ProgramRunner> runner;
        bool runs = false;
    };

    [[nodiscard]] Side makeSide(bool on);
    void start(bool on);
    void step();
    void finish(bool on, const programs::Ending& ending);

    QString m_program;
    QStringList m_arguments;
    programs::Limits m_limits;
    Side m_on;
    Side m_off;
    bool m_wanted = false;
    bool m_onEndedWithin = false;   // an "on" run ended during the "off" run that is still going
    std::optional<bool> m_reached;  // the state set by the last program that succeeded; empty: unknown
};

}  // namespace boresight::outputs
