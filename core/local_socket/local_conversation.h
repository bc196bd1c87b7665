// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/local_socket/local_command.h"

#include <QLocalSocket>
#include <QObject>
#include <QTimer>

#include <chrono>
#include <functional>

// One client of the local socket: its line, our answer, the end. A client that sends no line in time is answered, too.
// After the answer the client closes the connection, or we do when it has neither done so nor read for kPatience: what
// it is still sending must not cost it our answer, and an answer of many lines takes it a while. Deletes itself when
// the connection has ended. Lives in its owner's event loop.
namespace boresight::local {

// May be called later, or never if the station ends first. Does nothing once the client is gone.
using Reply = std::function<void(const LocalAnswer&)>;
// What the station does with a command.
using Obey = std::function<void(const LocalRequest&, const Reply&)>;

class LocalConversation : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kPatience{2};

    // Takes the socket over.
    LocalConversation(QLocalSocket* socket, Obey obey, QObject* parent);

    // Answers, unless this has happened before, and sends nothing more.
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
    bool m_asked = false;  // the answer is still to come
    bool m_over = false;
    bool m_reads = false;  // our answer, since patience began
};

}  // namespace boresight::local
