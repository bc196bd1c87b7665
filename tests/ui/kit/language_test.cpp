// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/language.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/profile/setting.h"
#include "tests/ui/window_fixture.h"
#include "ui/window/main_menu.h"
#include "ui/window/stop_button.h"

#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QXmlStreamReader>

#include <optional>

// The languages of the texts. packaging/translations --check shows that no text lacks its translation.
namespace boresight::ui {
namespace {

struct Pair
{
    QString source;
    QString translation;
};

std::vector<Pair> pairsOf(const QString& language)
{
    QFile file(QStringLiteral(BORESIGHT_TRANSLATIONS "/boresight_%1.ts").arg(language));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
    QXmlStreamReader xml(&file);
    std::vector<Pair> pairs;
    QString source;
    bool counted = false;  // with a singular and a plural form
    while (!xml.atEnd()) {
        xml.readNext();
        const QStringView name = xml.isStartElement() ? xml.name() : QStringView();
        if (name == QLatin1String("message")) {
            counted = xml.attributes().hasAttribute(QLatin1String("numerus"));
        } else if (name == QLatin1String("source")) {
            source = xml.readElementText();
        } else if (name == QLatin1String(counted ? "numerusform" : "translation")) {
            pairs.push_back({.source = source, .translation = xml.readElementText()});
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return pairs;
}

QSet<QString> placeholders(const QString& text)
{
    static const QRegularExpression place(QStringLiteral("%[0-9]"));
    QSet<QString> found;
    for (auto match = place.globalMatch(text); match.hasNext();) {
        found.insert(match.next().captured());
    }
    return found;
}

// The blanks and line ends at the edges of a text that is joined with others. A translation must keep them.
QString edges(const QString& text)
{
    static const QRegularExpression outer(QStringLiteral("^(\\s*).*?(\\s*)$"),
                                          QRegularExpression::DotMatchesEverythingOption);
    const auto match = outer.match(text);
    return match.captured(1) + QLatin1Char('|') + match.captured(2);
}

class EveryTranslation : public ::testing::TestWithParam<const char*>
{};

TEST_P(EveryTranslation, KeepsPlacesMnemonicsEdgesAndStop)
{
    const std::vector<Pair> pairs = pairsOf(QLatin1String(GetParam()));
    EXPECT_GT(pairs.size(), 1000U);
    for (const Pair& pair : pairs) {
        const std::string about = pair.source.toStdString() + " -> " + pair.translation.toStdString();
        EXPECT_FALSE(pair.translation.isEmpty()) << about;
        EXPECT_EQ(placeholders(pair.source), placeholders(pair.translation)) << about;
        EXPECT_EQ(pair.source.count(QLatin1Char('&')), pair.translation.count(QLatin1Char('&'))) << about;
        EXPECT_EQ(edges(pair.source), edges(pair.translation)) << about;
        EXPECT_TRUE(!pair.source.contains(QLatin1String("STOP ")) || pair.translation.contains(QLatin1String("STOP")))
            << about;
    }
}

// Whether a text begins with a capital letter. Empty: it begins with no letter, or with a word that has no other form.
std::optional<bool> beginsLarge(const QString& text)
{
    static const QRegularExpression name(QStringLiteral("^(rotctld|moteus|q current)\\b"));
    if (text.isEmpty() || !text.front().isLetter() || name.match(text).hasMatch()) {
        return {};
    }
    return text.front().isUpper();
}

// Story: the English of 180 texts was rewritten as sentences, and their Portuguese was not.
// REQ-BASE-13: A translation is a sentence where the source is one: it begins with a capital letter and ends with a
// full stop.
TEST_P(EveryTranslation, IsASentenceWhereTheSourceIsOne)
{
    for (const Pair& pair : pairsOf(QLatin1String(GetParam()))) {
        const std::string about = pair.source.toStdString() + " -> " + pair.translation.toStdString();
        const auto source = beginsLarge(pair.source);
        const auto translation = beginsLarge(pair.translation);
        EXPECT_TRUE(!source || !translation || *source == *translation) << about;
        EXPECT_TRUE(!pair.source.endsWith(QLatin1Char('.')) || pair.translation.endsWith(QLatin1Char('.'))) << about;
    }
}

// REQ-BASE-14: The Portuguese is European everywhere, not Brazilian.
TEST(PortugueseTexts, AreOfOneVariant)
{
    static const QRegularExpression other(
        QStringLiteral("\\b(arquivos?\\b(?! \\(\\*\\.tar)|usuário|senha|controle|registro|tela|conexão|zênite|"
                       "magnetômetro|(está|estão) \\w+ndo\\b)"),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    for (const Pair& pair : pairsOf(QStringLiteral("pt"))) {
        EXPECT_FALSE(other.match(pair.translation).hasMatch()) << pair.translation.toStdString();
    }
}

INSTANTIATE_TEST_SUITE_P(All, EveryTranslation, ::testing::Values("pt"));

// REQ-BASE-08 (Language.*): Every text for people can be translated. Without a translation it is the English of the
// source.
TEST(Language, TextsAreEnglishWithoutATranslationAndAfterIt)
{
    EXPECT_EQ(Text::tr("the horizon"), QStringLiteral("the horizon"));
    {
        const Translation portuguese(QStringLiteral("pt"));
        EXPECT_EQ(Text::tr("the horizon"), QStringLiteral("horizonte"));
        EXPECT_EQ(failure(ErrorCode::Io, Text::tr("the horizon")).value().text, QStringLiteral("horizonte"));
    }
    {
        const Translation english(QStringLiteral("en"));
        EXPECT_EQ(Text::tr("the horizon"), QStringLiteral("the horizon"));
    }
    {
        const Translation unknown(QStringLiteral("xx"));
        EXPECT_EQ(Text::tr("the horizon"), QStringLiteral("the horizon"));
    }
    EXPECT_EQ(Text::tr("the horizon"), QStringLiteral("the horizon"));
}

TEST(Language, EverySettingIsExplained)
{
    const Translation portuguese(QStringLiteral("pt"));
    for (const profile::Setting& setting : profile::settings()) {
        EXPECT_NE(Text::of(setting.text), toQString(setting.text)) << setting.key;
    }
}

TEST(Language, EveryAlarmIsTranslated)
{
    const Translation portuguese(QStringLiteral("pt"));
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        for (const char* const text : {entry->what, entry->action, entry->remedy}) {
            const bool isArgument = *text == '%' && QLatin1String(text).size() == 2;
            EXPECT_TRUE(isArgument || Text::of(text) != toQString(text)) << entry->id << ": " << text;
        }
    }
}

TEST(Language, ThereAreEnglishAndPortuguese)
{
    EXPECT_EQ(languages(), QStringList({QStringLiteral("en"), QStringLiteral("pt")}));
    EXPECT_EQ(languageName(QStringLiteral("en")), QStringLiteral("English"));
    EXPECT_EQ(languageName(QStringLiteral("pt")), QStringLiteral("Português"));
}

TEST(Language, SourcesOfLinesAreTranslated)
{
    EXPECT_EQ(sourceText(QStringLiteral("azimuth drive")), QStringLiteral("azimuth drive"));
    EXPECT_EQ(sourceText(QStringLiteral("rotctld 127.0.0.1:4533")), QStringLiteral("rotctld 127.0.0.1:4533"));
    const Translation portuguese(QStringLiteral("pt"));
    EXPECT_EQ(sourceText(QStringLiteral("azimuth drive")), QStringLiteral("acionamento de azimute"));
    EXPECT_EQ(sourceText(QStringLiteral("operator")), QStringLiteral("operador"));
}

struct InPortuguese
{
    Translation translation{QStringLiteral("pt")};  // before the window
};

class PortugueseWindowTest : private InPortuguese, public WindowFixture
{};

TEST_F(PortugueseWindowTest, StopIsStopAndStateWordsAreTranslated)
{
    const auto* const stop = window.findChild<StopButton*>();
    ASSERT_NE(stop, nullptr);
    EXPECT_EQ(stop->accessibleName(), QStringLiteral("STOP"));
    give(samples::update(samples::tracking(330)));
    EXPECT_EQ(text("Estado da estação"), QStringLiteral("RASTREIO"));
    EXPECT_EQ(text("Estado de azimute"), QStringLiteral("MOVE-SE"));
}

class LanguageChoiceTest : public WindowFixture
{};

TEST_F(LanguageChoiceTest, IsMadeInTheMenuForTheNextStart)
{
    QSignalSpy changed(&window, &MainWindow::languageChanged);
    const QMenu* languages = nullptr;
    for (const QAction* const action : window.findChild<MainMenu*>()->actions()) {
        languages = action->text() == QLatin1String("Language") ? action->menu() : languages;
    }
    ASSERT_NE(languages, nullptr);
    const auto actions = languages->actions();
    ASSERT_EQ(actions.size(), 5);
    EXPECT_EQ(actions[0]->text(), QStringLiteral("System"));
    EXPECT_TRUE(actions[0]->isChecked());
    EXPECT_EQ(actions[2]->text(), QStringLiteral("Português"));
    actions[2]->trigger();
    ASSERT_EQ(changed.size(), 1);
    EXPECT_EQ(changed.front().front().toString(), QStringLiteral("pt"));
    EXPECT_EQ(window.windowTitle(), QStringLiteral("Boresight"));
    EXPECT_EQ(actions.back()->text(), QStringLiteral("Changes at the next start"));
}

}  // namespace
}  // namespace boresight::ui
