// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

// Asks the system that the control ticks come before other work: real-time scheduling for the thread that
// calls ask(), from the kernel where the resource limits allow it, else from the service rtkit; and that the program's
// memory stays in RAM. The thread gives real-time scheduling back when it computes for 0.1 s without a pause.
// Lives on the thread that it asks for. At most one in a program.
namespace boresight {

class RealTime : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    void ask();

    // Whether the thread is scheduled so now.
    [[nodiscard]] bool isRealTime() const;
    // One line: what was granted, and what to do about what was not. Empty before ask().
    [[nodiscard]] QString text() const;

private:
    void askKernel();
    void askRtkit();
    void lockMemory();

    bool m_asked = false;
    bool m_granted = false;
    bool m_locked = false;
};

}  // namespace boresight
