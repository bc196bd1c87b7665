// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_view.h"

#include "tests/fakes/wait_until.h"
#include "tests/ui/event_loop.h"
#include "tests/ui/plan/keyhole_pass.h"
#include "ui/plan/plan_chart.h"
#include "ui/plan/variant_table.h"
#include "ui/plan/variant_words.h"

#include <QSignalSpy>
#include <QTableView>

#include <gmock/gmock.h>

namespace boresight::ui {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const UtcTime kPlanEpoch = std::chrono::sys_days{std::chrono::year{2026} / 3 / 1} + 5h;

const KeyholePass& zenithPass()
{
    static const KeyholePass pass = keyholePass(kPlanEpoch);
    return pass;
}

class PlanViewTest : public ::testing::Test
{
protected:
    PlanViewTest()
    {
        view.resize(510, 170);
        view.show();
    }
    void askAbout(const profile::Profile& profile)
    {
        view.ask(questionOf(zenithPass(), profile));
        EXPECT_EQ(view.sentence().toStdString(), "Planning…");
        EXPECT_TRUE(fakes::waitUntil([this] { return view.sentence() != QStringLiteral("Planning…"); }));
    }
    QTableView& table() { return *view.findChild<QTableView*>(); }
    PlanChart& chart() { return *view.findChild<PlanChart*>(); }
    QString cell(int row, int column) { return table().model()->index(row, column).data().toString(); }
    int rowOf(const char* way)
    {
        for (int row = 0; row < table().model()->rowCount(); ++row) {
            if (cell(row, VariantTable::Way) == QLatin1String(way)) {
                return row;
            }
        }
        ADD_FAILURE() << "no way " << way;
        return -1;
    }

