// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/broker_session.h"

#include "core/base/text.h"

#include <linux/tcp.h>
#include <mosquitto.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace boresight::mqtt {
namespace {

constexpr int kOnePacket = 1;  // reserved by libmosquitto, "should be 1"
constexpr int kRefused = 0x80;

QString systemText(int error)
{
    return QString::fromStdString(std::generic_category().message(error));
}

// Only a connected socket has sent data, for instance the beginning of TLS.
bool hasSent(int socket)
{
    tcp_info info{};
    socklen_t size = sizeof info;
    return getsockopt(socket, IPPROTO_TCP, TCP_INFO, &info, &size) == 0 && info.tcpi_data_segs_out > 0;
}

// Why a socket is not connected after connecting has ended. Empty if it is connected.
std::optional<Ending> failureToConnect(int socket)
{
    sockaddr_storage peer{};
    socklen_t size = sizeof peer;
    if (getpeername(socket, reinterpret_cast<sockaddr*>(&peer), &size) == 0) {
        return std::nullopt;
    }
    int error = 0;
    size = sizeof error;
    getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
    // The system reports an error once, and the first write of the TLS handshake may have received it already.
    if (error == ECONNRESET || error == EPIPE || (error == 0 && hasSent(socket))) {
        return Ending{.kind = EndKind::HungUp};  // it was connected before
    }
    return Ending{.kind = EndKind::ConnectionFailed, .detail = systemText(error != 0 ? error : ECONNREFUSED)};
}

// Global state of libmosquitto, initialised once and kept until the program ends.
void initializeLibrary()
{
    struct Library
    {
        Library() { mosquitto_lib_init(); }
        ~Library() { mosquitto_lib_cleanup(); }
        Library(const Library&) = delete;
        Library& operator=(const Library&) = delete;
    };
    static const Library library;
}

}  // namespace

void BrokerSession::Destroy::operator()(mosquitto* handle) const
{
    mosquitto_destroy(handle);
}

struct BrokerSession::Callbacks
{
    static void answered(mosquitto* /*handle*/, void* session, int code)
    {
        static_cast<BrokerSession*>(session)->m_told.answer = code;
    }

    static void received(mosquitto* /*handle*/, void* session, const mosquitto_message* message)
    {
        if (message->payloadlen > kLargestMessage) {
            static_cast<BrokerSession*>(session)->m_told.dropped = message->payloadlen;
        } else {
            static_cast<BrokerSession*>(session)->m_told.inbox.push_back(
                {.topic = QString::fromUtf8(message->topic),
                 .payload = QByteArray(static_cast<const char*>(message->payload), message->payloadlen),
                 .retain = message->retain ? Retain::Yes : Retain::No});
        }
    }

    // MQTT 3.1.1, 3.9.3: values below 0x80 are the granted quality of service.
    static void subscribed(mosquitto* /*handle*/, void* session, int number, int count, const int* granted)
    {
        static_cast<BrokerSession*>(session)->m_told.granted.emplace_back(number, count == 1 && granted[0] < kRefused);
    }

    // "OpenSSL Error[0]: error:0A00010B:SSL routines::wrong version number"
    static void logged(mosquitto* /*handle*/, void* session, int level, const char* text)
    {
        const QString line = QString::fromUtf8(text);
        if (level == MOSQ_LOG_ERR && line.startsWith(QLatin1String("OpenSSL"))) {
            static_cast<BrokerSession*>(session)->m_told.tlsError = line.section(QStringLiteral("::"), -1);
        }
    }
};

BrokerSession::BrokerSession(const Broker& broker, std::shared_ptr<TlsContext> tls, const std::optional<Message>& will,
                             const Clock& clock, QObject* parent)
    : QObject(parent),
      m_broker(broker),
      m_tls(std::move(tls)),
      m_will(will),
      m_clock(clock),
      m_readable(QSocketNotifier::Read),
      m_writable(QSocketNotifier::Write)
{
    initializeLibrary();
    connect(&m_readable, &QSocketNotifier::activated, this, &BrokerSession::pump);
    connect(&m_writable, &QSocketNotifier::activated, this, &BrokerSession::socketWritable);
}

BrokerSession::~BrokerSession()
{
    drop();
}

