// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simple_mount/simple_connection.h"

#include <algorithm>
#include <utility>

namespace boresight {

SimpleConnection::SimpleConnection(std::shared_ptr<SimpleBox> box, const SimpleMount::Axes& axes)
    : m_box(std::move(box)), m_mount(*m_box, axes)
{}

void SimpleConnection::describe(StationStatus& status) const
{
    status.line = {.state = MountLine::State::Up, .name = QStringLiteral("simulated")};
}

MountKind simpleRotators()
{
    return [box = std::make_shared<SimpleBox>()](const profile::Profile&, const MountStart& start) -> MountMaker {
        const auto turns = [&start](Axis axis) { return std::ranges::find(start.axes, axis) != start.axes.end(); };
        const SimpleMount::Axes axes{.azimuth = turns(Axis::Azimuth), .elevation = turns(Axis::Elevation)};
        return [box, axes](const profile::InForce&, const Clock&, EventLog&, AlarmBoard&) {
            return std::make_unique<SimpleConnection>(box, axes);
        };
    };
}

}  // namespace boresight

#include "moc_simple_connection.cpp"
