// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

// What permits a transmitter to transmit: on or off. Its owner sets it again and again, also to what it has, so that an
// output that was lost is found again. Nothing blocks. It is left as it was set last, so set it off before its end.
// Station thread.
namespace boresight::transmit {

class TransmitOutput : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // Answered by one of the signals, also within the call. Of several that wait the newest counts.
    virtual void set(bool on) = 0;
    // Its end waits for nothing now. Where it is not, a later signal follows.
    [[nodiscard]] virtual bool isIdle() const { return true; }

Q_SIGNALS:
    // It is so now.
    void reached(bool on);
    // It could not be set. Nobody knows what it is.
    void failed(const QString& reason);
};

}  // namespace boresight::transmit
