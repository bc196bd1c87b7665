// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/adapters.h"
#include "tests/ui/picture_book.h"
#include "tests/ui/sample_calibration.h"
#include "tests/ui/step_button_of.h"
#include "ui/guide/guide_boards.h"
#include "ui/guide/guide_north.h"
#include "ui/kit/axes.h"

#include <QDoubleSpinBox>
#include <QPushButton>

// The steps of the guide, for a mount that is not commissioned.
namespace boresight::ui {
namespace {

class GuidePictures : public PictureBook
{
protected:
    GuidePictures()
    {
        QTest::keyClick(&window, Qt::Key_F3);
        Q_EMIT window.host().adaptersFound(
            adaptersOf({{.device = QStringLiteral("/dev/ttyACM0"),
                         .stableName = QStringLiteral("/dev/serial/by-id/usb-mjbots_fdcanusb"),
                         .manufacturer = QStringLiteral("mjbots"),
                         .description = QStringLiteral("fdcanusb"),
                         .serialNumber = QStringLiteral("1A2B3C4D"),
                         .vendor = 0x0483,
                         .product = 0x5740}},
                       {{QStringLiteral("can0"), false}}));
    }
};

// REQ-UI-15 (GuidePictures.*)
TEST_P(GuidePictures, AreTakenOfEveryStep)
{
    for (const GuideStep step : kGuideSteps) {
        give(samples::update(step == GuideStep::Protection ? samples::factoryDrives() : samples::freshMount()));
        const int number = static_cast<int>(step);
        QTest::mouseClick(&stepButtonOf(window, step), Qt::LeftButton);
        take(QStringLiteral("guide-%1").arg(number + 1));
    }
}

TEST_P(GuidePictures, AreTakenOfBoardsFromTheFactory)
{
    StationStatus status = samples::freshMount();
    status.state = StationState::Disconnected;
    status.drives->driveCheck = DriveCheckState::NotDone;
    status.drives->armingObstacle = QStringLiteral("two boards have the id 1, so their answers collide");
    status.drives->boards = {{.id = 1, .uuid = {}, .shared = true}};
    for (const Axis axis : kAxes) {
        status.permissions.refuse(assignBoardAction(axis), QStringLiteral("Two boards have the id 1."));
    }
    give(samples::update(status));
    QTest::mouseClick(&stepButtonOf(window, GuideStep::Connect), Qt::LeftButton);
    take(QStringLiteral("guide-1-one-id"));
    status.drives->boards = {{.id = 1, .uuid = QStringLiteral("626f7265-7369-6768-7420-73696d203032")}};
    status.permissions = samples::freshMount().permissions;
    give(samples::update(status));
    take(QStringLiteral("guide-1-alone"));
    const QByteArray itTurnsElevation = GuideBoards::tr("Assign to elevation …").toUtf8();
    QTest::mouseClick(findNamed<QPushButton>(window, itTurnsElevation), Qt::LeftButton);
    take(QStringLiteral("guide-1-question"));
}

TEST_P(GuidePictures, AreTakenOfANorthThatIsKnown)
{
    StationStatus status = samples::freshMount();
    profile::Profile known = *status.profile;
    known.pointing.azimuthOffset = 38.11_deg;
    status.profile = std::make_shared<const profile::Profile>(known);
    status.calibration = samples::sixPoints().calibration;
    give(samples::update(status));
    QTest::mouseClick(&stepButtonOf(window, GuideStep::North), Qt::LeftButton);
    window.findChild<GuideNorth*>()->findChild<QDoubleSpinBox*>()->setValue(210.0);
    take(QStringLiteral("guide-6-known"));
}

INSTANTIATE_TEST_SUITE_P(All, GuidePictures, kThemesAndPortuguese, editionName);

}  // namespace
}  // namespace boresight::ui