bool BrokerSession::prepare()
{
    const QByteArray id = m_broker.clientId.toUtf8();
    m_handle.reset(mosquitto_new(id.isEmpty() ? nullptr : id.constData(), true, this));
    mosquitto* const handle = m_handle.get();
    if (handle == nullptr) {
        return false;
    }
    mosquitto_connect_callback_set(handle, &Callbacks::answered);
    mosquitto_message_callback_set(handle, &Callbacks::received);
    mosquitto_subscribe_callback_set(handle, &Callbacks::subscribed);
    mosquitto_log_callback_set(handle, &Callbacks::logged);
    bool done = mosquitto_int_option(handle, MOSQ_OPT_TCP_NODELAY, 1) == MOSQ_ERR_SUCCESS;
    if (!m_broker.user.isEmpty()) {
        done = done && mosquitto_username_pw_set(handle, m_broker.user.toUtf8().constData(),
                                                 m_broker.password.toUtf8().constData()) == MOSQ_ERR_SUCCESS;
    }
    if (m_will) {
        done = done &&
               mosquitto_will_set(handle, m_will->topic.toUtf8().constData(), static_cast<int>(m_will->payload.size()),
                                  m_will->payload.constData(), 0, m_will->retain == Retain::Yes) == MOSQ_ERR_SUCCESS;
    }
    if (m_tls) {
        done = done && mosquitto_int_option(handle, MOSQ_OPT_SSL_CTX_WITH_DEFAULTS, 0) == MOSQ_ERR_SUCCESS &&
               mosquitto_void_option(handle, MOSQ_OPT_SSL_CTX, m_tls->get()) == MOSQ_ERR_SUCCESS;
    }
    return done;
}

void BrokerSession::open(const QHostAddress& address)
{
    m_opened = m_clock.now();
    int result = MOSQ_ERR_NOMEM;
    errno = 0;
    if (prepare()) {
        // An address, never a name: libmosquitto would look a name up here and block.
        result = mosquitto_connect_async(m_handle.get(), address.toString().toUtf8().constData(), m_broker.port,
                                         static_cast<int>(kKeepAlive.count()));
    }
    if (result != MOSQ_ERR_SUCCESS) {
        const Ending ending = endingOf(result);
        QMetaObject::invokeMethod(
            this, [this, ending] { end(ending); }, Qt::QueuedConnection);
        return;
    }
    const int socket = mosquitto_socket(m_handle.get());
    m_readable.setSocket(socket);
    m_writable.setSocket(socket);
    watch();
}

void BrokerSession::goodbye()
{
    if (m_phase == Phase::Accepted) {
        mosquitto_disconnect(m_handle.get());
    }
    drop();
}

void BrokerSession::drop()
{
    m_phase = Phase::Ended;
    m_readable.setEnabled(false);
    m_writable.setEnabled(false);
    m_handle.reset();
}

bool BrokerSession::publish(const Message& message)
{
    if (m_phase != Phase::Accepted) {
        return false;
    }
    const int result = mosquitto_publish(m_handle.get(), nullptr, message.topic.toUtf8().constData(),
                                         static_cast<int>(message.payload.size()), message.payload.constData(), 0,
                                         message.retain == Retain::Yes);
    watch();
    return result == MOSQ_ERR_SUCCESS;
}

bool BrokerSession::subscribe(const QString& filter)
{
    if (m_phase != Phase::Accepted) {
        return false;
    }
    int number = 0;
    const int result = mosquitto_subscribe(m_handle.get(), &number, filter.toUtf8().constData(), 0);
    if (result == MOSQ_ERR_SUCCESS) {
        m_asked[number] = filter;
    }
    watch();
    return result == MOSQ_ERR_SUCCESS;
}

bool BrokerSession::unsubscribe(const QString& filter)
{
    if (m_phase != Phase::Accepted) {
        return false;
    }
    const int result = mosquitto_unsubscribe(m_handle.get(), nullptr, filter.toUtf8().constData());
    watch();
    return result == MOSQ_ERR_SUCCESS;
}

void BrokerSession::service()
{
    if (m_phase == Phase::Accepted) {
        settle(mosquitto_loop_misc(m_handle.get()));
    } else if (m_phase != Phase::Ended && m_clock.now() - m_opened >= kPatience) {
        end({.kind = m_phase == Phase::Connecting ? EndKind::NoAnswer : EndKind::Silent});
    }
}

// The first call shows whether connecting succeeded, which libmosquitto does not check.
void BrokerSession::socketWritable()
{
    if (m_phase == Phase::Connecting) {
        m_phase = Phase::Greeting;
        if (const auto failed = failureToConnect(mosquitto_socket(m_handle.get()))) {
            end(*failed);
            return;
        }
    }
    pump();
}

