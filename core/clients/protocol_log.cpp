// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clients/protocol_log.h"

#include "core/base/text.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace boresight {
namespace {

using ActKind = ProtocolAct::Kind;

// A line of several commands asks for a few acts. More of them would only repeat.
constexpr std::size_t kMostActs = 8;

bool isQuestion(const ProtocolAct& act)
{
    return act.kind == ActKind::AskPosition || act.kind == ActKind::AskTarget || act.kind == ActKind::AskMotion;
}

ProtocolOutcome outcomeOf(const Result<>& result)
{
    if (result) {
        return ProtocolOutcome::Done;
    }
    return result.error().code == ErrorCode::InvalidInput ? ProtocolOutcome::NotUnderstood : ProtocolOutcome::Refused;
}

}  // namespace

void ProtocolLog::setOn(bool on)
{
    m_on = on;
    m_acts.clear();
}

// One question stands for all of a line. For an angle of one axis the protocols ask for the other axis of the target.
void ProtocolLog::note(const ProtocolAct& act)
{
    if (isQuestion(act) && std::ranges::any_of(m_acts, isQuestion)) {
        return;
    }
    if (act.kind == ActKind::Point) {
        std::erase_if(m_acts, [](const ProtocolAct& one) { return one.kind == ActKind::AskTarget; });
    }
    if (m_acts.size() < kMostActs) {
        m_acts.push_back(act);
    }
}

void ProtocolLog::add(const rotctld::Client& client, const rotctld::Exchange& exchange)
{
    ProtocolLine line{.number = ++m_lastNumber,
                      .utc = m_clock.utc(),
                      .clientId = client.id,
                      .client = nameOf(client),
                      .line = protocolBytes(exchange.line, exchange.size),
                      .acts = std::exchange(m_acts, {}),
                      .command = std::string(exchange.command),
                      .outcome = outcomeOf(exchange.result),
                      .remark = exchange.result ? exchange.became : exchange.result.error().text,
                      .answer = protocolBytes(exchange.answer),
                      .odd = exchange.odd};
    m_lines.push_back(std::move(line));
    if (m_lines.size() > kCapacity) {
        m_lines.pop_front();
    }
}

const QString& ProtocolLog::nameOf(const rotctld::Client& client)
{
    if (client.id != m_namedId || m_name.isEmpty()) {
        m_namedId = client.id;
        m_name = toQString(client.protocol) + QLatin1Char(' ') + toQString(client.address);
    }
    return m_name;
}

std::size_t ProtocolLog::countAfter(std::uint64_t number) const
{
    const std::uint64_t after = m_lastNumber - std::min(number, m_lastNumber);
    return static_cast<std::size_t>(std::min<std::uint64_t>(after, m_lines.size()));
}

ProtocolLines ProtocolLog::newest(std::uint64_t number, std::size_t limit) const
{
    const std::size_t count = std::min(countAfter(number), limit);
    return count == 0 ? nullptr
                      : std::make_shared<const std::vector<ProtocolLine>>(
                            std::prev(m_lines.end(), static_cast<std::ptrdiff_t>(count)), m_lines.end());
}

ProtocolLines ProtocolLog::oldest(std::uint64_t number, std::size_t limit) const
{
    const std::size_t after = countAfter(number > m_lastNumber ? 0 : number);
    const auto begin = std::prev(m_lines.end(), static_cast<std::ptrdiff_t>(after));
    return after == 0 ? nullptr
                      : std::make_shared<const std::vector<ProtocolLine>>(
                            begin, std::next(begin, static_cast<std::ptrdiff_t>(std::min(after, limit))));
}

}  // namespace boresight
