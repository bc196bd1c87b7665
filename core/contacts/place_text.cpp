// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contacts/place_text.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"

namespace boresight::contacts {
namespace {

constexpr std::size_t kLongest = 1000;  // bytes

}  // namespace

Result<> checkLine(const std::string& text)
{
    return text.size() <= kLongest && !hasControlCharacters(text)
               ? Result<>{}
               : failure(ErrorCode::InvalidInput, Text::tr("one line of at most 1000 bytes is expected"));
}

Result<QString> checkedPath(const QString& path)
{
    return path.startsWith(QLatin1Char('/')) && !path.endsWith(QLatin1Char('/'))
               ? Result<QString>(path)
               : failure(ErrorCode::InvalidInput, Text::tr("a path from / on is expected after the colon"));
}

Result<QString> checkedTopic(const QString& topic)
{
    const bool isTopic = !topic.isEmpty() && !topic.startsWith(QLatin1Char('$')) && !topic.contains(QLatin1Char('+')) &&
                         !topic.contains(QLatin1Char('#'));
    return isTopic
               ? Result<QString>(topic)
               : failure(ErrorCode::InvalidInput, Text::tr("a topic is expected after the colon, without + # and $"));
}

}  // namespace boresight::contacts
