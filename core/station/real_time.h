// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

// Asks the system to run the control ticks before other work. The thread that calls ask() gets real-time scheduling
// from the kernel if the resource limits allow it, else from the service rtkit. The memory of the program is locked in
// RAM. The thread gives real-time scheduling back when it computes for 0.1 s without a pause. An object lives on the
// thread that it serves. At most one in a program.
namespace boresight {

class RealTime : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    void ask();

    // Whether the thread has real-time scheduling now.
    [[nodiscard]] bool isRealTime() const;
    // One line: what was granted, and what the operator can do about the rest. Empty before ask().
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
