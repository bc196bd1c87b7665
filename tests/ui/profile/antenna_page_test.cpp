// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/antenna_page.h"

#include "tests/ui/profile/profile_fixture.h"
#include "ui/profile/antenna_model.h"

#include <QTableView>

namespace boresight::ui {
namespace {

using profile::Profile;

// The antennas are changed as by an operator, by keys and mouse.
class AntennaPageTest : public ProfilePageTest
{
protected:
    AntennaPageTest()
    {
        roof.mount.beamWidth = 5_deg;
        roof.antennas = {{.name = "70 cm", .beamWidth = 20_deg, .across = 2_deg, .up = -1_deg}, {.name = "2 m"}};
        roof.satellites = {{.number = 25544, .favourite = orbit::Favourite::On, .antenna = "70 cm"},
                           {.number = 7530, .antenna = "2 m"}};
        put(roof);
    }

    QTableView& table() { return *named<QTableView>("Antennas"); }
    QString cell(int row, int column) { return table().model()->index(row, column).data().toString(); }
    void openFromSettings()
    {
        QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier);
        QTest::keyClicks(search(), QStringLiteral("antennas"));
        tree()->setFocus();
        QTest::keyClick(tree(), Qt::Key_Home);
        QTest::keyClick(tree(), Qt::Key_Down);
        QTest::keyClick(tree(), Qt::Key_Return);
    }
    void select(int row, int column)
    {
        table().setFocus();
        table().setCurrentIndex(table().model()->index(row, column));
    }
    // Types into the open editor of a cell.
    void typeInto(const char* words)
    {
        const QPointer<QLineEdit> editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
        ASSERT_TRUE(editor);
        editor->selectAll();
        QTest::keyClicks(editor, QString::fromUtf8(words));
        QTest::keyClick(editor, Qt::Key_Return);
        ASSERT_TRUE(comesTrue([&editor] { return !editor; })) << "the editor stays open";
    }
    void change(int row, int column, const char* words)
    {
        select(row, column);
        QTest::keyClick(&table(), Qt::Key_F2);
        typeInto(words);
    }
    Profile applied()
    {
        press("Apply");
        const auto sent = asked<request::ApplyProfile>();
        EXPECT_EQ(sent.size(), 1U);
        return sent.empty() ? Profile() : sent.back().profile;
    }
};

// REQ-ANTENNA-950 (AntennaPageTest.*): The antennas of a mount are added, named, measured and removed on the page
// Profile, as edits of the profile. An invalid text, or a name that is in use, is refused with the reason. The main
// antenna stays, and only its beam width can be changed. A satellite keeps its antenna under the new name, and loses
// one that is removed.
TEST_F(AntennaPageTest, AnAntennaIsAddedByKeyboardAndApplied)
{
    openFromSettings();
    ASSERT_TRUE(table().isVisible());
    EXPECT_FALSE(tree()->isVisible());
    ASSERT_EQ(table().model()->rowCount(), 3);
    EXPECT_EQ(cell(0, AntennaModel::Name), QStringLiteral("main"));
    EXPECT_EQ(cell(1, AntennaModel::BeamWidth), QStringLiteral("20.0"));
    press("Add antenna");
    typeInto("23 cm dish");
    EXPECT_EQ(cell(3, AntennaModel::BeamWidth), QStringLiteral("5.0")) << "as the main one, to be corrected";
    change(3, AntennaModel::BeamWidth, "1.25°");
    change(3, AntennaModel::Across, "-0.5");
    change(3, AntennaModel::Up, "3");
    EXPECT_TRUE(requests.empty()) << "an edit is no order";
    const Profile after = applied();
    ASSERT_EQ(after.antennas.size(), 3U);
    EXPECT_EQ(after.antennas.back(),
              (pointing::Antenna{.name = "23 cm dish", .beamWidth = 1.25_deg, .across = -0.5_deg, .up = 3_deg}));
    press("All settings");
    EXPECT_TRUE(tree()->isVisible());
}

TEST_F(AntennaPageTest, ANewNameGoesToTheSatellitesAndARemovedOneLeavesThem)
{
    openFromSettings();
    change(1, AntennaModel::Name, "UHF");
    select(2, AntennaModel::Name);
    QTest::keyClick(&table(), Qt::Key_Delete);
    EXPECT_TRUE(says("Satellites that had this antenna: 1. They now use the antenna that you choose by hand."));
    const Profile after = applied();
    ASSERT_EQ(after.antennas.size(), 1U);
    EXPECT_EQ(after.antennas.front().name, "UHF");
    EXPECT_EQ(orbit::antennaOf(after.satellites, 25544), "UHF");
    EXPECT_EQ(orbit::antennaOf(after.satellites, 7530), "");
}

TEST_F(AntennaPageTest, TheMainAntennaStaysAndIsWhatTheOthersAreMeasuredFrom)
{
    openFromSettings();
    for (const int column : {AntennaModel::Name, AntennaModel::Across, AntennaModel::Up}) {
        const QModelIndex index = table().model()->index(0, column);
        EXPECT_FALSE(index.flags().testFlag(Qt::ItemIsEditable)) << column;
        EXPECT_EQ(index.data(Qt::ToolTipRole).toString(),
                  QStringLiteral("The offsets of the other antennas are measured from the main antenna."));
    }
    select(0, AntennaModel::Name);
    press("Remove");
    EXPECT_TRUE(says("The main antenna cannot be removed. North is found with it."));
    change(0, AntennaModel::BeamWidth, "7.5");
    const Profile after = applied();
    EXPECT_EQ(after.mount.beamWidth, 7.5_deg);
    EXPECT_EQ(after.antennas, roof.antennas);
}

TEST_F(AntennaPageTest, WhatIsNoAntennaIsRefusedWithTheReason)
{
    openFromSettings();
    change(1, AntennaModel::BeamWidth, "wide");
    EXPECT_TRUE(says("\"wide\" is not a number (decimal point, e.g. 113.5)"));
    change(1, AntennaModel::Up, "31");
    EXPECT_EQ(cell(1, AntennaModel::Up), QStringLiteral("-1.0"));
    for (const char* const taken : {"2 m", "main"}) {
        change(1, AntennaModel::Name, taken);
        EXPECT_TRUE(says(qPrintable(QStringLiteral("There is already an antenna \"%1\".").arg(QLatin1String(taken)))));
    }
    change(1, AntennaModel::Name, "");
    EXPECT_EQ(cell(1, AntennaModel::Name), QStringLiteral("70 cm"));
    EXPECT_EQ(cell(1, AntennaModel::BeamWidth), QStringLiteral("20.0"));
    EXPECT_EQ(cell(1, AntennaModel::Up), QStringLiteral("-1.0"));
    for (std::size_t row = 0; row < profile::kMaxAntennas - roof.antennas.size(); ++row) {
        press("Add antenna");
        typeInto(qPrintable(QStringLiteral("no %1").arg(table().model()->rowCount())));
    }
    press("Add antenna");
    EXPECT_TRUE(says("The mount has the main antenna and 12 more. Boresight supports no more. Remove one first."));
    EXPECT_EQ(table().model()->rowCount(), 13);
}

// REQ-ANTENNA-951: The button beside the antenna in use opens the same table, from any panel.
TEST_F(AntennaPageTest, TheRowBelowTheNumbersLeadsThere)
{
    openPanel('1');
    EXPECT_FALSE(table().isVisible());
    QTest::mouseClick(named<QPushButton>("Edit the antennas"), Qt::LeftButton);
    EXPECT_TRUE(table().isVisible());
    EXPECT_TRUE(table().hasFocus());
}

}  // namespace
}  // namespace boresight::ui
