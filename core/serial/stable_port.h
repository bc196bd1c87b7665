// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <utility>

// The serial port of a device, found again after the device was unplugged. Another device may get the name that the
// kernel gave (/dev/ttyACM0). So the name by maker and serial number for the same port is stored when the port is
// opened, and used from then on. If the operator configured a symbolic link, that link is used.
namespace boresight {

inline const QString kStableNames = QStringLiteral("/dev/serial/by-id");  // where udev keeps them

// The stable name for this port. Empty if there is none.
[[nodiscard]] QString stableNameOf(const QString& port, const QString& namesFolder = kStableNames);

class StablePort
{
public:
    // True if a device with this stable name may replace the stored one. Without this function no device may.
    using SpareTest = std::function<bool(const QString& stableName)>;

    StablePort(QString path, QString namesFolder = kStableNames, SpareTest isSpare = {})
        : m_path(std::move(path)), m_namesFolder(std::move(namesFolder)), m_isSpare(std::move(isSpare))
    {}

    [[nodiscard]] const QString& path() const { return m_path; }  // as configured
    [[nodiscard]] const QString& name() const { return m_name; }  // stored; empty if there is none

    // The path to open now.
    [[nodiscard]] QString device() const;
    // Call this after device() was opened.
    void storeName();

private:
    [[nodiscard]] bool hasSpare() const;

    QString m_path;
    QString m_namesFolder;
    SpareTest m_isSpare;
    QString m_name;
};

}  // namespace boresight
