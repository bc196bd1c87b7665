// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/udp_server/tagged_text.h"

#include "core/base/trimmed.h"
#include "core/base/upper.h"

#include <string>

namespace boresight::udp {
namespace {

std::string opening(std::string_view tag)
{
    return "<" + std::string(tag) + ">";
}

std::string closing(std::string_view tag)
{
    return "</" + std::string(tag) + ">";
}

// "<?xml version="1.0"?>" before the rest.
std::string_view withoutDeclaration(std::string_view text)
{
    constexpr std::string_view kEnd = "?>";
    constexpr std::string_view kBegin = "<?XML";
    const bool isDeclared = upper(text.substr(0, kBegin.size())) == kBegin;
    const std::size_t end = isDeclared ? text.find(kEnd) : std::string_view::npos;
    return end == std::string_view::npos ? text : trimmed(text.substr(end + kEnd.size()));
}

}  // namespace

std::optional<std::string_view> bodyOf(std::string_view text, std::string_view tag)
{
    text = withoutDeclaration(trimmed(text));
    const std::string begin = opening(tag);
    const std::string end = closing(tag);
    if (!text.starts_with(begin) || !text.ends_with(end) || text.size() < begin.size() + end.size()) {
        return std::nullopt;
    }
    return text.substr(begin.size(), text.size() - begin.size() - end.size());
}

std::optional<std::string_view> valueOf(std::string_view text, std::string_view tag)
{
    const std::string opened = opening(tag);
    const std::size_t begin = text.find(opened);
    if (begin == std::string_view::npos) {
        return std::nullopt;
    }
    text.remove_prefix(begin + opened.size());
    const std::size_t end = text.find(closing(tag));
    return end == std::string_view::npos ? std::nullopt : std::optional(text.substr(0, end));
}

std::optional<std::vector<Field>> fieldsIn(std::string_view body)
{
    std::vector<Field> fields;
    for (body = trimmed(body); !body.empty(); body = trimmed(body)) {
        const std::size_t nameEnd = body.find('>');
        if (body.front() != '<' || nameEnd == std::string_view::npos || fields.size() == kMostFields) {
            return std::nullopt;
        }
        const std::string_view name = body.substr(1, nameEnd - 1);
        const auto value = valueOf(body, name);
        if (!value || value->find('<') != std::string_view::npos) {
            return std::nullopt;
        }
        fields.push_back({.name = name, .value = trimmed(*value)});
        body.remove_prefix(opening(name).size() + value->size() + closing(name).size());
    }
    return fields;
}

}  // namespace boresight::udp
