// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/programs/program_runner.h"
#include "core/transmit_output/transmit_output.h"

#include <QStringList>

#include <memory>
#include <optional>

// A program of the operator that is run with "on" or "off" after its arguments. "Off" never waits for an "on" that
// still runs. What ran meanwhile may have had the last word, so "off" is run again after it.
namespace boresight::transmit {

class CommandOutput final : public TransmitOutput
{
    Q_OBJECT

public:
    // Not for long: the transmitter waits for it.
    static constexpr programs::Limits kLimits{
        .longest = std::chrono::seconds(2), .patience = std::chrono::seconds(2), .most = 1};

    CommandOutput(const QString& program, const QStringList& arguments, const programs::Limits& limits = kLimits,
                  QObject* parent = nullptr);
    // What runs has kLimits.patience to end.
    ~CommandOutput() override;

    void set(bool on) override;
    [[nodiscard]] bool isIdle() const override { return !m_on.runs && !m_off.runs; }

private:
    // One for "on" and one for "off".
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
    std::optional<bool> m_reached;  // by the last program that ended well; empty: nobody knows
};

}  // namespace boresight::transmit
