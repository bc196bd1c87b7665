// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/tls_context.h"

#include "core/base/text.h"

#include <QFile>
#include <QFileInfo>
#include <QHostAddress>

#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include <array>

namespace boresight::mqtt {
namespace {

constexpr qint64 kLargestCaFile = 32 * 1024;  // bytes: ten authorities, 3 ms to read

// The first error is the cause of the others.
QString causeOfFailure()
{
    std::array<char, 256> text{};
    ERR_error_string_n(ERR_get_error(), text.data(), text.size());
    ERR_clear_error();
    return QString::fromUtf8(text.data()).section(QStringLiteral("::"), -1);
}

}  // namespace

// Called by OpenSSL during the handshake.
struct TlsContext::Callbacks
{
    static TlsContext& ownerOf(const SSL* ssl)
    {
        return *static_cast<TlsContext*>(SSL_CTX_get_app_data(SSL_get_SSL_CTX(ssl)));
    }

    static int verify(int accepted, X509_STORE_CTX* store)
    {
        const auto* const ssl =
            static_cast<const SSL*>(X509_STORE_CTX_get_ex_data(store, SSL_get_ex_data_X509_STORE_CTX_idx()));
        ownerOf(ssl).m_certificateError = X509_STORE_CTX_get_error(store);
        return accepted;
    }

    // libmosquitto has put the address into the greeting. A broker with several names needs the name instead.
    static void watch(const SSL* ssl, int where, int /*value*/)
    {
        TlsContext& owner = ownerOf(ssl);
        if ((where & SSL_CB_HANDSHAKE_START) == 0) {
            return;
        }
        owner.m_certificateError = X509_V_OK;
        if (!owner.m_hostIsAddress) {
            // This is SSL_set_tlsext_host_name(), whose macro contains an old-style cast.
            SSL_ctrl(const_cast<SSL*>(ssl), SSL_CTRL_SET_TLSEXT_HOSTNAME, TLSEXT_NAMETYPE_host_name,
                     owner.m_host.data());
        }
    }
};

TlsContext::TlsContext(OnlyByCreate, const QString& caFile, const QString& host)
    : m_caFile(caFile),
      m_host(host.toUtf8()),
      m_hostIsAddress(!QHostAddress(host).isNull()),
      m_context(SSL_CTX_new(TLS_client_method())),
      m_certificateError(X509_V_OK)
{}

TlsContext::~TlsContext()
{
    SSL_CTX_free(m_context);
}

Result<std::shared_ptr<TlsContext>> TlsContext::create(const QString& caFile, const QString& host)
{
    const auto context = std::make_shared<TlsContext>(OnlyByCreate{}, caFile, host);
    return context->prepare().map([&] { return context; });
}

Result<> TlsContext::prepare()
{
    if (m_context == nullptr || SSL_CTX_set_min_proto_version(m_context, TLS1_2_VERSION) != 1 || !expectHost()) {
        return failure(ErrorCode::Io, Text::tr("Encryption cannot be set up: %1").arg(causeOfFailure()));
    }
    SSL_CTX_set_app_data(m_context, this);
    SSL_CTX_set_verify(m_context, SSL_VERIFY_PEER, &Callbacks::verify);
    SSL_CTX_set_info_callback(m_context, &Callbacks::watch);
    return loadAuthorities();
}

// The authorities of this computer are in a directory where OpenSSL looks up the one that it needs. Reading the list of
// all of them would take 50 ms, two and a half ticks of the station.
Result<> TlsContext::loadAuthorities()
{
    if (m_caFile.isEmpty()) {
        SSL_CTX_set_default_verify_dir(m_context);
        return {};
    }
    if (QFileInfo(m_caFile).size() > kLargestCaFile) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("%1 is a list of many authorities. Name the authority that signed the certificate of the broker. "
                     "With an empty mqtt.ca_file Boresight trusts the authorities of this computer")
                .arg(m_caFile));
    }
    if (SSL_CTX_load_verify_locations(m_context, QFile::encodeName(m_caFile).constData(), nullptr) != 1) {
        return failure(ErrorCode::NoDevice,
                       Text::tr("No certificate of an authority can be read from %1 (%2). Check mqtt.ca_file")
                           .arg(m_caFile, causeOfFailure()));
    }
    return {};
}

bool TlsContext::expectHost()
{
    X509_VERIFY_PARAM* const expected = SSL_CTX_get0_param(m_context);
    if (m_hostIsAddress) {
        return X509_VERIFY_PARAM_set1_ip_asc(expected, m_host.constData()) == 1;
    }
    X509_VERIFY_PARAM_set_hostflags(expected, X509_CHECK_FLAG_NO_PARTIAL_WILDCARDS);
    return X509_VERIFY_PARAM_set1_host(expected, m_host.constData(), 0) == 1;
}

QString TlsContext::refusal() const
{
    switch (m_certificateError) {
        case X509_V_OK:
            return {};
        case X509_V_ERR_CERT_HAS_EXPIRED:
            return Text::tr("its certificate has expired, or the clock of this computer is wrong");
        case X509_V_ERR_CERT_NOT_YET_VALID:
            return Text::tr("its certificate is not valid yet, or the clock of this computer is wrong");
        case X509_V_ERR_HOSTNAME_MISMATCH:
        case X509_V_ERR_IP_ADDRESS_MISMATCH:
            return Text::tr("its certificate is not for \"%1\". Check mqtt.host").arg(QString::fromUtf8(m_host));
        case X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT:
        case X509_V_ERR_SELF_SIGNED_CERT_IN_CHAIN:
        case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT:
        case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY:
        case X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE:
        case X509_V_ERR_CERT_SIGNATURE_FAILURE:
            return m_caFile.isEmpty()
                       ? Text::tr("This computer does not know the authority of its certificate. Set mqtt.ca_file")
                       : Text::tr("its certificate is not from the authority in %1. Check mqtt.ca_file").arg(m_caFile);
        default:
            return QString::fromUtf8(X509_verify_cert_error_string(m_certificateError));
    }
}

}  // namespace boresight::mqtt
