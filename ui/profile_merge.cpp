// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile_merge.h"

#include "core/profile/setting.h"

#include <algorithm>
#include <functional>

namespace boresight::ui {

namespace {

using profile::Profile;

struct ListSetting
{
    std::string key;
    std::function<bool(const Profile&, const Profile&)> differs;
    std::function<void(Profile&, const Profile&)> take;
};

// `list` finds the list in a profile, constant or not.
template <class Find>
ListSetting listSetting(std::string key, Find list)
{
    return {.key = std::move(key),
            .differs = [list](const Profile& a, const Profile& b) { return list(a) != list(b); },
            .take = [list](Profile& into, const Profile& from) { list(into) = list(from); }};
}

const std::vector<ListSetting>& lists()
{
    static const std::vector<ListSetting> all{
        listSetting(
            "limits.horizon", [](auto& p) -> auto& { return p.limits.horizon; }),
        listSetting(
            "limits.keep_out", [](auto& p) -> auto& { return p.limits.keepOuts; }),
        listSetting(
            "presets", [](auto& p) -> auto& { return p.presets; })};
    return all;
}

}  // namespace

std::vector<std::string> changedKeys(const Profile& from, const Profile& to)
{
    std::vector<std::string> keys;
    for (const profile::Setting& setting : profile::settings()) {
        if (setting.get(from) != setting.get(to)) {
            keys.push_back(setting.key);
        }
    }
    for (const ListSetting& list : lists()) {
        if (list.differs(from, to)) {
            keys.push_back(list.key);
        }
    }
    return keys;
}

void takeOver(Profile& into, const Profile& from, std::span<const std::string> keys)
{
    for (const std::string& key : keys) {
        if (const profile::Setting* const setting = profile::findSetting(key)) {
            (void)setting->set(into, setting->get(from));  // a value that a profile holds already
        }
        const auto list = std::ranges::find(lists(), key, &ListSetting::key);
        if (list != lists().end()) {
            list->take(into, from);
        }
    }
}

}  // namespace boresight::ui
