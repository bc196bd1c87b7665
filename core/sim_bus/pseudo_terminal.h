// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/result.h"

#include <QString>

// A raw pseudo-terminal with a symbolic link to it at a path that the user chooses: the device file of a simulated
// device. The link is removed with this object. Any thread.
namespace boresight::sim {

class PseudoTerminal
{
public:
    // Refused if `link` exists and is not a symbolic link.
    [[nodiscard]] static Result<PseudoTerminal> create(const QString& link);
    PseudoTerminal(PseudoTerminal&&) = default;
    PseudoTerminal& operator=(PseudoTerminal&&) = delete;
    ~PseudoTerminal();

    [[nodiscard]] int number() const { return m_master.number(); }  // of our end, which never blocks
    [[nodiscard]] const QString& link() const { return m_link; }
    [[nodiscard]] const QString& device() const { return m_device; }  // "/dev/pts/7"
    // True if the other end is open.
    [[nodiscard]] bool hasClient() const;

private:
    PseudoTerminal(FileDescriptor master, QString device, QString link);

    FileDescriptor m_master;
    QString m_device;
    QString m_link;
};

}  // namespace boresight::sim
