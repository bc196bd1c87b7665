// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTranslator>

// The languages of the program: English, in which its texts are written, and one for each translation that is built
// in (resources/translations). A language is named by its code, "pt"; empty stands for the system's. Numbers, units
// and times look the same in all of them.
namespace boresight::ui {

[[nodiscard]] QStringList languages();                        // "en", "pt"
[[nodiscard]] QString languageName(const QString& language);  // in its own words: "Português"

// Texts are in this language from now until it goes: the program's, and Qt's own where its translations are installed.
// What has been made before keeps its language, so this comes before the first window and the station.
class Translation
{
public:
    explicit Translation(const QString& language);

private:
    QTranslator m_qt;
    QTranslator m_texts;
};

}  // namespace boresight::ui
