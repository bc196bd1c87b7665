// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/coefficient_file.h"

#include "core/base/text.h"

#include <QFile>

namespace boresight::geomagnetism {

namespace {

constexpr qint64 kLargest = 64 * 1024;  // the published files have 5 KB

}  // namespace

Result<Coefficients> readCoefficients(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::Io, Text::tr("%1 cannot be read: %2").arg(path, file.errorString()));
    }
    const QByteArray text = file.read(kLargest + 1);
    if (text.size() > kLargest) {
        return failure(ErrorCode::InvalidInput, Text::tr("%1 is too large for a World Magnetic Model.").arg(path));
    }
    return parseCoefficients({text.constData(), static_cast<std::size_t>(text.size())}).map_error([&](Error error) {
        error.text = Text::tr("%1: %2").arg(path, error.text);
        return error;
    });
}

}  // namespace boresight::geomagnetism
