// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table_file/table_file.h"

#include "core/base/text.h"
#include "core/tables/table_reader.h"

#include <QByteArray>
#include <QFile>
#include <QFileInfo>

#include <string_view>

namespace boresight::tables {
namespace {

constexpr qint64 kMostTableBytes = kMostTableMegabytes * (qint64(1) << 20);

tl::unexpected<Error> cannotRead(ErrorCode code, const QString& path, const QString& reason)
{
    return failure(code, QStringLiteral("%1: %2").arg(path, reason));
}

}  // namespace

Result<SharedTable> readTableFile(const QString& path)
{
    const QFileInfo there(path);
    if (!there.isFile()) {
        return cannotRead(ErrorCode::NoDevice, path,
                          there.exists() ? Text::tr("This is not a file. Choose a file.")
                                         : Text::tr("There is no such file. Check its path."));
    }
    QFile file(path);
    const bool isOpen = file.open(QIODevice::ReadOnly);
    const QByteArray bytes = isOpen ? file.read(kMostTableBytes + 1) : QByteArray();
    if (!isOpen || file.error() != QFileDevice::NoError) {
        return cannotRead(ErrorCode::Io, path, file.errorString());
    }
    if (bytes.size() > kMostTableBytes) {
        return cannotRead(ErrorCode::InvalidInput, path,
                          Text::tr("The file is larger than %1 MB. Split it.").arg(kMostTableMegabytes));
    }
    return readTable(std::string_view(bytes.data(), static_cast<std::size_t>(bytes.size())), path);
}

}  // namespace boresight::tables
