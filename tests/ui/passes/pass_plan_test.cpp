// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/passes/passes_fixture.h"
#include "tests/ui/plan/keyhole_pass.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"
#include "ui/plan/plan_chart.h"
#include "ui/plan/plan_view.h"
#include "ui/sky/polar_plot.h"

#include <gmock/gmock.h>

namespace boresight::ui {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kPlanView = "How the mount will track the selected pass";

// The page Passes five minutes before a pass through the keyhole, on a mount of 6 °/s.
class PassPlanTest : public PassesFixture
{
protected:
    PassPlanTest()
    {
        status.permissions = Permissions::all();
        status.profile = std::make_shared<const profile::Profile>(keyholeProfile());
        status.satellites = std::make_shared<const std::vector<orbit::ElementSet>>(std::vector{keyhole.elements});
    }
    void openPlan()
    {
        status.utc = keyhole.pass.aos.utc - 5min;
        giveFound(status);
        const auto& passes = *qobject_cast<PassTable*>(table().model());
        int row = 0;
        while (!isSameMoment(passes.pass(row).pass.tca.utc, keyhole.pass.tca.utc)) {
            ++row;
        }
        table().selectRow(row);
        QTest::mouseClick(named<ChoiceButton>(kPlanView), Qt::LeftButton);
        give(samples::update(status));
    }
    void openPlanned()
    {
        openPlan();
        ASSERT_TRUE(fakes::waitUntil([this] { return view().variant() != nullptr; }));
        give(samples::update(status));
    }
    void giveTracked(const plan::SharedVariant& plan)
    {
        status.tracked = TrackedTarget{.name = QStringLiteral("ZENITH ONE"),
                                       .number = keyhole.elements.number,
                                       .isUp = false,
                                       .next = keyhole.pass.aos.utc,
                                       .plan = plan};
        status.targetText = QStringLiteral("tracks ZENITH ONE");
        status.utc += 1s;
        give(samples::update(status));
        give(samples::update(status));
    }
    static const KeyholePass& found()
    {
        static const KeyholePass pass = keyholePass(samples::idle().utc);
        return pass;
    }
    PlanView& view() { return *window.findChild<PlanView*>(); }
    QTableView& variants() { return *named<QTableView>("Ways to track the pass"); }
    void select(plan::PlanWay way)
    {
        QTest::keyClick(&variants(), Qt::Key_Home, Qt::ControlModifier);
        for (int row = 0; view().variant()->way != way && row < variants().model()->rowCount(); ++row) {
            QTest::keyClick(&variants(), Qt::Key_Down);
        }
        EXPECT_EQ(view().variant()->way, way);
        give(samples::update(status));
    }
    const SkyPaths& sky() { return window.findChild<PolarPlot*>()->markers().paths(); }

    StationStatus status = samples::idle();
    const KeyholePass& keyhole = found();
};

// REQ-PASSES-18: The operator may track a pass by another variant than the best one. The button is offered by the rules
// of Track, also to the keyboard. Track itself asks for the best variant.
TEST_F(PassPlanTest, TheOperatorTracksTheSelectedWay)
{
    openPlanned();
    select(plan::PlanWay::Direct);
    auto* const button = named<CommandButton>("Track this way");
    ASSERT_TRUE(button->isEnabled()) << button->toolTip().toStdString();
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Space);
    ASSERT_EQ(asked<request::Track>().size(), 1U);
    const request::Track sent = asked<request::Track>().back();
    EXPECT_EQ(std::get<orbit::ElementSet>(sent.target.kind).number, keyhole.elements.number);
    EXPECT_EQ(sent.way, plan::choiceFor(*view().variant()));
    QTest::mouseClick(named<CommandButton>("Track"), Qt::LeftButton);
    ASSERT_EQ(asked<request::Track>().size(), 2U);
    EXPECT_FALSE(asked<request::Track>().back().way);
}

