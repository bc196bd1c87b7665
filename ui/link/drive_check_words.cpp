// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/drive_check_words.h"

#include "ui/kit/axes.h"

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

Sentence armingSentence(const StationStatus& status)
{
    const DrivesStatus& drives = drivesOf(status);
    if (drives.released) {
        return {DriveCheckWords::tr("Nothing moves until you take it back. Then Boresight reads the drives again")};
    }
    if (!drives.armingObstacle.isEmpty()) {
        return {DriveCheckWords::tr("Nothing may move: %1").arg(drives.armingObstacle), Tone::Alarm, Symbol::Alarm};
    }
    if (status.state == StationState::Fault) {
        return {DriveCheckWords::tr("Nothing moves until you press Re-arm"), Tone::Warning, Symbol::Warning};
    }
    const bool azimuthIsOff = status.azimuth.state == AxisState::Off;
    if (drives.switchedOn && azimuthIsOff != (status.elevation.state == AxisState::Off)) {
        return {azimuthIsOff ? DriveCheckWords::tr("The azimuth drive is switched off, the elevation drive is on")
                             : DriveCheckWords::tr("The elevation drive is switched off, the azimuth drive is on")};
    }
    return {drives.switchedOn ? DriveCheckWords::tr("Ready to move, drives switched on")
                              : DriveCheckWords::tr("Ready to move, drives switched off")};
}

}  // namespace boresight::ui
