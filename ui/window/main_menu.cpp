// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_menu.h"

#include "ui/kit/language.h"
#include "ui/look/glyph.h"

#include <QActionGroup>
#include <QApplication>
#include <QKeyEvent>

#include <algorithm>

namespace boresight::ui {

namespace {

// The shortcuts of the window handle the keys. The menu only shows them.
QString withKey(const QString& text, const QString& key)
{
    return key.isEmpty() ? text : text + QLatin1Char('\t') + key;
}

}  // namespace

MainMenu::MainMenu(const QString& language, QWidget& window)
    : QMenu(&window), m_window(window), m_themes(new QActionGroup(this)), m_brightnesses(new QActionGroup(this))
{
    setFont(fonts::label());
    setAccessibleName(tr("Menu"));
    setToolTipsVisible(true);
    addThemes();
    addBrightness();
    addLine(Glyph::Screen, tr("Full screen"), QStringLiteral("F11"), &MainMenu::fullScreenWanted);
    addLanguages(language);
    addSeparator();
    addLine(Glyph::Guide, tr("Commissioning guide"), QStringLiteral("F3"), &MainMenu::guideWanted);
    addLine(Glyph::Profile, tr("Open profile"), QStringLiteral("Ctrl+8"), &MainMenu::profileWanted);
    addLine(Glyph::Charts, tr("Open recording …"), {}, &MainMenu::recordingWanted);
    addLine(Glyph::Guide, tr("Read the manual"), QStringLiteral("F1"), &MainMenu::manualWanted);
    addLine(Glyph::Keys, tr("Show keys"), QStringLiteral("Shift+F1"), &MainMenu::keysWanted);
    addLine(Glyph::Diagnostics, tr("Save diagnostics …"), QStringLiteral("Ctrl+B"), &MainMenu::diagnosticsWanted);
    addLine(Glyph::About, tr("About Boresight"), {}, &MainMenu::aboutWanted);
    connect(this, &QMenu::aboutToShow, this, &MainMenu::showChoice);
    QApplication::instance()->installEventFilter(this);
}

void MainMenu::addThemes()
{
    for (const ThemeKind kind : {ThemeKind::Day, ThemeKind::Night, ThemeKind::Red}) {
        QAction* const action = addAction(themePicture(kind), QString());
        action->setData(static_cast<int>(kind));
        action->setCheckable(true);
        action->setIconVisibleInMenu(true);
        m_themes->addAction(action);
        connect(action, &QAction::triggered, this, [this, kind] { Q_EMIT themeChosen(kind, currentBrightness()); });
    }
}

void MainMenu::addBrightness()
{
    m_brightness = addMenu(glyphIcon(Glyph::Brightness), tr("Brightness"));
    m_brightness->setFont(font());
    m_brightness->setToolTip(tr("The brightness of the night and the red theme"));
    for (const Brightness step : {Brightness::High, Brightness::Medium, Brightness::Low}) {
        QAction* const action = m_brightness->addAction(name(step));
        action->setData(static_cast<int>(step));
        action->setCheckable(true);
        m_brightnesses->addAction(action);
        connect(action, &QAction::triggered, this, [this, step] { Q_EMIT themeChosen(currentTheme().kind, step); });
    }
}

void MainMenu::addLanguages(const QString& chosen)
{
    QMenu* const menu = addMenu(glyphIcon(Glyph::Language), tr("Language"));
    menu->setFont(font());
    auto* const group = new QActionGroup(menu);
    const auto add = [&](const QString& text, const QString& language) {
        QAction* const action = menu->addAction(text);
        action->setCheckable(true);
        action->setChecked(language == chosen);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, language] { Q_EMIT languageChosen(language); });
    };
    add(tr("System"), {});
    for (const QString& language : languages()) {
        add(languageName(language), language);
    }
    menu->addSeparator();
    menu->addAction(tr("Changes at the next start"))->setEnabled(false);
}

void MainMenu::addLine(Glyph glyph, const QString& text, const QString& key, void (MainMenu::*wanted)())
{
    connect(addAction(glyphIcon(glyph), withKey(text, key)), &QAction::triggered, this, wanted);
}

void MainMenu::showChoice()
{
    const ThemeKind now = currentTheme().kind;
    for (QAction* const action : m_themes->actions()) {
        const auto kind = static_cast<ThemeKind>(action->data().toInt());
        action->setChecked(kind == now);
        action->setText(withKey(name(kind), kind == next(now) ? QStringLiteral("Ctrl+D") : QString()));
    }
    for (QAction* const action : m_brightnesses->actions()) {
        action->setChecked(static_cast<Brightness>(action->data().toInt()) == currentBrightness());
    }
    m_brightness->setEnabled(now != ThemeKind::Day);
}

// The right edge of the menu is at that of the button, so the menu never covers STOP, which is farther right.
void MainMenu::openBelow(const QWidget& button)
{
    const QPoint corner = button.mapToGlobal(QPoint(button.width() - sizeHint().width(), button.height() + 2));
    popup(corner);
    setActiveAction(actions().front());
}

// Alt is pressed and released without another key in between. Alt+Left and similar are other keys. For a key that is a
// shortcut Qt sends only the ShortcutOverride, and no KeyPress.
bool MainMenu::eventFilter(QObject* watched, QEvent* event)
{
    const bool isPress = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    const bool isRelease = event->type() == QEvent::KeyRelease;
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::WindowDeactivate) {
        m_altAlone = false;
    } else if (isRelease || isPress) {
        const auto* const key = static_cast<QKeyEvent*>(event);
        const bool isAlt = key->key() == Qt::Key_Alt;
        if (isRelease && isAlt && m_altAlone && m_window.isActiveWindow()) {
            Q_EMIT openWanted();
        }
        m_altAlone = isAlt && isPress && (key->modifiers() & ~Qt::AltModifier) == Qt::NoModifier;
    }
    return QMenu::eventFilter(watched, event);
}

}  // namespace boresight::ui

#include "moc_main_menu.cpp"
