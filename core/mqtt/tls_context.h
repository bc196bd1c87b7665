// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <memory>

struct ssl_ctx_st;  // OpenSSL's SSL_CTX

// The trusted authorities and the expected host name of an encrypted connection to a broker. The only user of OpenSSL.
//
// libmosquitto could check both itself. But then it needs the name of the broker, and it looks the name up and blocks.
// So it gets an address, and the name is checked here. OpenSSL also knows why a certificate is refused, which
// libmosquitto does not report.
namespace boresight::mqtt {

class TlsContext
{
    struct OnlyByCreate
    {};

public:
    // Trusts the certificate authorities in `caFile`. The file may contain only a few. If `caFile` is empty, trusts the
    // authorities of this computer.
    [[nodiscard]] static Result<std::shared_ptr<TlsContext>> create(const QString& caFile, const QString& host);
    TlsContext(OnlyByCreate, const QString& caFile, const QString& host);
    ~TlsContext();
    TlsContext(const TlsContext&) = delete;
    TlsContext& operator=(const TlsContext&) = delete;

    [[nodiscard]] ssl_ctx_st* get() const { return m_context; }
    // Why the certificate of the last handshake was refused. Empty if it was accepted.
    [[nodiscard]] QString refusal() const;

private:
    struct Callbacks;

    [[nodiscard]] Result<> prepare();
    [[nodiscard]] Result<> loadAuthorities();
    [[nodiscard]] bool expectHost();

    QString m_caFile;
    QByteArray m_host;
    bool m_hostIsAddress;
    ssl_ctx_st* m_context;
    int m_certificateError;  // X509_V_…
};

}  // namespace boresight::mqtt
