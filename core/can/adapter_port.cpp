// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/adapter_port.h"

#include "core/base/text.h"
#include "core/serial/serial_port_check.h"

namespace boresight {

// Both adapters report the name mjbots_fdcanusb. The name of the maker alone covers later ones.
bool isAdapterName(const QString& name)
{
    return name.contains(QLatin1String("mjbots"), Qt::CaseInsensitive) ||
           name.contains(QLatin1String("fdcanusb"), Qt::CaseInsensitive);
}

StablePort adapterPort(const QString& path, const QString& namesFolder)
{
    return {path, namesFolder, isAdapterName};
}

Result<> checkAdapterPort(const QString& device)
{
    const Result<> check = checkSerialPort(device);
    if (!check && check.error().code == ErrorCode::Denied) {
        return failure(ErrorCode::Denied,
                       Text::tr("%1: no permission. Install packaging/udev/70-boresight-fdcanusb.rules to "
                                "/etc/udev/rules.d. Plug the adapter in again. Join the group dialout with `sudo "
                                "usermod -aG dialout $USER`, then log in again")
                           .arg(device));
    }
    return check;
}

}  // namespace boresight
