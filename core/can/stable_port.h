// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// The serial port of an adapter, found again after it was unplugged. A name that the kernel gave (/dev/ttyACM0) may
// belong to another device then, so the name by maker and serial number that leads to the same port is remembered when
// the port is opened, and counts from then on. A symbolic link that the operator chose stays what counts.
namespace boresight {

class StablePort
{
public:
    // `namesFolder` is where udev keeps the stable names.
    StablePort(QString path, QString namesFolder = QStringLiteral("/dev/serial/by-id"))
        : m_path(std::move(path)), m_namesFolder(std::move(namesFolder))
    {}

    [[nodiscard]] const QString& path() const { return m_path; }  // as configured
    [[nodiscard]] const QString& name() const { return m_name; }  // remembered; empty if there is none

    // What to open now.
    [[nodiscard]] QString device() const;
    // To be called when device() was opened.
    void remember();

private:
    [[nodiscard]] QString nameOf(const QString& port) const;

    QString m_path;
    QString m_namesFolder;
    QString m_name;
};

}  // namespace boresight
