// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/modem_line.h"

namespace boresight::outputs {

Result<> ModemLine::open()
{
    if (m_open) {
        return {};
    }
    return m_port->open().and_then([this] {
        m_open = true;
        return m_port->set(m_line, false).and_then([this] {
            return m_port->set(m_line == Line::Dtr ? Line::Rts : Line::Dtr, false);
        });
    });
}

Result<> ModemLine::set(bool high)
{
    Result<> done = open().and_then([&] { return m_port->set(m_line, high); });
    if (!done && m_open) {
        m_port->close();  // lowers the lines, unless the adapter is gone
        m_open = false;
    }
    return done;
}

}  // namespace boresight::outputs
