// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/pointing_fit.h"

#include "core/base/text.h"
#include "core/calibration/fit_words.h"
#include "core/calibration/term_choice.h"

#include <algorithm>
#include <cmath>

namespace boresight::calibration {
namespace {

using pointing::PointingModel;
using pointing::PointingTerms;

constexpr double kDataRule = 0.5;    // of the sigma known before: below this limit the points determine the term
constexpr double kUnlikely = 3e-4;   // probability that a good point is as far off as this one: four sigmas
constexpr double kTooNoisy = 2.0;    // times the stated sigmas
constexpr double kLeastLever = 0.2;  // of cos(elevation)
constexpr double kPointingFitLeastArc = 90.0;  // degrees of azimuth

Angle rms(const std::vector<SkyOffset>& offsets)
{
    double square = 0.0;
    for (const SkyOffset& one : offsets) {
        square += one.size().radians() * one.size().radians();
    }
    return Angle::fromRadians(std::sqrt(square / static_cast<double>(std::max<std::size_t>(offsets.size(), 1))));
}

class Fit
{
public:
    Fit(std::span<const CalibrationPoint> points, const PointingTerms& before, const TermKnowledge& known)
        : m_given(points), m_before(before), m_known(known)
    {}

    Result<PointingFit> run()
    {
        if (const Result<> good = choosePoints(); !good) {
            return tl::unexpected(good.error());
        }
        const auto choice = chooseTerms(m_used, m_before, m_known);
        if (!choice) {
            return tl::unexpected(choice.error());
        }
        takeTerms(*choice);
        takeResiduals(*choice);
        nameOutliers(*choice);
        hint();
        return m_fit;
    }

private:
    Result<> choosePoints()
    {
        for (const CalibrationPoint& point : m_given) {
            const bool finite = point.axes.azimuth.isFinite() && point.axes.elevation.isFinite() &&
                                point.truth.azimuth.isFinite() && point.truth.elevation.isFinite();
            if (!finite || !(point.sigma > Angle{}) || !point.sigma.isFinite()) {
                return failure(ErrorCode::InvalidInput,
                               Text::tr("Point %1 is not a number or has no sigma.").arg(&point - m_given.data() + 1));
            }
            if (point.isUsed) {
                m_used.push_back(point);
            }
        }
        if (m_used.empty()) {
            return failure(ErrorCode::Refused, Text::tr("There are no points."));
        }
        return {};
    }

    void takeTerms(const TermChoice& choice)
    {
        m_fit.terms = choice.terms;
        m_fit.chiSquare = choice.chiSquare;
        m_fit.degreesOfFreedom = choice.degreesOfFreedom;
        m_fit.noiseScale = choice.noiseScale;
        for (const Term term : kAllTerms) {
            FittedTerm& one = m_fit.fitted[indexOf(term)];
            one.estimate = {valueOf(choice.terms, term), choice.sigmas[indexOf(term)]};
            if (choice.set[indexOf(term)]) {
                const bool told = toldByPoints(one.estimate.sigma, m_known.of(term));
                one.state = told && m_used.size() >= fewestPoints(term) ? TermState::Fitted : TermState::Held;
            }
            one.why = whyNotFitted(term, one.state);
        }
    }

    [[nodiscard]] QString whyNotFitted(Term term, TermState state) const
    {
        if (state == TermState::Fitted) {
            return {};
        }
        const std::size_t fewest = fewestPoints(term);
        if (m_used.size() < fewest) {
            return state == TermState::Held
                       ? Text::tr("kept near its known value until there are %1 points").arg(fewest)
                       : Text::tr("kept at its known value until there are %1 points").arg(fewest);
        }
        return state == TermState::Held ? Text::tr("its known value counts as much as the points")
                                        : Text::tr("the points fit without this term");
    }