// REQ-PASSES-18
TEST_F(PassPlanTest, TheWayIsOfferedByTheRulesOfTrack)
{
    openPlanned();
    status.utc = keyhole.pass.aos.utc - 3h;
    give(samples::update(status));
    EXPECT_FALSE(named<CommandButton>("Track this way")->isEnabled());
    EXPECT_EQ(named<CommandButton>("Track this way")->obstacle(), named<CommandButton>("Track")->obstacle());
}

// REQ-PASSES-14
TEST_F(PassPlanTest, AnXYMountSaysWhyThereIsNoPlan)
{
    profile::Profile profile = keyholeProfile();
    profile.pointing.geometry.kind = pointing::Geometry::XY;
    status.profile = std::make_shared<const profile::Profile>(profile);
    openPlan();
    ASSERT_TRUE(fakes::waitUntil([this] { return !view().sentence().startsWith(QStringLiteral("Planning")); }));
    give(samples::update(status));
    EXPECT_THAT(named<PlanChart>("The planned motion over time")->words().toStdString(),
                StartsWith("An X/Y mount needs no plan"));
    EXPECT_FALSE(named<CommandButton>("Track this way")->isEnabled());
    EXPECT_EQ(named<CommandButton>("Track this way")->obstacle().toStdString(), "There is no plan to choose.");
    EXPECT_TRUE(named<CommandButton>("Track")->isEnabled());
}

// REQ-PASSES-16
TEST_F(PassPlanTest, TheSkyHasTheBeamOfTheSelectedVariantWhileThePlanIsShown)
{
    openPlanned();
    EXPECT_FALSE(sky().hasBeam()) << "through the zenith the beam stays at the satellite";
    select(plan::PlanWay::Direct);
    EXPECT_FALSE(sky().chosenBeam().line().isEmpty()) << "the ramp";
    QTest::mouseClick(named<ChoiceButton>("The passes as a list"), Qt::LeftButton);
    give(samples::update(status));
    EXPECT_FALSE(sky().hasBeam());
    QTest::mouseClick(named<ChoiceButton>(kPlanView), Qt::LeftButton);
    give(samples::update(status));
    EXPECT_TRUE(sky().hasBeam());
    openPanel('1');
    give(samples::update(status));
    EXPECT_FALSE(sky().hasBeam());
}

// REQ-PASSES-17
TEST_F(PassPlanTest, TheHeaderHasThePlanOfWhatIsTracked)
{
    openPlanned();
    const plan::SharedVariant best = view().variant();
    giveTracked(best);
    EXPECT_THAT(named<ValueLabel>("Target and its source")->toolTip().toStdString(),
                HasSubstr("Through the zenith, off by up to 0."));
    EXPECT_EQ(variants().model()->index(0, 0).data().toString().toStdString(), "Through the zenith (in use)");
    select(plan::PlanWay::Direct);
    giveTracked(view().variant());
    EXPECT_FALSE(sky().trackedBeam().line().isEmpty());
    EXPECT_TRUE(sky().chosenBeam().line().isEmpty()) << "drawn once";
    status.tracked.reset();
    give(samples::update(status));
    EXPECT_EQ(named<ValueLabel>("Target and its source")->toolTip(), QString());
}

// In 1024×700 the table, the picture and the buttons have room.
TEST_F(PassPlanTest, HasRoomInALowWindow)
{
    openPlanned();
    settle();
    EXPECT_EQ(window.size(), QSize(1024, 700));
    EXPECT_GE(named<PlanChart>("The planned motion over time")->height(), 70);
    EXPECT_TRUE(named<CommandButton>("Track this way")->isVisible());
    EXPECT_TRUE(named<CommandButton>("Track")->isVisible());
    EXPECT_FALSE(named<CommandButton>("Add to schedule")->isVisible());
    int width = 0;
    for (int column = 0; column < variants().model()->columnCount(); ++column) {
        width += variants().isColumnHidden(column) ? 0 : variants().columnWidth(column);
    }
    EXPECT_LE(width, variants().viewport()->width()) << "no number is cut";
}

}  // namespace
}  // namespace boresight::ui
