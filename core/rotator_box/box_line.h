// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/mount_line.h"

#include <QByteArray>
#include <QObject>
#include <QString>

// The line to a box with a text protocol: a serial port, a TCP connection, or a simulated line. Bytes only. Station
// thread only. Never blocks.
namespace boresight {

class BoxLine : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    using State = MountLine::State;

    [[nodiscard]] virtual QString name() const = 0;  // the bus name of the profile
    // Opens the line if it is closed and is not being opened. Called again each second.
    virtual void open() = 0;
    // Closes the line until open().
    virtual void close() = 0;
    virtual void write(const QByteArray& bytes) = 0;
    // Once per tick.
    virtual void tick(SteadyTime /*now*/) {}

    [[nodiscard]] State state() const { return m_state; }
    // Why the line is not up: what, where, what to do.
    [[nodiscard]] const QString& problem() const { return m_problem; }

Q_SIGNALS:
    void received(const QByteArray& bytes);
    void stateChanged();

protected:
    static constexpr qint64 kMostUnwritten = 512;  // bytes; limit for a box that accepts nothing any more
    static constexpr qint64 kBytesAtOnce = 2048;   // no box sends more than this between two reads

    void show(State state, const QString& problem = {});

private:
    State m_state = State::Closed;
    QString m_problem;
};

}  // namespace boresight