    void takeResiduals(const TermChoice& choice)
    {
        std::vector<SkyOffset> before;
        std::vector<SkyOffset> after;
        std::vector<SkyOffset> leftOut;
        std::size_t place = 0;
        for (const CalibrationPoint& point : m_given) {
            FittedPoint& one = m_fit.points.emplace_back();
            one.before = offsetOf(point, PointingModel(m_before));
            one.after = offsetOf(point, PointingModel(m_fit.terms));
            if (!point.isUsed) {
                continue;
            }
            one.leftOut = choice.leftOut[place++];
            before.push_back(one.before);
            after.push_back(one.after);
            if (one.leftOut) {
                leftOut.push_back(*one.leftOut);
            }
        }
        m_fit.rmsBefore = rms(before);
        m_fit.rmsAfter = rms(after);
        if (leftOut.size() == m_used.size()) {
            m_fit.rmsLeftOut = rms(leftOut);
        }
    }

    void nameOutliers(const TermChoice& choice)
    {
        std::size_t place = 0;
        for (std::size_t i = 0; i < m_given.size(); ++i) {
            if (!m_given[i].isUsed) {
                continue;
            }
            const auto& leftOut = m_fit.points[i].leftOut;
            if (choice.chances[place++] < kUnlikely && leftOut) {
                say(Text::tr("Point %1 is %2 away from the fit of the other points.")
                        .arg(i + 1)
                        .arg(inWords(leftOut->size(), 2)));
            }
        }
    }

    void hint()
    {
        if (m_fit.noiseScale > kTooNoisy) {
            say(Text::tr("The points scatter %1 times more than their sigmas.").arg(m_fit.noiseScale, 0, 'f', 1));
        }
        const auto byLever = [](const auto& a, const auto& b) { return lever(a) < lever(b); };
        const auto [low, high] = std::minmax_element(m_used.begin(), m_used.end(), byLever);
        if (m_used.size() > 1 && lever(*high) - lever(*low) < kLeastLever) {
            say(
                Text::tr("All points have nearly the same elevation, so azimuth offset and collimation cannot be "
                         "separated. Take a point much higher or lower, or a point over the top."));
        }
        if (m_used.size() >= fewestPoints(Term::TiltNorth) && arc() < Angle::fromDegrees(kPointingFitLeastArc)) {
            say(Text::tr("All points lie within %1 of azimuth. They show the tilt from one side only.")
                    .arg(inWords(arc(), 0)));
        }
    }

    // The size of a step of azimuth on the sky. Negative over the top, where the collimation acts in the other
    // direction.
    static double lever(const CalibrationPoint& point) { return std::cos(point.axes.elevation.radians()); }

    // The length of the shortest arc that contains all points.
    [[nodiscard]] Angle arc() const
    {
        std::vector<Angle> azimuths;
        azimuths.reserve(m_used.size());
        for (const CalibrationPoint& point : m_used) {
            azimuths.push_back(pointing::upright(point.truth).azimuth);
        }
        std::sort(azimuths.begin(), azimuths.end());
        Angle gap = Angle::fromTurns(1.0) - (azimuths.back() - azimuths.front());
        for (std::size_t i = 1; i < azimuths.size(); ++i) {
            gap = std::max(gap, azimuths[i] - azimuths[i - 1]);
        }
        return Angle::fromTurns(1.0) - gap;
    }

    void say(const QString& text) { m_fit.hints.push_back(text); }

    std::span<const CalibrationPoint> m_given;
    PointingTerms m_before;
    const TermKnowledge& m_known;
    std::vector<CalibrationPoint> m_used;
    PointingFit m_fit;
};

}  // namespace

int PointingFit::count(TermState state) const
{
    return static_cast<int>(
        std::count_if(fitted.begin(), fitted.end(), [&](const FittedTerm& term) { return term.state == state; }));
}

bool toldByPoints(Angle sigma, const std::optional<Estimate>& before)
{
    return !before || sigma < before->sigma * kDataRule;
}

std::size_t fewestPoints(Term term)
{
    switch (term) {
        case Term::AzimuthOffset:
            return 1;
        case Term::ElevationOffset:
            return 2;
        case Term::TiltNorth:
        case Term::TiltEast:
            return 4;
        case Term::Collimation:
        case Term::NonPerpendicularity:
        case Term::ElevationSag:
            break;
    }
    return 6;
}

Result<PointingFit> fitPointing(std::span<const CalibrationPoint> points, const PointingTerms& before,
                                const TermKnowledge& known)
{
    return Fit(points, before, known).run();
}

}  // namespace boresight::calibration
