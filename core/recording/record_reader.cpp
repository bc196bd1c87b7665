// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/record_reader.h"

#include "core/base/text.h"
#include "core/recording/block.h"
#include "core/recording/channel.h"
#include "core/recording/record_json.h"
#include "core/recording/record_writer.h"

#include <QFile>

#include <iterator>
#include <utility>

namespace boresight::recording {
namespace {

// A header has about 5 kB. This is enough to read it from the beginning of a file.
constexpr qint64 kHeaderEnough = 200'000;

// A recording of an hour with its events has less than 20 MB.
constexpr qint64 kLargestFile = 200'000'000;

// So many markers without a block in a row do not come from damage.
constexpr int kMostTries = 1000;

constexpr qsizetype kFirstBlockAt = kFileMark.size() + 1;

Result<Described<Header>> describedHeader(QByteArrayView bytes)
{
    if (bytes.size() < kFirstBlockAt || !bytes.startsWith(kFileMark)) {
        return failure(ErrorCode::Protocol,
                       Text::tr("this is not a recording of a pass. The mark at its first 8 bytes is missing"));
    }
    if (const char version = bytes[kFileMark.size()]; version != kFormatVersion) {
        return failure(ErrorCode::Protocol,
                       Text::tr("byte 8: the recording has version %1, but this program reads version %2. Read it with "
                                "the program that wrote it")
                           .arg(static_cast<unsigned char>(version))
                           .arg(static_cast<int>(kFormatVersion)));
    }
    const auto block = blockAt(bytes.sliced(kFirstBlockAt));
    const auto header = block && block->kind == kHeaderBlock ? readHeaderJson(block->content) : std::nullopt;
    if (!header) {
        return failure(ErrorCode::Protocol,
                       Text::tr("byte %1: the header of the recording is damaged or cut. Its ticks cannot be read "
                                "without the header")
                           .arg(kFirstBlockAt));
    }
    return *header;
}

// Collects the blocks of a file.
class BlockCollector
{
public:
    explicit BlockCollector(Described<Header> header) : m_channels(std::move(header.channels))
    {
        m_recording.header = std::move(header.value);
    }

    void takeAll(QByteArrayView bytes)
    {
        for (qsizetype at = kFirstBlockAt; at < bytes.size();) {
            if (const auto block = blockAt(bytes.sliced(at))) {
                take(*block, at);
                at += block->size();
            } else {
                at = passOver(bytes, at);
            }
        }
        if (!m_recording.hasEnd) {
            m_recording.problems.append(
                Text::tr("byte %1: the recording has no end. Its last seconds may be missing").arg(bytes.size()));
        }
    }

    [[nodiscard]] Recording taken() { return std::move(m_recording); }

private:
    // Returns where the next whole block begins, or the end of the bytes.
    qsizetype passOver(QByteArrayView bytes, qsizetype damaged)
    {
        qsizetype next = bytes.indexOf(kBlockMarker, damaged + 1);
        for (int tries = 1; next >= 0 && !blockAt(bytes.sliced(next)); ++tries) {
            next = tries < kMostTries ? bytes.indexOf(kBlockMarker, next + 1) : -1;
        }
        next = next >= 0 ? next : bytes.size();
        m_recording.problems.append(
            Text::tr("bytes %1 to %2 are damaged or cut. They are left out").arg(damaged).arg(next - 1));
        return next;
    }

    void take(const Block& block, qsizetype at)
    {
        if (!isTaken(block)) {
            m_recording.problems.append(Text::tr("byte %1: the content of block \"%2\" is not readable. It is left out")
                                            .arg(at)
                                            .arg(QChar::fromLatin1(block.kind)));
        }
    }

    [[nodiscard]] bool isTaken(const Block& block)
    {
        switch (block.kind) {
            case kTickBlock:
                return takeTickBlock(block.content);
            case kEventBlock:
                return append(m_recording.events, readEventsJson(block.content));
            case kPlanBlock:
                return takePlan(block.content);
            case kGapBlock: {
                const auto gap = readGapJson(block.content);
                if (gap) {
                    m_recording.gaps.push_back(*gap);
                }
                return gap.has_value();
            }
            case kEndBlock:
                m_recording.hasEnd = true;
                return true;
            default:
                return true;  // the header, or a block of a later program
        }
    }

    template <class Value>
    [[nodiscard]] static bool append(std::vector<Value>& to, const std::optional<std::vector<Value>>& more)
    {
        if (more) {
            to.insert(to.end(), more->begin(), more->end());
        }
        return more.has_value();
    }

    [[nodiscard]] bool takeTickBlock(QByteArrayView content)
    {
        ByteSource source(content);
        return append(m_recording.ticks, takeTicks(source, m_channels, kMostTicks - m_recording.ticks.size()));
    }

    [[nodiscard]] bool takePlan(QByteArrayView content)
    {
        ByteSource source(content);
        const auto length = source.varint();
        const auto json = length ? source.bytes(*length) : std::nullopt;
        auto plan = json ? readPlanJson(*json) : std::nullopt;
        auto moments = plan ? takeMoments(source, plan->channels) : std::nullopt;
        if (!moments || moments->empty()) {
            return false;
        }
        plan->value.moments = std::move(*moments);
        m_recording.plan = std::move(plan->value);
        return true;
    }

    std::vector<WrittenChannel> m_channels;
    Recording m_recording;
};

// With the name of the file before the reason.
template <class Value>
Result<Value> ofFile(const QString& path, const Result<Value>& read)
{
    return read.map_error([&path](const Error& error) {
        return Error{error.code, QStringLiteral("%1: %2").arg(path, error.text)};
    });
}

Result<QByteArray> fileBytes(const QString& path, qint64 most)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::Io, Text::tr("cannot read: %1").arg(file.errorString()));
    }
    return file.read(most);
}

}  // namespace

Result<Recording> readRecording(QByteArrayView bytes)
{
    return describedHeader(bytes).map([bytes](const Described<Header>& header) {
        BlockCollector collector(header);
        collector.takeAll(bytes);
        return collector.taken();
    });
}

Result<Header> readHeader(QByteArrayView bytes)
{
    return describedHeader(bytes).map([](const Described<Header>& header) { return header.value; });
}

Result<Recording> loadRecording(const QString& path)
{
    return ofFile(path,
                  fileBytes(path, kLargestFile).and_then([](const QByteArray& bytes) { return readRecording(bytes); }));
}

Result<Header> loadHeader(const QString& path)
{
    return ofFile(path,
                  fileBytes(path, kHeaderEnough).and_then([](const QByteArray& bytes) { return readHeader(bytes); }));
}

}  // namespace boresight::recording