// Reading also continues the TLS handshake. After the handshake there is data to write.
void BrokerSession::pump()
{
    int result = MOSQ_ERR_SUCCESS;
    if (m_tls || m_inlet.mayRead(mosquitto_socket(m_handle.get()))) {
        result = mosquitto_loop_read(m_handle.get(), kOnePacket);
    }
    if (result == MOSQ_ERR_SUCCESS && mosquitto_want_write(m_handle.get())) {
        result = mosquitto_loop_write(m_handle.get(), kOnePacket);
    }
    settle(result);
}

void BrokerSession::settle(int result)
{
    const Ending ending = endingOf(result);  // saved before other calls change errno
    if (const auto answer = std::exchange(m_told.answer, std::nullopt)) {
        if (*answer != 0) {
            end({.kind = kindOfRefusal(*answer)});
            return;
        }
        m_phase = Phase::Accepted;
        Q_EMIT accepted();
    }
    deliver();
    if (m_phase == Phase::Ended) {
        return;  // a receiver closed the session
    }
    if (result != MOSQ_ERR_SUCCESS) {
        end(ending);
    } else if (m_phase == Phase::Greeting && hungUp(mosquitto_socket(m_handle.get()))) {
        end({.kind = EndKind::HungUp});
    } else {
        watch();
    }
}

void BrokerSession::deliver()
{
    for (const Message& message : std::exchange(m_told.inbox, {})) {
        if (m_phase == Phase::Accepted) {
            Q_EMIT received(message.topic, message.payload, message.retain);
        }
    }
    for (const auto& [number, granted] : std::exchange(m_told.granted, {})) {
        const auto asked = m_asked.extract(number);
        if (m_phase == Phase::Accepted && asked) {
            Q_EMIT subscriptionAnswered(asked.mapped(), granted);
        }
    }
    tellDropped();
}

void BrokerSession::tellDropped()
{
    const auto packet = m_inlet.takeDropped();
    const auto message = std::exchange(m_told.dropped, std::nullopt);
    if (const auto bytes = packet ? packet : message; bytes && m_phase == Phase::Accepted) {
        Q_EMIT dropped(*bytes);
    }
}

EndKind BrokerSession::kindOfRefusal(int code)
{
    switch (code) {
        case 1:
            return EndKind::ProtocolRefused;
        case 2:
            return EndKind::ClientIdRefused;
        case 3:
            return EndKind::NotServing;
        case 4:
        case 5:
            return EndKind::LoginRefused;
        default:
            return EndKind::Nonsense;
    }
}

Ending BrokerSession::endingOf(int result) const
{
    const int error = errno;
    switch (result) {
        case MOSQ_ERR_TLS:
            if (m_tls && !m_tls->refusal().isEmpty()) {
                return {.kind = EndKind::CertificateWrong, .detail = m_tls->refusal()};
            }
            return {.kind = EndKind::TlsRefused, .detail = m_told.tlsError};
        case MOSQ_ERR_KEEPALIVE:
            return {.kind = EndKind::NoPulse};
        case MOSQ_ERR_PROTOCOL:
        case MOSQ_ERR_MALFORMED_PACKET:
            return {.kind = EndKind::Nonsense};
        case MOSQ_ERR_NOMEM:
        case MOSQ_ERR_INVAL:
            return {.kind = EndKind::Local, .detail = QString::fromUtf8(mosquitto_strerror(result))};
        default:
            break;
    }
    if (m_phase == Phase::Connecting) {
        return {.kind = EndKind::ConnectionFailed, .detail = systemText(error)};
    }
    if (m_phase == Phase::Greeting) {
        return {.kind = EndKind::HungUp};
    }
    const bool closed = result == MOSQ_ERR_CONN_LOST || error == EPROTO || error == 0;
    return {.kind = EndKind::Lost, .detail = closed ? Text::tr("closed by the broker") : systemText(error)};
}

// On an encrypted connection libmosquitto asks to write during the whole handshake, although it has nothing to write.
void BrokerSession::watch()
{
    const bool isOpen = m_phase != Phase::Ended && mosquitto_socket(m_handle.get()) >= 0;
    const bool mayWrite = m_phase == Phase::Accepted || (m_phase == Phase::Greeting && !m_tls);
    m_readable.setEnabled(isOpen && m_phase != Phase::Connecting);
    m_writable.setEnabled(isOpen &&
                          (m_phase == Phase::Connecting || (mayWrite && mosquitto_want_write(m_handle.get()))));
}

void BrokerSession::end(const Ending& ending)
{
    if (m_phase == Phase::Ended) {
        return;
    }
    drop();
    Q_EMIT ended(ending);
}

}  // namespace boresight::mqtt

#include "moc_broker_session.cpp"