    PlanView view;
};

// REQ-PASSES-12: The view of the plan shows all ways to track the selected pass side by side, the best one first, each
// with its start, the error and loss to expect, the time beyond half of the beam, the hidden time, the room of the
// cable and the time of ramp and unwrap. It plans beside the gui thread.
TEST_F(PlanViewTest, VariantsOfAPassThroughTheKeyholeStandSideBySide)
{
    askAbout(keyholeProfile());
    EXPECT_EQ(cell(0, VariantTable::Way).toStdString(), "Through the zenith (best)");
    const int direct = rowOf("Direct");
    ASSERT_GT(direct, 0);
    ASSERT_TRUE(view.variant());
    EXPECT_EQ(view.variant()->way, plan::PlanWay::ThroughTheZenith);
    EXPECT_LT(view.variant()->forecast.peak, 1_deg);
    EXPECT_THAT(view.sentence().toStdString(), AllOf(StartsWith("Through the zenith: 0."), HasSubstr(" Direct: ")));
    EXPECT_FALSE(cell(direct, VariantTable::Apart).isEmpty()) << "the ramp";
    EXPECT_GT(cell(direct, VariantTable::Error).chopped(1).toDouble(),
              5.0 * cell(0, VariantTable::Error).chopped(1).toDouble());
    EXPECT_EQ(cell(0, VariantTable::Start),
              QString::number(view.variant()->start().azimuth.degrees(), 'f', 0) + QStringLiteral("°"));
}

// REQ-PASSES-13: One variant is selected, also by the keyboard. It is shown over time: the azimuth between the ends of
// the cable, ramp and unwrap, the hidden parts, the error and its bound, and the same in words for a screen reader.
TEST_F(PlanViewTest, TheKeyboardSelectsAVariant)
{
    askAbout(keyholeProfile());
    QSignalSpy changes(&view, &PlanView::changed);
    table().setFocus();
    const int direct = rowOf("Direct");
    for (int row = 0; row < direct; ++row) {
        QTest::keyClick(&table(), Qt::Key_Down);
    }
    EXPECT_FALSE(changes.isEmpty());
    ASSERT_EQ(view.variant()->way, plan::PlanWay::Direct);
    ASSERT_TRUE(view.variant()->ramp);
    EXPECT_THAT(chart().accessibleDescription().toStdString(),
                AllOf(StartsWith("Direct, off by up to "), HasSubstr("The cable ends at -90° and 450°."),
                      HasSubstr("The azimuth leaves the satellite from ")));
    const QRectF azimuths = chart().azimuthLine().boundingRect();
    EXPECT_GE(azimuths.top(), chart().yOfAzimuth(450_deg));
    EXPECT_LE(azimuths.bottom(), chart().yOfAzimuth(-90_deg));
    EXPECT_GE(chart().errorTop(), view.variant()->forecast.peak);
    EXPECT_NEAR(chart().errorLine().boundingRect().top(), chart().yOfError(view.variant()->forecast.peak), 0.5);
    ASSERT_TRUE(view.beam()) << "the ramp leads the beam beside the satellite";

    view.ask(questionOf(zenithPass(), keyholeProfile()));
    EXPECT_TRUE(fakes::waitUntil([&] { return view.variant() != nullptr; }));
    EXPECT_EQ(view.variant()->way, plan::PlanWay::Direct) << "the choice stays while the pass is the same";
}

TEST_F(PlanViewTest, TheVariantInUseIsMarkedAndSelected)
{
    askAbout(keyholeProfile());
    const PlanAnswer answer = answerTo(questionOf(zenithPass(), keyholeProfile()));
    const auto direct = std::ranges::find(answer.plan.variants, plan::PlanWay::Direct, &plan::PlanVariant::way);
    ASSERT_NE(direct, answer.plan.variants.end());
    view.setDriven(std::make_shared<const plan::PlanVariant>(*direct));
    EXPECT_EQ(cell(rowOf("Direct (in use)"), VariantTable::Way).toStdString(), "Direct (in use)");
    EXPECT_EQ(view.variant()->way, plan::PlanWay::Direct);
    EXPECT_FALSE(view.beam()) << "the sky shows it by itself";
}

// REQ-PASSES-14: Without a plan the view says why: the kind of the mount, or that the mount reaches no part of the
// pass.
TEST_F(PlanViewTest, AnXYMountHasNoPlan)
{
    profile::Profile profile = keyholeProfile();
    profile.pointing.geometry.kind = pointing::Geometry::XY;
    askAbout(profile);
    EXPECT_THAT(view.sentence().toStdString(), StartsWith("An X/Y mount needs no plan"));
    EXPECT_EQ(chart().words(), view.sentence());
    EXPECT_FALSE(view.variant());
    EXPECT_FALSE(table().isVisible());
}

TEST_F(PlanViewTest, NothingIsPlannedWithoutAPass)
{
    EXPECT_EQ(chart().words().toStdString(), "Select a pass first.");
    askAbout(keyholeProfile());
    view.ask({});
    EXPECT_EQ(chart().words().toStdString(), "Select a pass first.");
    EXPECT_FALSE(view.variant());
}

// REQ-PASSES-15: A pass without anything special says so in one sentence.
TEST(PlanSentence, IsCalmIfThereIsNothingSpecial)
{
    PlanAnswer answer{.plan = {.bound = 2.5_deg}};
    plan::PlanVariant direct{.moments = {{.utc = kPlanEpoch}, {.utc = kPlanEpoch + 1s}}};
    direct.forecast = {.peak = Angle::fromDegrees(0.02), .peakLoss = 0.001};
    answer.plan.variants = {direct};
    EXPECT_EQ(planSentence(answer).toStdString(), "The mount follows the whole pass directly, off by up to 0.02°.");
    answer.plan.variants.front().forecast.hidden = Seconds(40.0);
    EXPECT_THAT(planSentence(answer).toStdString(), HasSubstr("The limits hide the satellite for 40 s."));
    answer.plan.variants.insert(answer.plan.variants.begin(), direct);
    answer.plan.variants.front().way = plan::PlanWay::OverTheTop;
    answer.plan.variants.front().forecast = {.peak = Angle::fromDegrees(0.1), .peakLoss = 0.005};
    answer.plan.variants.back().forecast = {.peak = Angle::fromDegrees(5.3), .beyond = Seconds(14.0)};
    EXPECT_EQ(planSentence(answer).toStdString(),
              "Over the top: 0.10° (−0.0 dB). Direct: 5.30° (beyond the beam), 14 s off by more than 2.5°.");
}

TEST(PlanChart, HiddenPartsHaveNoError)
{
    auto variant = std::make_shared<plan::PlanVariant>();
    for (int i = 0; i <= 10; ++i) {
        variant->moments.push_back({.utc = kPlanEpoch + i * 10s,
                                    .axes = {Angle::fromDegrees(10.0 * i), 30_deg},
                                    .error = i < 4 ? 90_deg : Angle::fromDegrees(0.1),
                                    .isHidden = i < 4});
    }
    variant->forecast = plan::forecastOf(variant->moments, 2.5_deg, 5_deg);
    PlanChart chart;
    chart.resize(400, 120);
    chart.show(variant, {-90_deg, 450_deg}, 2.5_deg, {});
    ASSERT_EQ(chart.hiddenSpans().size(), 1U);
    EXPECT_EQ(chart.hiddenSpans().front(), (plan::PlanSpan{.from = kPlanEpoch, .to = kPlanEpoch + 40s}));
    EXPECT_NEAR(chart.errorLine().boundingRect().left(), chart.xOf(kPlanEpoch + 40s), 0.5);
    EXPECT_NEAR(chart.errorLine().boundingRect().top(), chart.yOfError(Angle::fromDegrees(0.1)), 0.5);
    EXPECT_LT(chart.errorTop(), 10_deg) << "the bound is visible";
    EXPECT_THAT(chart.accessibleDescription().toStdString(), HasSubstr("The limits hide the satellite for 35 s."));
}

// What only moves on is the same question. What changes the answer is another one.
TEST(PlanQuestion, IsAskedAgainOnlyIfItsAnswerMayChange)
{
    const PlanQuestion question = questionOf(zenithPass(), keyholeProfile());
    PlanQuestion other = question;
    other.task.now.azimuth += 5_deg;
    EXPECT_TRUE(isSameQuestion(question, other));
    other.task.now.azimuth += 10_deg;
    EXPECT_FALSE(isSameQuestion(question, other));
    other = question;
    other.profile = std::make_shared<const profile::Profile>(*question.profile);
    EXPECT_FALSE(isSameQuestion(question, other)) << "the profile was applied again";
    other = question;
    other.task.begins = plan::Begins::Now;
    EXPECT_FALSE(isSameQuestion(question, other)) << "it rises";
    PlanQuestion later = other;
    later.task.from += 20s;
    EXPECT_TRUE(isSameQuestion(other, later));
}

}  // namespace
}  // namespace boresight::ui
