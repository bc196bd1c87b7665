// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/local_socket/local_conversation.h"

#include <QLocalServer>
#include <QObject>

#include <cstdint>

// The local socket of a station: a file that only its user can open, in a private folder of that user. Each connection
// brings one command. Lives in its owner's event loop.
namespace boresight::local {

class LocalServer : public QObject
{
    Q_OBJECT

public:
    static constexpr int kMostClients = 8;  // at the same time

    explicit LocalServer(Obey obey, QObject* parent = nullptr);
    ~LocalServer() override;

    // Opens socketPath(runtimeFolder, port). Removes the socket of a killed program. Error Busy: another program
    // listens there.
    [[nodiscard]] Result<> listen(const QString& runtimeFolder, std::uint16_t port);
    // Also removes the file.
    void close();

    // Empty while the server does not listen.
    [[nodiscard]] QString path() const { return m_server.fullServerName(); }

private:
    void acceptWaiting();
    void accept(QLocalSocket* socket);
    [[nodiscard]] QList<LocalConversation*> conversations() const;

    Obey m_obey;
    QLocalServer m_server;
};

}  // namespace boresight::local
