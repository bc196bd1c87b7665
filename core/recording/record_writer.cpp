// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/record_writer.h"

#include "core/recording/block.h"
#include "core/recording/byte_source.h"
#include "core/recording/channel.h"
#include "core/recording/record_json.h"

namespace boresight::recording {

QByteArray fileStart(const Header& header)
{
    QByteArray bytes = kFileMark.toByteArray();
    bytes.append(kFormatVersion);
    return bytes + blockBytes(kHeaderBlock, headerJson(header));
}

QByteArray tickBlock(std::span<const Tick> ticks)
{
    return blockBytes(kTickBlock, rowBytes(ticks));
}

QByteArray eventBlock(std::span<const Event> events)
{
    return blockBytes(kEventBlock, eventsJson(events));
}

QByteArray planBlock(const plan::PlanVariant& plan)
{
    const QByteArray json = planJson(plan);
    QByteArray content;
    appendVarint(content, static_cast<std::uint64_t>(json.size()));
    return blockBytes(kPlanBlock, content + json + rowBytes(plan.moments));
}

QByteArray gapBlock(const Gap& gap)
{
    return blockBytes(kGapBlock, gapJson(gap));
}

QByteArray fileEnd()
{
    return blockBytes(kEndBlock, {});
}

}  // namespace boresight::recording
