// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/numbers.h"
#include "core/base/result.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <optional>
#include <string>

// What the station answers when it is asked for lines of the protocol log: each line has its number first. Pure.
namespace boresight::ctl {

struct ProtocolPage
{
    std::string text;       // the lines without their numbers
    std::int64_t last = 0;  // the number of the newest line
    std::int64_t lost = 0;  // lines after the last known one that the station does not keep any more
    bool isNewLog = false;  // the station began to count again, because it connected again or was restarted
};

// `last` is the number of the newest line that is known. Empty: the answer is unreadable.
[[nodiscard]] inline std::optional<ProtocolPage> readProtocolPage(std::int64_t last, const QByteArray& answer)
{
    ProtocolPage page{.last = last};
    for (qsizetype begin = 0; begin < answer.size();) {
        const qsizetype tab = answer.indexOf('\t', begin);
        const qsizetype end = answer.indexOf('\n', begin);
        const auto number = parseInteger(answer.mid(begin, tab - begin).toStdString());
        if (end < 0 || tab < 0 || tab > end || !number) {
            return std::nullopt;
        }
        if (begin == 0 && *number <= page.last) {
            page.isNewLog = true;
            page.last = 0;
        }
        page.lost += *number - page.last - 1;
        page.last = *number;
        page.text += answer.mid(tab + 1, end - tab).toStdString();
        begin = end + 1;
    }
    return page;
}

}  // namespace boresight::ctl
