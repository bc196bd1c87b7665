// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_name.h"

#include <QCryptographicHash>

namespace boresight {

QString safeFileName(const QString& mountName)
{
    constexpr int kLongest = 64;
    QString safe = mountName.left(kLongest);
    for (QChar& c : safe) {
        const bool plain = c.unicode() < 128 && (c.isLetterOrNumber() || c == u'-' || c == u'_');
        c = plain ? c : QChar(u'_');
    }
    if (safe == mountName && !safe.isEmpty()) {
        return safe;
    }
    const QByteArray hash = QCryptographicHash::hash(mountName.toUtf8(), QCryptographicHash::Sha256).toHex();
    return safe + u'-' + QString::fromLatin1(hash.left(8));
}

}  // namespace boresight
