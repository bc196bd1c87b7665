// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/journal_text.h"

#include "core/base/text.h"
#include "core/journal/journal_fields.h"
#include "core/records/json_reader.h"
#include "core/records/json_writer.h"

#include <QCryptographicHash>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace boresight::journal {
namespace {

constexpr int kVersion = 1;
const QString kVersionKey = QStringLiteral("boresight_memory");
const QString kChecksumKey = QStringLiteral("checksum");
const QString kJournalKey = QStringLiteral("memory");

Result<MountJournal> readJournal(const QJsonObject& payload)
{
    MountJournal journal;
    return records::JsonReader::read(payload, kJournalKey,
                                     [&](records::JsonReader& reader) { record::journalFields(reader, journal); })
        .map([&] { return journal; });
}

// The checksum of the canonical form of the parsed JSON. Spaces do not count, everything else does.
QString checksum(const QJsonObject& payload)
{
    const QByteArray text = QJsonDocument(payload).toJson(QJsonDocument::Compact);
    return QString::fromLatin1(QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex());
}

Result<QJsonObject> readRoot(const QByteArray& text)
{
    const bool blank = std::all_of(text.begin(), text.end(), [](char c) { return c == '\0' || c == ' ' || c == '\n'; });
    if (blank) {  // after a power cut a file system may leave an empty file, or zeros
        return failure(ErrorCode::InvalidInput, Text::tr("it is empty"));
    }
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("it is damaged at byte %1: %2").arg(error.offset).arg(error.errorString()));
    }
    const QJsonObject root = document.object();
    if (!root.value(kVersionKey).isDouble()) {
        return failure(ErrorCode::InvalidInput, Text::tr("it is not a position journal"));
    }
    return root;
}

}  // namespace

Result<QByteArray> toText(const MountJournal& journal)
{
    MountJournal copy = journal;
    records::JsonWriter writer;
    record::journalFields(writer, copy);
    const QJsonObject payload = writer.written();
    return readJournal(payload).map([&](const MountJournal&) {
        const QJsonObject root{{kVersionKey, kVersion}, {kChecksumKey, checksum(payload)}, {kJournalKey, payload}};
        return QJsonDocument(root).toJson(QJsonDocument::Indented);
    });
}

Result<MountJournal> parseJournal(const QByteArray& text)
{
    const Result<QJsonObject> root = readRoot(text);
    if (!root) {
        return tl::unexpected(root.error());
    }
    if (const double version = root->value(kVersionKey).toDouble(); version != kVersion) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("it has version %1, but this program reads version %2").arg(version).arg(kVersion));
    }
    const QJsonObject payload = root->value(kJournalKey).toObject();
    if (root->value(kChecksumKey).toString() != checksum(payload)) {
        return failure(ErrorCode::InvalidInput, Text::tr("its checksum is wrong, so it was changed or damaged"));
    }
    return readJournal(payload);
}

}  // namespace boresight::journal
