// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/window_fixture.h"
#include "ui/kit/language.h"

#include <QByteArray>
#include <QList>

#include <ostream>

// Pictures of the window to look at, and the checks that a program can do on them. A test puts a scene on the screen
// once and draws it at every size and scale. With the environment variable BORESIGHT_PICTURES=FOLDER each picture is
// kept as FOLDER/SCENE-EDITION-VIEW.png. An edition (a theme, or Portuguese) is a separate test, so that editions run
// in parallel.
namespace boresight::ui {

struct Edition
{
    const char* name;  // in the file's name
    ThemeKind theme;
    const char* language;
};

void PrintTo(const Edition& edition, std::ostream* out);

inline const auto kThemes =
    ::testing::Values(Edition{"day", ThemeKind::Day, "en"}, Edition{"night", ThemeKind::Night, "en"},
                      Edition{"red", ThemeKind::Red, "en"});
inline const auto kThemesAndPortuguese =
    ::testing::Values(Edition{"day", ThemeKind::Day, "en"}, Edition{"night", ThemeKind::Night, "en"},
                      Edition{"red", ThemeKind::Red, "en"}, Edition{"pt", ThemeKind::Day, "pt"});

[[nodiscard]] std::string editionName(const ::testing::TestParamInfo<Edition>& test);

// The language applies before the window is made.
class InAnEdition : public ::testing::WithParamInterface<Edition>
{
protected:
    InAnEdition();

private:
    Translation m_translation;
};

class PictureBook : public InAnEdition, public WindowFixture
{
protected:
    PictureBook();
    ~PictureBook() override;

    // Shows this status after a pass, so that there are a path in the sky, charts and a log, and opens the panel with
    // this key.
    void show(const StationStatus& status, char panel);
    void take(const QString& scene);
    // The accessible name of a widget in the language of this edition.
    static QByteArray translated(const char* className, const char* english);

    // The labels that may never be cut off while they are visible: all in the header and the axes except their long
    // sentences, and those that a test adds.
    QList<const ValueLabel*> mustBeWhole;

private:
    void resizeTo(QSize size);
    void judge();
};

}  // namespace boresight::ui
