// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/range_words.h"

#include "tests/ui/passes/passes_fixture.h"

#include <QRegularExpression>

#include <gmock/gmock.h>

#include <optional>

namespace boresight::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Shown
{
    double kilometres = 0.0;
    double rate = 0.0;
    double shift = 0.0;
};

std::optional<Shown> shownIn(const QString& text)
{
    static const QRegularExpression kForm(
        QStringLiteral("(\\d+) km, ([+-]\\d+\\.\\d\\d) km/s, (?:Doppler )?([+-]\\d+\\.\\d) Hz/MHz"));
    const QRegularExpressionMatch found = kForm.match(text);
    return found.hasMatch() ? std::optional(Shown{.kilometres = found.captured(1).toDouble(),
                                                  .rate = found.captured(2).toDouble(),
                                                  .shift = found.captured(3).toDouble()})
                            : std::nullopt;
}

class RangeWordsTest : public PassesFixture
{
protected:
    RangeWordsTest() { giveFound(m_status); }

    [[nodiscard]] const BookedPass& pass() { return passTable().pass(0); }
    [[nodiscard]] const orbit::ElementSet& elements() { return passTable().book()->elementsOf(pass()); }
    void giveAt(UtcTime utc)
    {
        m_status.utc = utc;
        give(samples::update(m_status));
    }
    void track()
    {
        m_status.state = StationState::Track;
        m_status.targetText = QStringLiteral("track ALPHA ONE");
        m_status.tracked =
            TrackedTarget{.name = QStringLiteral("ALPHA ONE"), .number = elements().number, .isUp = true};
    }

    StationStatus m_status = withSatellites();

private:
    PassTable& passTable() { return dynamic_cast<PassTable&>(*table().model()); }
};

// REQ-PASSES-997: While the selected satellite is above the horizon, its line has the range, the range rate and the
// Doppler shift at the full second. While a satellite is tracked, the header has them. Below the horizon, and for
// targets that are no satellites, nothing is shown.
TEST_F(RangeWordsTest, TheSelectedSatelliteHasThemWhileItIsUp)
{
    const UtcTime rises = std::chrono::ceil<std::chrono::seconds>(pass().pass.aos.utc);
    giveAt(rises - std::chrono::seconds(2));
    EXPECT_THAT(text("The selected pass").toStdString(), Not(HasSubstr("Doppler")));
    giveAt(rises + std::chrono::seconds(60));
    const auto first = shownIn(text("The selected pass"));
    giveAt(rises + std::chrono::seconds(70));
    const auto second = shownIn(text("The selected pass"));
    ASSERT_TRUE(first && second) << text("The selected pass").toStdString();
    EXPECT_NEAR((second->kilometres - first->kilometres) / 10.0, (first->rate + second->rate) / 2.0, 0.15);
    EXPECT_LT(first->rate, 0.0) << "it comes";
    EXPECT_NEAR(first->shift, -first->rate / 299'792.458 * 1e6, 0.1) << "so frequencies arrive higher";
}

TEST_F(RangeWordsTest, TheHeaderHasThoseOfTheTrackedSatellite)
{
    track();
    giveAt(pass().pass.tca.utc);
    const QString shown = text("Target and its source");
    EXPECT_TRUE(shown.startsWith(QStringLiteral("Tracking ALPHA ONE\n"))) << shown.toStdString();
    ASSERT_TRUE(shownIn(shown));
    EXPECT_NEAR(shownIn(shown)->rate, 0.0, 0.1) << "at its nearest, about the highest moment";
    giveAt(pass().pass.tca.utc + std::chrono::milliseconds(100));
    EXPECT_EQ(text("Target and its source"), shown) << "once a second is enough to read";
    m_status.tracked->number.reset();
    giveAt(pass().pass.tca.utc);
    EXPECT_EQ(text("Target and its source"), QStringLiteral("Tracking ALPHA ONE"));
    track();
    giveAt(pass().pass.aos.utc - std::chrono::seconds(5));
    EXPECT_FALSE(shownIn(text("Target and its source")));
}

TEST_F(RangeWordsTest, AnOrbitThatCannotBeComputedHasNone)
{
    orbit::ElementSet broken = elements();
    broken.eccentricity = 0.999;
    broken.revolutionsPerDay = 17.0;
    EXPECT_EQ(rangeText(broken, withSatellites().profile->site.place(), m_status.utc), QString());
}

}  // namespace
}  // namespace boresight::ui
