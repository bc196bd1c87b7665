// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/simulated_box_line.h"

namespace boresight {

void SimulatedBoxLine::tick(SteadyTime now)
{
    m_now = now;
    if (const std::string bytes = m_box->answers(now); !bytes.empty() && state() == State::Up) {
        Q_EMIT received(QByteArray::fromStdString(bytes));
    }
}

}  // namespace boresight

#include "moc_simulated_box_line.cpp"
