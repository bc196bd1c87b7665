// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/box_line.h"

namespace boresight {

void BoxLine::show(State state, const QString& problem)
{
    if (m_state != state || m_problem != problem) {
        m_state = state;
        m_problem = problem;
        Q_EMIT stateChanged();
    }
}

}  // namespace boresight

#include "moc_box_line.cpp"
