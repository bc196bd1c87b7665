// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/step_button_of.h"
#include "tests/ui/window_fixture.h"
#include "ui/guide/guide_page.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>

// The settings that the site step of the guide takes from a Gpredict on this computer.
namespace boresight::ui {
namespace {

class GuideGpredictTest : public WindowFixture
{
protected:
    GuideGpredictTest()
    {
        status = samples::freshMount();
        give(samples::update(status));
        QTest::keyClick(&window, Qt::Key_F3);
        QObject::connect(&window.host(), &HostDesk::gpredictWanted, &window,
                         [this](const QString& folder) { wanted << folder; });
        QTest::mouseClick(&stepButtonOf(window, GuideStep::Site), Qt::LeftButton);
    }
    void answer(const profile::GpredictFiles& found) { Q_EMIT window.host().gpredictFound(found); }
    QString told() { return text("Sites found in Gpredict"); }
    void putInForce(const profile::Profile& profile)
    {
        status.profile = std::make_shared<const profile::Profile>(profile);
        give(samples::acceptance(status, requests.back().id));
    }

    StationStatus status;
    QStringList wanted;  // the folders that the guide asked for
};

TEST_F(GuideGpredictTest, AStationFillsTheFields)
{
    ASSERT_EQ(wanted.size(), 1);
    profile::GpredictFiles found{.folder = wanted.front()};
    found.stations.push_back(
        {.name = QStringLiteral("home"),
         .location = QStringLiteral("Porto"),
         .site = {.known = true, .latitude = 41.15_deg, .longitude = -8.61_deg, .heightMetres = 90.0},
         .isDefault = true});
    answer(found);
    auto* const stations = named<QComboBox>("Station of Gpredict");
    stations->setFocus();
    QTest::keyClick(stations, Qt::Key_Down);
    EXPECT_NEAR(named<QDoubleSpinBox>("Latitude")->value(), 41.15, 1e-9);
    EXPECT_EQ(named<QLineEdit>("Maidenhead locator")->text(), QStringLiteral("IN51qd"));
    EXPECT_TRUE(requests.empty()) << "choosing changes nothing yet";
}

TEST_F(GuideGpredictTest, ItsFolderIsShownWithTheAgeOfItsSatellites)
{
    const QString usual = wanted.front();
    EXPECT_TRUE(usual.endsWith(QStringLiteral("/Gpredict")));
    answer({.folder = usual});
    EXPECT_EQ(told(), usual + QStringLiteral(": No Gpredict settings found. Choose its folder."));
    profile::GpredictFiles found{.folder = usual};
    found.satellites = {.folder = usual + QStringLiteral("/satdata"), .files = 1820};
    answer(found);
    EXPECT_EQ(told(), usual + QStringLiteral(": satellites 1820, none with elements that can be read"));
    found.satellites.newest = status.utc - std::chrono::hours(60);
    answer(found);
    EXPECT_EQ(told(), usual + QStringLiteral(": satellites 1820, the newest elements 2.5 days old"));
}

TEST_F(GuideGpredictTest, AFolderChosenByHandIsLookedIntoAndRemembered)
{
    const QTemporaryDir elsewhere;
    QTest::mouseClick(named<QPushButton>("Folder …"), Qt::LeftButton);
    auto* const dialog = window.findChild<QFileDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_FALSE(dialog->isModal());
    Q_EMIT dialog->fileSelected(elsewhere.path());
    dialog->close();
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    const profile::Profile applied = asked<request::ApplyProfile>().front().profile;
    EXPECT_EQ(applied.gpredict.folder, elsewhere.path().toStdString());
    putInForce(applied);
    ASSERT_EQ(wanted.size(), 2) << "it is looked into at once";
    EXPECT_EQ(wanted.back(), elsewhere.path());
    answer({.folder = wanted.front()});  // a late answer about the previous folder
    EXPECT_FALSE(told().startsWith(elsewhere.path()));
    answer({.folder = elsewhere.path()});
    EXPECT_TRUE(told().startsWith(elsewhere.path()));
}

}  // namespace
}  // namespace boresight::ui
