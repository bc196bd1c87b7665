// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include <string>
#include <string_view>

// What a person reads is translated where it is made: into the language of the translator that the program installed
// before. boresightd and boresightctl install none, and so do the tests: there it is the English of the source. Texts
// that programs read - keys, causes of alarms, what is sent to clients and drives - are not made by this. Any thread.
namespace boresight {

class Text
{
    Q_DECLARE_TR_FUNCTIONS(Text)

public:
    // Of a text that was marked elsewhere: QT_TRANSLATE_NOOP("Text", "…"). Unmarked ones stay as they are.
    [[nodiscard]] static QString of(std::string_view marked) { return tr(std::string(marked).c_str()); }
};

[[nodiscard]] inline QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace boresight
