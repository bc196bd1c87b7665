// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <memory>

struct ssl_ctx_st;  // OpenSSL's SSL_CTX

// Whom we trust, and whom we expect, when the connection to a broker is encrypted. The only user of OpenSSL.
//
// libmosquitto could do that by itself, but then it must be given the broker's name, and resolves it, blocking, in the
// thread that also feeds the drives. So it is given an address, and the name is checked here. Besides, OpenSSL knows
// why a certificate is refused and libmosquitto does not report it.
namespace boresight::mqtt {

class TlsContext
{
    struct OnlyByCreate
    {};

public:
    // `caFile` empty: the authorities that this computer knows. Reads the file, which may hold a few authorities only.
    [[nodiscard]] static Result<std::shared_ptr<TlsContext>> create(const QString& caFile, const QString& host);
    TlsContext(OnlyByCreate, const QString& caFile, const QString& host);
    ~TlsContext();
    TlsContext(const TlsContext&) = delete;
    TlsContext& operator=(const TlsContext&) = delete;

    [[nodiscard]] ssl_ctx_st* get() const { return m_context; }
    // Why the certificate of the last handshake was refused; empty if it was not.
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
