// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/link_factory.h"

#include "core/base/bus_name.h"
#include "core/can/fdcanusb_link.h"
#include "core/can/socketcan_link.h"
#include "core/sim/simulated_link.h"

namespace boresight {

Result<std::unique_ptr<CanLink>> makeLink(const std::string& busName, const Clock& clock)
{
    return parseBusName(busName).map([&](const BusName& bus) -> std::unique_ptr<CanLink> {
        const QString target = QString::fromStdString(bus.target);
        switch (bus.kind) {
            case BusKind::SocketCan:
                return std::make_unique<SocketCanLink>(target, clock);
            case BusKind::Fdcanusb:
                return std::make_unique<FdcanusbLink>(target, clock);
            case BusKind::Simulated:
                break;
        }
        return std::make_unique<SimulatedLink>(clock);
    });
}

}  // namespace boresight
