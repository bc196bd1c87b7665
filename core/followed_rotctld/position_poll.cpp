// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/followed_rotctld/position_poll.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/rotctl/rotctl_command.h"
#include "core/rotctl/rotctl_error.h"

#include <utility>

namespace boresight::rotctl {
namespace {

constexpr std::size_t kShownOfLine = 24;  // bytes

}  // namespace

void PositionPoll::restart()
{
    *this = PositionPoll();
}

std::string PositionPoll::ask(SteadyTime now)
{
    if (m_reader || (m_started && now - m_asked < kPeriod)) {
        return {};
    }
    m_reader.emplace(Question::Position, Form::Plain);
    m_asked = now;
    m_started = true;
    return askPosition(Form::Plain);
}

void PositionPoll::take(std::string_view bytes)
{
    m_splitter.add(bytes, [this](std::string_view line) { takeLine(line); });
}

// A line without a question is ignored: some imitations end each answer with an additional line.
void PositionPoll::takeLine(std::string_view line)
{
    if (!m_reader) {
        return;
    }
    switch (m_reader->take(line)) {
        case ReplyReader::Progress::More:
            return;
        case ReplyReader::Progress::Whole:
            if (const Reply& reply = m_reader->reply(); reply.position) {
                m_answer = *reply.position;
            } else {
                m_answer = failure(ErrorCode::NoAnswer, errorInWords(reply.code));
            }
            break;
        case ReplyReader::Progress::Strange:
            m_answer =
                failure(ErrorCode::Refused, Text::tr("The answer \"%1\" is not from a rotctld")
                                                .arg(toQString(printable(std::string(line.substr(0, kShownOfLine))))));
            break;
    }
    m_reader.reset();
}

std::optional<Result<AxisPosition>> PositionPoll::takeAnswer()
{
    return std::exchange(m_answer, std::nullopt);
}

}  // namespace boresight::rotctl
