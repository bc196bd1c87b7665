// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/request_desk.h"

namespace boresight::ui {

namespace {
// A pressed jog key sends 20 requests a second. A station that has not answered for ten seconds will not answer the
// oldest request.
constexpr std::size_t kMaxWaiting = 200;
}  // namespace

void RequestDesk::send(const Request& request, QObject* asker, const Reply& reply)
{
    ask(request, asker, [reply](const Answer& answer) { reply(answer.error); });
}

void RequestDesk::ask(const Request& request, QObject* asker, WholeReply reply)
{
    if (m_waiting.size() >= kMaxWaiting) {
        const auto eldest = m_waiting.begin();
        answer(eldest,
               {.requestId = eldest->first, .error = Error{ErrorCode::NoAnswer, tr("The station does not answer.")}});
    }
    const std::uint64_t id = ++m_last;
    m_waiting.emplace(id, Waiting{asker, std::move(reply)});
    Q_EMIT requested(NumberedRequest{.id = id, .request = request});
}

void RequestDesk::take(const std::vector<Answer>& answers)
{
    for (const Answer& one : answers) {
        const auto waiting = m_waiting.find(one.requestId);
        if (waiting != m_waiting.end()) {
            answer(waiting, one);
        }
    }
}

void RequestDesk::answer(std::map<std::uint64_t, Waiting>::iterator waiting, const Answer& answer)
{
    const Waiting asked = std::move(waiting->second);
    m_waiting.erase(waiting);  // before the reply: it may send again
    if (asked.asker) {
        asked.reply(answer);
    }
}

}  // namespace boresight::ui

#include "moc_request_desk.cpp"
