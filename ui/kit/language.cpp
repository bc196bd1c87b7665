// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>

namespace boresight::ui {

namespace {

const QString kEnglish = QStringLiteral("en");
const QString kFolder = QStringLiteral(":/boresight/translations");
const QString kFile = QStringLiteral("boresight_%1.qm");

// The first language of the system. If it is not translated, English is used. The other preferences of the system are
// ignored, because the user may understand them less than English.
QString systemLanguage()
{
    return QLocale::system().uiLanguages().value(0).section(QLatin1Char('-'), 0, 0);
}

// Qt has some languages only by country: the country of the system if its language matches, otherwise the usual one.
QLocale localeOf(const QString& language)
{
    return systemLanguage() == language ? QLocale::system() : QLocale(language);
}

}  // namespace

QStringList languages()
{
    QStringList found{kEnglish};
    for (const QString& file : QDir(kFolder).entryList({kFile.arg(QLatin1Char('*'))}, QDir::Files, QDir::Name)) {
        found << file.section(QLatin1Char('_'), 1).section(QLatin1Char('.'), 0, 0);
    }
    return found;
}

QString languageName(const QString& language)
{
    if (language == kEnglish) {
        return QStringLiteral("English");  // Qt would add the country
    }
    QString name = QLocale(language).nativeLanguageName();
    return name.isEmpty() ? language : name.replace(0, 1, name.at(0).toUpper());
}

Translation::Translation(const QString& language)
{
    const QString code = language.isEmpty() ? systemLanguage() : language;
    if (code == kEnglish || !m_texts.load(kFolder + QLatin1Char('/') + kFile.arg(code))) {
        return;
    }
    QCoreApplication::installTranslator(&m_texts);
    if (m_qt.load(localeOf(code), QStringLiteral("qtbase"), QStringLiteral("_"),
                  QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QCoreApplication::installTranslator(&m_qt);
    }
}

}  // namespace boresight::ui
