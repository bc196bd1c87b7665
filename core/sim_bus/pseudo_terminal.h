// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/result.h"

#include <QString>

// A raw pseudo-terminal and a symbolic link of the user's choice to it, which goes with this: the device file of what
// is simulated. Any thread.
namespace boresight::sim {

class PseudoTerminal
{
public:
    // Refused if `link` exists and is not a symbolic link.
    [[nodiscard]] static Result<PseudoTerminal> create(const QString& link);
    PseudoTerminal(PseudoTerminal&&) = default;
    PseudoTerminal& operator=(PseudoTerminal&&) = delete;
    ~PseudoTerminal();

    [[nodiscard]] int number() const { return m_master.number(); }  // of our end; never blocks
    [[nodiscard]] const QString& link() const { return m_link; }
    [[nodiscard]] const QString& device() const { return m_device; }  // "/dev/pts/7"
    // Whether somebody has opened the other end.
    [[nodiscard]] bool hasClient() const;

private:
    PseudoTerminal(FileDescriptor master, QString device, QString link);

    FileDescriptor m_master;
    QString m_device;
    QString m_link;
};

}  // namespace boresight::sim
