// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/outputs/output.h"

#include <string>
#include <vector>

namespace boresight::fakes {

// An output that the test controls: it answers when the test says so, and writes down what it is told.
class PlayedOutput final : public outputs::Output
{
public:
    explicit PlayedOutput(std::vector<std::string>& calls) : m_calls(calls) {}
    ~PlayedOutput() override { m_calls.emplace_back("gone"); }
    PlayedOutput(const PlayedOutput&) = delete;
    PlayedOutput& operator=(const PlayedOutput&) = delete;

    void set(bool on) override
    {
        m_calls.emplace_back(on ? "on" : "off");
        if (answers && !trouble.isEmpty()) {
            Q_EMIT failed(trouble);
        } else if (answers) {
            Q_EMIT reached(on);
        }
    }

    [[nodiscard]] bool isIdle() const override { return idle; }

    bool answers = true;
    bool idle = true;
    QString trouble;

private:
    std::vector<std::string>& m_calls;
};

}  // namespace boresight::fakes
