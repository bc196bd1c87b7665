// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/mount_identity.h"

#include <algorithm>

namespace boresight {

// A drive reports its identity some seconds after the start. After a silence it may be another drive. A drive that was
// read but reports no UUID contradicts no record.
bool MountIdentity::update()
{
    bool isNew = false;
    for (const Axis axis : kAxes) {
        const std::optional<QString> uuid = m_control.mount().identity(axis);
        std::optional<QString>& last = m_drives[index(axis)];
        if (uuid && uuid != last && (!last || !uuid->isEmpty())) {
            last = uuid;
            isNew = true;
        }
    }
    return isNew;
}

bool MountIdentity::bothRead() const
{
    return std::ranges::all_of(m_drives, [](const auto& uuid) { return uuid.has_value(); });
}

// The position journal names the drive whose cable wrap was confirmed last. A new drive enters it only after the
// operator has answered.
calibration::RecordMount MountIdentity::today() const
{
    const auto drive = [this](Axis axis) {
        const QString reported = m_drives[index(axis)].value_or(QString());
        return (reported.isEmpty() ? m_control.mount().lastIdentity(axis) : reported).toStdString();
    };
    calibration::RecordMount mount{.azimuthDrive = drive(Axis::Azimuth), .elevationDrive = drive(Axis::Elevation)};
    if (m_profile->site.known) {
        mount.site = calibration::RecordSite{.latitude = m_profile->site.latitude,
                                             .longitude = m_profile->site.longitude,
                                             .heightMetres = m_profile->site.heightMetres};
    }
    return mount;
}

}  // namespace boresight
