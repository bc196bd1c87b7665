// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

// An output of this computer: on or off. Its owner sets it again and again, even to the same
// state, so that a lost output is restored. set() does not block. The destructor leaves the output as it was last set,
// so set it off before. Station thread.
namespace boresight::outputs {

class Output : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // One of the signals answers, perhaps within the call. If several calls wait, only the newest is carried out.
    virtual void set(bool on) = 0;
    // True: the destructor would not have to wait. If false, a signal follows later.
    [[nodiscard]] virtual bool isIdle() const { return true; }

Q_SIGNALS:
    // The output is in this state.
    void reached(bool on);
    // The output could not be set. Its state is unknown.
    void failed(const QString& reason);
};

}  // namespace boresight::outputs
