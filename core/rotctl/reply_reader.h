// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctl/rotctl_command.h"
#include "core/units/sky.h"

#include <optional>
#include <string_view>

// Reads the answer of a rotctld line by line. An answer is used completely or not at all: half a line is no number, and
// a line that does not belong to the answer makes the answer strange. Pure.
namespace boresight::rotctl {

enum class Question
{
    State,
    Position,
    Order,  // to go somewhere
    Stop,
    Reset
};

// The axes of the rotator, as rotctld reports them.
enum class RotatorType
{
    Unknown,
    AzEl,
    Az,
    El
};

struct RotatorState
{
    TravelRange azimuth;
    TravelRange elevation;
    RotatorType type = RotatorType::Unknown;

    bool operator==(const RotatorState&) const = default;
};

struct Reply
{
    int code = 0;  // negative: an error of Hamlib, and the answer has no values
    std::optional<RotatorState> state;
    std::optional<AxisPosition> position;

    bool operator==(const Reply&) const = default;
};

// "RPRT -5": the last line of an answer in the extended form, or a complete refusal.
[[nodiscard]] bool isReport(std::string_view line);

class ReplyReader
{
public:
    enum class Progress
    {
        More,
        Whole,
        Strange  // not an answer to this question; the rest is not read
    };

    ReplyReader(Question question, Form form) : m_question(question), m_form(form) {}

    // A line without its end, not empty.
    [[nodiscard]] Progress take(std::string_view line);
    // Valid after Progress::Whole.
    [[nodiscard]] const Reply& reply() const { return m_reply; }

private:
    static constexpr int kMostLines = 60;  // the most lines of one answer

    [[nodiscard]] Progress takeExtended(std::string_view line);
    [[nodiscard]] Progress takePlain(std::string_view line);
    [[nodiscard]] Progress takePlainState(std::string_view line);
    [[nodiscard]] Progress takeNumber(std::string_view line, int wanted);
    [[nodiscard]] bool takeValue(std::string_view line);
    [[nodiscard]] Progress end(int code);

    struct Numbers
    {
        std::optional<Angle> minAzimuth;
        std::optional<Angle> maxAzimuth;
        std::optional<Angle> minElevation;
        std::optional<Angle> maxElevation;
        std::optional<Angle> azimuth;
        std::optional<Angle> elevation;
        int version = 0;
        RotatorType type = RotatorType::Unknown;
    };

    Question m_question;
    Form m_form;
    Numbers m_numbers;
    Reply m_reply;
    int m_lines = 0;
};

}  // namespace boresight::rotctl
