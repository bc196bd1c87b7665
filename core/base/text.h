// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include <string>
#include <string_view>

// Texts for people are translated where they are made, by the translator that the program installed before. boresightd,
// boresightctl and the tests install none, so their texts are the English of the source. Texts that programs read
// (keys, causes of alarms, messages to clients and drives) are not made with this class. Any thread.
namespace boresight {

class Text
{
    Q_DECLARE_TR_FUNCTIONS(Text)

public:
    // Translates a text that was marked elsewhere with QT_TRANSLATE_NOOP("Text", "…"). An unmarked text stays
    // unchanged.
    [[nodiscard]] static QString of(std::string_view marked) { return tr(std::string(marked).c_str()); }
};

[[nodiscard]] inline QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace boresight
