// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/record_reader.h"

#include "core/base/text.h"
#include "core/recording/block.h"
#include "core/recording/channel.h"
#include "core/recording/record_json.h"
#include "core/recording/record_writer.h"

#include <QFile>

#include <algorithm>
#include <utility>

namespace boresight::recording {
namespace {

// A header has about 5 kB. This is enough to read it from the beginning of a file.
constexpr qint64 kHeaderEnough = 200'000;

// A recording of an hour with its events has less than 20 MB.
constexpr qint64 kLargestFile = 200'000'000;

// More markers without a block, or more of their bytes, do not come from damage. They would only take time.
constexpr int kMostTries = 10'000;
constexpr qint64 kMostTried = 500'000'000;

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
            if (const auto block = tryBlock(bytes.sliced(at))) {
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
    // Counts what a block costs that is none.
    [[nodiscard]] std::optional<Block> tryBlock(QByteArrayView bytes)
    {
        const auto block = blockAt(bytes);
        if (!block) {
            ++m_tries;
            m_tried += coveredBytes(bytes);
        }
        return block;
    }

    // Returns where the next whole block begins, or the end of the bytes.
    qsizetype passOver(QByteArrayView bytes, qsizetype damaged)
    {
        const auto after = [&](qsizetype at) {
            const bool mayTry = m_tries < kMostTries && m_tried < kMostTried;
            return mayTry ? bytes.indexOf(kBlockMarker, at + 1) : -1;
        };
        qsizetype next = after(damaged);
        while (next >= 0 && !tryBlock(bytes.sliced(next))) {
            next = after(next);
        }
        next = next >= 0 ? next : bytes.size();
        addProblem(Text::tr("bytes %1 to %2 are damaged or cut. They are left out").arg(damaged).arg(next - 1));
        return next;
    }

    void take(const Block& block, qsizetype at)
    {
        if (!isTaken(block)) {
            addProblem(Text::tr("byte %1: the content of block \"%2\" is not readable or too much. It is left out")
                           .arg(at)
                           .arg(QChar::fromLatin1(block.kind)));
        }
    }

    void addProblem(const QString& problem)
    {
        const qsizetype count = m_recording.problems.size();
        if (count < kMostProblems) {
            m_recording.problems.append(count + 1 < kMostProblems ? problem : Text::tr("further damage is not listed"));
        }
    }

    [[nodiscard]] bool isTaken(const Block& block)
    {
        switch (block.kind) {
            case kTickBlock:
                return takeTickBlock(block.content);
            case kEventBlock:
                return takeEvents(block.content);
            case kPlanBlock:
                return takePlan(block.content);
            case kGapBlock:
                return takeGap(block.content);
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
        const auto ticks = takeTicks(source, m_channels, kMostTicks - m_recording.ticks.size());
        const bool isOfTheTime = ticks && std::ranges::all_of(*ticks, isRecordable, &Tick::utc);
        return isOfTheTime && append(m_recording.ticks, ticks);
    }

    [[nodiscard]] bool takeEvents(QByteArrayView content)
    {
        const std::size_t room = kMostEvents - m_recording.events.size();
        const auto events = room > 0 ? readEventsJson(content) : std::nullopt;
        return events && events->size() <= room && append(m_recording.events, events);
    }

    [[nodiscard]] bool takeGap(QByteArrayView content)
    {
        const auto gap = m_recording.gaps.size() < kMostGaps ? readGapJson(content) : std::nullopt;
        if (gap) {
            m_recording.gaps.push_back(*gap);
        }
        return gap.has_value();
    }

    [[nodiscard]] bool takePlan(QByteArrayView content)
    {
        if (m_plans >= kMostPlans) {
            return false;
        }
        ++m_plans;
        ByteSource source(content);
        const auto length = source.varint();
        const auto json = length ? source.bytes(*length) : std::nullopt;
        auto plan = json ? readPlanJson(*json) : std::nullopt;
        auto moments = plan ? takeMoments(source, plan->channels) : std::nullopt;
        if (!moments || moments->empty() || !std::ranges::all_of(*moments, isRecordable, &plan::PlannedMoment::utc)) {
            return false;
        }
        plan->value.moments = std::move(*moments);
        m_recording.plan = std::move(plan->value);
        return true;
    }

    std::vector<WrittenChannel> m_channels;
    Recording m_recording;
    int m_plans = 0;
    int m_tries = 0;     // of blocks that are none
    qint64 m_tried = 0;  // their bytes
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
