// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"

namespace boresight::profile {

using namespace makers;

namespace {

Result<> checkPath(const std::string& path)
{
    return path.starts_with('/') ? Result<>{}
                                 : failure(ErrorCode::InvalidInput, Text::tr("a path from / on is expected"));
}

}  // namespace

void addOrbit(std::vector<Setting>& list)
{
    list.push_back(textList(
        "orbit.elements", kNow,
        {QT_TRANSLATE_NOOP("Text", "Element files"),
         QT_TRANSLATE_NOOP("Text",
                           "Files and folders with the orbital elements of satellites: TLE, or OMM as JSON, CSV, XML "
                           "or KVN. Empty: the satellites of Gpredict on this computer.")},
        [](auto& p) -> auto& { return p.orbit.elements; }, checkPath));
    list.push_back(number(
        "orbit.oldest_days", "d", {1.0, 3650.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Oldest elements"),
         QT_TRANSLATE_NOOP("Text",
                           "Satellites with older elements are not tracked. The error of a low orbit grows by some "
                           "kilometres a day.")},
        [](auto& p) -> auto& { return p.orbit.oldestDays; }));
    list.push_back(number(
        "orbit.lead_s", "s", {-1.0, 1.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Lead of the set-points"),
         QT_TRANSLATE_NOOP("Text", "A tracked satellite is aimed at where it is this much later.")},
        [](auto& p) -> auto& { return p.orbit.lead; }));
}

}  // namespace boresight::profile
