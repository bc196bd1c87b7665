// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/drive_check_words.h"

#include <QCoreApplication>

namespace boresight::ui {

namespace {

class DriveCheckWords
{
    Q_DECLARE_TR_FUNCTIONS(DriveCheckWords)
};

Sentence inWork(const QString& progress, const QString& otherwise)
{
    return {progress.isEmpty() ? otherwise : progress, Tone::Advisory, Symbol::Advisory};
}

}  // namespace

Sentence driveCheckSentence(const DrivesStatus& drives)
{
    if (drives.released) {
        return {DriveCheckWords::tr("The bus is released to other tools"), Tone::Advisory, Symbol::Advisory};
    }
    switch (drives.driveCheck) {
        case DriveCheckState::Running:
            return inWork(drives.driveCheckText, DriveCheckWords::tr("reading the drives"));
        case DriveCheckState::Fixing:
            return inWork(drives.driveCheckText, DriveCheckWords::tr("writing the drives"));
        case DriveCheckState::Done:
            return {drives.driveCheckText.isEmpty() ? DriveCheckWords::tr("The drives have been read")
                                                    : drives.driveCheckText};
        case DriveCheckState::NotDone:
            break;
    }
    return {
        drives.driveCheckText.isEmpty() ? DriveCheckWords::tr("The drives have not been read") : drives.driveCheckText,
        Tone::Warning, Symbol::Warning};
}

Sentence armingSentence(const DrivesStatus& drives)
{
    if (drives.released) {
        return {DriveCheckWords::tr("Nothing moves until you take it back. Then Boresight reads the drives again")};
    }
    if (!drives.armingObstacle.isEmpty()) {
        return {DriveCheckWords::tr("Nothing may move: %1").arg(drives.armingObstacle), Tone::Alarm, Symbol::Alarm};
    }
    return {drives.switchedOn ? DriveCheckWords::tr("Ready to move, drives switched on")
                              : DriveCheckWords::tr("Ready to move, drives switched off")};
}

}  // namespace boresight::ui
