// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/local_socket/local_server.h"

#include "core/base/text.h"

#include <QFile>
#include <QFileInfo>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace boresight::local {
namespace {

constexpr mode_t kOwnerOnly = S_IRWXU;

// The folder may exist already. Then it must not have been created by another user.
Result<> makePrivateFolder(const QString& folder)
{
    const QByteArray path = QFile::encodeName(folder);
    if (::mkdir(path.constData(), kOwnerOnly) != 0 && errno != EEXIST) {
        return failure(ErrorCode::Io,
                       Text::tr("cannot make the folder %1: %2").arg(folder, toQString(std::strerror(errno))));
    }
    struct stat found = {};
    if (::lstat(path.constData(), &found) != 0 || !S_ISDIR(found.st_mode) || found.st_uid != ::geteuid() ||
        ::chmod(path.constData(), kOwnerOnly) != 0) {
        return failure(ErrorCode::Denied, Text::tr("%1 is not a folder of this user").arg(folder));
    }
    return {};
}

// A killed program leaves its socket, on which nobody listens. The check is needed because Qt would also replace a
// socket in use.
Result<> removeStale(const QString& path)
{
    if (!QFileInfo::exists(path)) {
        return {};
    }
    QLocalSocket question;
    question.connectToServer(path);
    if (question.state() != QLocalSocket::UnconnectedState) {
        return failure(ErrorCode::Busy, Text::tr("another program listens on %1").arg(path));
    }
    if (!QLocalServer::removeServer(path)) {
        return failure(ErrorCode::Io, Text::tr("cannot remove %1").arg(path));
    }
    return {};
}

}  // namespace

LocalServer::LocalServer(Obey obey, QObject* parent) : QObject(parent), m_obey(std::move(obey)), m_server(this)
{
    m_server.setSocketOptions(QLocalServer::UserAccessOption);
    connect(&m_server, &QLocalServer::newConnection, this, &LocalServer::acceptWaiting);
}

LocalServer::~LocalServer()
{
    close();
}

Result<> LocalServer::listen(const QString& runtimeFolder, std::uint16_t port)
{
    close();
    if (runtimeFolder.isEmpty()) {
        return failure(ErrorCode::NotAvailable, Text::tr("XDG_RUNTIME_DIR is not set"));
    }
    const QString path = socketPath(runtimeFolder, port);
    return makePrivateFolder(QFileInfo(path).path())
        .and_then([&] { return removeStale(path); })
        .and_then([&]() -> Result<> {
            if (!m_server.listen(path)) {
                return failure(ErrorCode::Io, Text::tr("cannot listen on %1: %2").arg(path, m_server.errorString()));
            }
            return {};
        });
}

// A command may end the station, so its conversation must survive this call.
void LocalServer::close()
{
    m_server.close();
    for (LocalConversation* const one : conversations()) {
        one->end(failure(ErrorCode::NotAvailable, Text::tr("The station is closing.")));
    }
}

void LocalServer::acceptWaiting()
{
    while (QLocalSocket* const socket = m_server.nextPendingConnection()) {
        accept(socket);
    }
}

void LocalServer::accept(QLocalSocket* socket)
{
    const bool isFull =
        std::ranges::count_if(conversations(), [](const auto* one) { return !one->isOver(); }) >= kMostClients;
    auto* const conversation = new LocalConversation(socket, m_obey, this);
    if (isFull) {
        conversation->end(failure(ErrorCode::Busy, Text::tr("Too many programs ask at the same time. Try again.")));
    }
}

QList<LocalConversation*> LocalServer::conversations() const
{
    return findChildren<LocalConversation*>(Qt::FindDirectChildrenOnly);
}

}  // namespace boresight::local

#include "moc_local_server.cpp"
