// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnostics/tar_archive.h"

#include "core/base/save_whole.h"
#include "core/base/text.h"

#include <QSaveFile>

#include <archive.h>
#include <archive_entry.h>

#include <memory>

namespace boresight::diagnostics {

namespace {

using Writer = std::unique_ptr<archive, int (*)(archive*)>;
using Entry = std::unique_ptr<archive_entry, void (*)(archive_entry*)>;

la_ssize_t keep(archive*, void* bytes, const void* block, std::size_t size)
{
    static_cast<QByteArray*>(bytes)->append(static_cast<const char*>(block), static_cast<qsizetype>(size));
    return static_cast<la_ssize_t>(size);
}

Error broken(const Writer& writer)
{
    const char* const reason = archive_error_string(writer.get());
    return {ErrorCode::Io, reason != nullptr ? toQString(reason) : QStringLiteral("the archive could not be made")};
}

bool add(const Writer& writer, const ArchiveFile& file, std::time_t when)
{
    constexpr int kReadable = 0644;
    const Entry entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname_utf8(entry.get(), file.name.toUtf8().constData());
    archive_entry_set_size(entry.get(), file.bytes.size());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), kReadable);
    archive_entry_set_mtime(entry.get(), when, 0);
    const auto size = static_cast<std::size_t>(file.bytes.size());
    return archive_write_header(writer.get(), entry.get()) == ARCHIVE_OK &&
           archive_write_data(writer.get(), file.bytes.constData(), size) == static_cast<la_ssize_t>(size);
}

Result<QByteArray> packed(const std::vector<ArchiveFile>& files, UtcTime when)
{
    QByteArray bytes;
    const Writer writer(archive_write_new(), archive_write_free);
    if (archive_write_add_filter_gzip(writer.get()) != ARCHIVE_OK ||
        archive_write_set_format_pax_restricted(writer.get()) != ARCHIVE_OK ||
        archive_write_open(writer.get(), &bytes, nullptr, keep, nullptr) != ARCHIVE_OK) {
        return tl::unexpected(broken(writer));
    }
    for (const ArchiveFile& file : files) {
        if (!add(writer, file, std::chrono::system_clock::to_time_t(when))) {
            return tl::unexpected(broken(writer));
        }
    }
    if (archive_write_close(writer.get()) != ARCHIVE_OK) {
        return tl::unexpected(broken(writer));
    }
    return bytes;
}

}  // namespace

Result<> writeArchive(const QString& path, const std::vector<ArchiveFile>& files, UtcTime when)
{
    return packed(files, when).and_then([&](const QByteArray& bytes) -> Result<> {
        QSaveFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
            return failure(ErrorCode::Io, QStringLiteral("%1: %2").arg(path, file.errorString()));
        }
        if (const auto why = saveWhole(file)) {
            return failure(ErrorCode::Io, QStringLiteral("%1: %2").arg(path, *why));
        }
        return {};
    });
}

}  // namespace boresight::diagnostics
