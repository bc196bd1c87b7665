// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/theme.h"

#include <QMenu>

#include <functional>

class QActionGroup;

// The menu behind the button in the header. It contains what belongs to the whole window and not to one panel. Each
// line shows its key. Alt alone opens the menu, and so does F10. The menu decides nothing: each line emits a signal.
namespace boresight::ui {

enum class Glyph;

class MainMenu : public QMenu
{
    Q_OBJECT

public:
    // `language` is the chosen one (ui/kit/language.h). Alt in `window` opens the menu.
    MainMenu(const QString& language, QWidget& window);

    void openBelow(const QWidget& button);

Q_SIGNALS:
    void openWanted();  // by Alt
    void themeChosen(boresight::ui::ThemeKind theme, boresight::ui::Brightness brightness);
    void languageChosen(const QString& language);
    void fullScreenWanted();
    void manualWanted();
    void keysWanted();
    void guideWanted();
    void profileWanted();
    void recordingWanted();
    void diagnosticsWanted();
    void aboutWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addThemes();
    void addBrightness();
    void addLanguages(const QString& chosen);
    void addLine(Glyph glyph, const QString& text, const QString& key, void (MainMenu::*wanted)());
    void showChoice();

    QWidget& m_window;
    QActionGroup* m_themes;
    QActionGroup* m_brightnesses;
    QMenu* m_brightness = nullptr;
    bool m_altAlone = false;
};

}  // namespace boresight::ui
