// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTranslator>

// The languages of the program: English, in which its texts are written, and one for each built-in translation
// (resources/translations). A language is named by its code, such as "pt". An empty code means the language of the
// system. Numbers, units and times look the same in all languages.
namespace boresight::ui {

[[nodiscard]] QStringList languages();                        // "en", "pt"
[[nodiscard]] QString languageName(const QString& language);  // in its own words: "Português"

// While the object exists, texts are in this language: those of the program, and Qt's own if its translations are
// installed. Widgets that already exist keep their language, so this comes before the first window and the station.
class Translation
{
public:
    explicit Translation(const QString& language);

private:
    QTranslator m_qt;
    QTranslator m_texts;
};

}  // namespace boresight::ui
