// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/survey_words.h"

#include <QCoreApplication>

namespace boresight::ui {

namespace {

class SurveyWords
{
    Q_DECLARE_TR_FUNCTIONS(SurveyWords)
};

Sentence inWork(const QString& progress, const QString& otherwise)
{
    return {progress.isEmpty() ? otherwise : progress, Tone::Advisory, Symbol::Advisory};
}

}  // namespace

Sentence surveySentence(const DrivesStatus& drives)
{
    if (drives.released) {
        return {SurveyWords::tr("The bus is released to other tools"), Tone::Advisory, Symbol::Advisory};
    }
    switch (drives.survey) {
        case SurveyState::Running:
            return inWork(drives.surveyText, SurveyWords::tr("reading the drives"));
        case SurveyState::Fixing:
            return inWork(drives.surveyText, SurveyWords::tr("writing the drives"));
        case SurveyState::Done:
            return {drives.surveyText.isEmpty() ? SurveyWords::tr("The drives have been read") : drives.surveyText};
        case SurveyState::NotDone:
            break;
    }
    return {drives.surveyText.isEmpty() ? SurveyWords::tr("The drives have not been read") : drives.surveyText,
            Tone::Warning, Symbol::Warning};
}

Sentence armingSentence(const DrivesStatus& drives)
{
    if (drives.released) {
        return {SurveyWords::tr("Nothing moves until you take it back. Then Boresight reads the drives again")};
    }
    if (!drives.armingObstacle.isEmpty()) {
        return {SurveyWords::tr("Nothing may move: %1").arg(drives.armingObstacle), Tone::Alarm, Symbol::Alarm};
    }
    return {drives.switchedOn ? SurveyWords::tr("Ready to move, drives switched on")
                              : SurveyWords::tr("Ready to move, drives switched off")};
}

}  // namespace boresight::ui
