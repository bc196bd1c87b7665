// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/azel_file/azel_file.h"

#include "core/base/text.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace boresight::azel {
namespace {

Result<AzelText> readTextOf(const QString& path)
{
    // A pipe would block the reader.
    if (!QFileInfo(path).isFile()) {
        return failure(ErrorCode::NoDevice, Text::tr("there is no such file"));
    }
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered)) {
        return failure(ErrorCode::Denied, file.errorString());
    }
    const QByteArray bytes = file.read(static_cast<qint64>(kLongestAzelText) + 1);
    return readAzelText(std::string_view(bytes.data(), static_cast<std::size_t>(bytes.size())));
}

}  // namespace

QString azelPath(const profile::AzelSettings& settings)
{
    return settings.file.empty() ? QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
                                       QStringLiteral("/WSJT-X/azel.dat")
                                 : toQString(settings.file);
}

AzelReading readAzelFile(const QString& path)
{
    AzelReading reading{.path = path, .text = readTextOf(path)};
    if (const QDateTime written = QFileInfo(path).lastModified(); written.isValid()) {
        reading.written = UtcTime(std::chrono::milliseconds(written.toMSecsSinceEpoch()));
    }
    return reading;
}

}  // namespace boresight::azel
