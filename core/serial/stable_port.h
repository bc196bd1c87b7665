// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <utility>

// The serial port of a device, found again after it was unplugged. A name that the kernel gave (/dev/ttyACM0) may
// belong to another device then, so the name by maker and serial number that leads to the same port is stored when
// the port is opened, and counts from then on. A symbolic link that the operator chose stays what counts.
namespace boresight {

inline const QString kStableNames = QStringLiteral("/dev/serial/by-id");  // where udev keeps them

// The stable name that leads to this port; empty if there is none.
[[nodiscard]] QString stableNameOf(const QString& port, const QString& namesFolder = kStableNames);

class StablePort
{
public:
    // Whether a device of this stable name may take the place of the stored one. Without the test none may.
    using SpareTest = std::function<bool(const QString& stableName)>;

    StablePort(QString path, QString namesFolder = kStableNames, SpareTest isSpare = {})
        : m_path(std::move(path)), m_namesFolder(std::move(namesFolder)), m_isSpare(std::move(isSpare))
    {}

    [[nodiscard]] const QString& path() const { return m_path; }  // as configured
    [[nodiscard]] const QString& name() const { return m_name; }  // stored; empty if there is none

    // What to open now.
    [[nodiscard]] QString device() const;
    // To be called when device() was opened.
    void storeName();

private:
    [[nodiscard]] bool hasSpare() const;

    QString m_path;
    QString m_namesFolder;
    SpareTest m_isSpare;
    QString m_name;
};

}  // namespace boresight
