// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/local_socket/local_command.h"

#include <QLocalSocket>
#include <QObject>
#include <QTimer>

#include <chrono>
#include <functional>

// One client of the local socket: its line, our answer, the end. A client that sends no line in time gets an answer,
// too. After the answer the client should close the connection. We close it if the client has not read anything for
// kPatience. Until then a client that is still sending can receive the answer, and a client that reads a long answer
// gets the time for it. Deletes itself when the connection has ended. Lives in its owner's event loop.
namespace boresight::local {

// May be called later, or never if the station ends first. Does nothing after the client is gone.
using Reply = std::function<void(const LocalAnswer&)>;
// Called with each command. The station carries it out.
using Obey = std::function<void(const LocalRequest&, const Reply&)>;

class LocalConversation : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kPatience{2};

    // Takes over the socket.
    LocalConversation(QLocalSocket* socket, Obey obey, QObject* parent);

    // Sends the answer. Does nothing if an answer was sent before.
    void end(const LocalAnswer& answer);
    [[nodiscard]] bool isOver() const { return m_over; }

private:
    void read();
    void obey(const LocalRequest& request);
    void closeOurEnd();
    void losePatience();

    QLocalSocket& m_socket;
    Obey m_obey;
    QTimer m_patience;
    bool m_asked = false;  // the command was passed on, and its answer is still to come
    bool m_over = false;
    bool m_reads = false;  // the client has read a part of our answer since the patience began
};

}  // namespace boresight::local
