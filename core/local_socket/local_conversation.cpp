// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/local_socket/local_conversation.h"

#include "core/base/text.h"

#include <QPointer>

#include <sys/socket.h>

#include <utility>

namespace boresight::local {

LocalConversation::LocalConversation(QLocalSocket* socket, Obey obey, QObject* parent)
    : QObject(parent), m_socket(*socket), m_obey(std::move(obey)), m_patience(this)
{
    socket->setParent(this);
    socket->setReadBufferSize(kLongestLine + 1);  // with the LF; the rest waits at the sender
    connect(socket, &QLocalSocket::readyRead, this, &LocalConversation::read);
    connect(socket, &QLocalSocket::disconnected, this, &QObject::deleteLater);
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatience);
    connect(&m_patience, &QTimer::timeout, this, &LocalConversation::losePatience);
    m_patience.start();
}

void LocalConversation::read()
{
    if (m_over || m_asked) {
        m_socket.readAll();  // only one command per connection
        return;
    }
    const QByteArray received = m_socket.peek(kLongestLine + 1);
    const qsizetype lineEnd = received.indexOf('\n');
    if (lineEnd >= 0) {
        const Result<LocalRequest> request = parseRequest(received.first(lineEnd));
        request ? obey(*request) : end(tl::unexpected(request.error()));
    } else if (received.size() > kLongestLine) {
        end(failure(ErrorCode::InvalidInput, Text::tr("The line is longer than %1 bytes.").arg(kLongestLine)));
    }
}

// The answer may come later, because the station may first read a file.
void LocalConversation::obey(const LocalRequest& request)
{
    m_asked = true;
    m_patience.stop();
    m_obey(request, [self = QPointer(this)](const LocalAnswer& answer) {
        if (self) {
            self->end(answer);
        }
    });
}

void LocalConversation::end(const LocalAnswer& answer)
{
    if (m_over) {
        return;
    }
    m_over = true;
    m_patience.start();
    connect(&m_socket, &QLocalSocket::bytesWritten, this, [this] {
        m_reads = true;
        closeOurEnd();
    });
    m_socket.write(answerText(answer));
    m_socket.flush();
    closeOurEnd();
}

// Closes our end after the answer is sent. A long answer does not fit into the socket at once, so a client that is
// still reading gets more time.
void LocalConversation::closeOurEnd()
{
    if (m_socket.bytesToWrite() == 0 && m_socket.isValid()) {  // the client is still connected
        ::shutdown(static_cast<int>(m_socket.socketDescriptor()), SHUT_WR);
        m_socket.readAll();
    }
}

void LocalConversation::losePatience()
{
    if (!m_over) {
        end(failure(ErrorCode::NoAnswer, Text::tr("No command came within %1 s.").arg(kPatience.count())));
    } else if (std::exchange(m_reads, false)) {
        m_patience.start();
    } else {
        m_socket.abort();
    }
}

}  // namespace boresight::local

#include "moc_local_conversation.cpp"
