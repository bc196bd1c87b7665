// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/protocol_line.h"
#include "core/rotctld/rotator.h"

#include <cstdint>
#include <deque>
#include <vector>

// The protocol log: the newest kCapacity lines of all clients. It is off at first, and then keeps nothing. It makes no
// text: that is done where the lines are read. Station thread.
namespace boresight {

class ProtocolLog
{
public:
    static constexpr std::size_t kCapacity = 2000;

    // The clock outlives this.
    explicit ProtocolLog(const Clock& clock) : m_clock(clock) {}

    // The lines stay when the log ends.
    void setOn(bool on);
    [[nodiscard]] bool isOn() const { return m_on; }

    // What the line that is being carried out asks of the mount. Call while the log is on.
    void note(const ProtocolAct& act);
    // The line was carried out.
    void add(const rotctld::Client& client, const rotctld::Exchange& exchange);

    // The lines with numbers above `number`, oldest first: at most `limit` of them. Null: there is none.
    [[nodiscard]] ProtocolLines newest(std::uint64_t number, std::size_t limit) const;
    // A number above the newest one is of the log of a station before, so all lines are new.
    [[nodiscard]] ProtocolLines oldest(std::uint64_t number, std::size_t limit) const;
    [[nodiscard]] std::uint64_t lastNumber() const { return m_lastNumber; }

private:
    [[nodiscard]] const QString& nameOf(const rotctld::Client& client);
    [[nodiscard]] std::size_t countAfter(std::uint64_t number) const;

    const Clock& m_clock;
    bool m_on = false;
    std::deque<ProtocolLine> m_lines;
    std::uint64_t m_lastNumber = 0;
    std::vector<ProtocolAct> m_acts;  // of the line that is being carried out
    std::uint64_t m_namedId = 0;      // of the client whose name was made last
    QString m_name;
};

}  // namespace boresight
