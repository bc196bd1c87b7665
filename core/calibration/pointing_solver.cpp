// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/pointing_solver.h"

#include "core/base/text.h"
#include "core/calibration/fit_words.h"
#include "core/calibration/normal_matrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace boresight::calibration {
namespace {

using pointing::PointingModel;
using pointing::PointingTerms;

constexpr int kPointingSolverRounds = 30;
constexpr int kFreshDerivatives = 2;  // rounds; later the derivatives hardly change
constexpr double kConverged = 1e-11;  // rad
constexpr double kStep = 1e-5;        // rad, of the numeric derivatives: their error is the square of it
constexpr double kWorstCondition = 1e10;
constexpr double kAllLeverage = 1e-6;  // of a point that alone determines a term

struct Vector
{
    double north, east, up;

    [[nodiscard]] double dot(const Vector& other) const
    {
        return north * other.north + east * other.east + up * other.up;
    }
};

Vector vectorOf(const SkyPointing& direction)
{
    const double azimuth = direction.azimuth.radians();
    const double elevation = direction.elevation.radians();
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

class Solver
{
public:
    Solver(std::span<const CalibrationPoint> points, const PointingTerms& start, const TermSet& set,
           const TermKnowledge& known)
        : m_points(points), m_terms(start), m_known(known)
    {
        for (const Term term : kAllTerms) {
            if (set[indexOf(term)]) {
                m_unknowns.push_back(term);
            }
        }
        m_normal = NormalMatrix(m_unknowns.size());
    }

    Result<TermSolution> run()
    {
        for (int round = 0; round < kPointingSolverRounds; ++round) {
            linearise(round < kFreshDerivatives);
            if (round < kFreshDerivatives && !isDetermined()) {
                return failure(ErrorCode::Refused, Text::tr("The points do not determine the azimuth offset."));
            }
            const std::vector<double> step = m_normal.solve(m_gradient);
            for (std::size_t i = 0; i < step.size(); ++i) {
                valueOf(m_terms, m_unknowns[i]) += Angle::fromRadians(step[i]);
            }
            if (std::all_of(step.begin(), step.end(), [](double part) { return std::abs(part) < kConverged; })) {
                return solution();
            }
        }
        return failure(ErrorCode::Refused, Text::tr("No model fits these points. Check the direction of each point."));
    }

private:
    using Row = std::vector<double>;  // one derivative for each unknown

    // Across and elevation of each point in turn, in units of the point's sigma.
    [[nodiscard]] std::vector<double> residuals(const PointingTerms& terms) const
    {
        const PointingModel model(terms);
        std::vector<double> result;
        for (const CalibrationPoint& point : m_points) {
            const SkyOffset off = offsetOf(point, model);
            result.push_back(off.across / point.sigma);
            result.push_back(off.elevation / point.sigma);
        }
        return result;
    }

    // One row for each residual.
    [[nodiscard]] std::vector<Row> derivatives() const
    {
        std::vector<Row> result(2 * m_points.size());
        for (const Term term : m_unknowns) {
            PointingTerms below = m_terms;
            PointingTerms above = m_terms;
            valueOf(below, term) -= Angle::fromRadians(kStep);
            valueOf(above, term) += Angle::fromRadians(kStep);
            const std::vector<double> before = residuals(below);
            const std::vector<double> after = residuals(above);
            for (std::size_t i = 0; i < result.size(); ++i) {
                result[i].push_back((after[i] - before[i]) / (2.0 * kStep));
            }
        }
        return result;
    }

    void linearise(bool afresh)
    {
        if (afresh) {
            m_design = derivatives();
        }
        m_normal = NormalMatrix(m_unknowns.size());
        m_gradient.assign(m_unknowns.size(), 0.0);
        const std::vector<double> off = residuals(m_terms);
        for (std::size_t i = 0; i < m_design.size(); ++i) {
            m_normal.add(m_design[i]);
            for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
                m_gradient[j] -= m_design[i][j] * off[i];
            }
        }
        for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
            if (const auto& before = m_known.of(m_unknowns[j])) {
                const double weight = 1.0 / (before->sigma.radians() * before->sigma.radians());
                m_normal.addKnown(j, weight);
                m_gradient[j] += weight * (before->value - valueOf(m_terms, m_unknowns[j])).radians();
            }
        }
    }

    [[nodiscard]] bool isDetermined() const
    {
        for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
            if (!(m_normal.diagonal(j) > 0.0)) {
                return false;
            }
        }
        return m_normal.scaled().isDetermined(kWorstCondition);
    }

    [[nodiscard]] TermSolution solution() const
    {
        TermSolution result;
        result.terms = m_terms;
        const std::vector<double> covariance = m_normal.inverse();
        for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
            const Term term = m_unknowns[j];
            result.sigmas[indexOf(term)] = Angle::fromRadians(std::sqrt(covariance[j * m_unknowns.size() + j]));
            if (const auto& before = m_known.of(term)) {
                const double moved = (valueOf(m_terms, term) - before->value) / before->sigma;
                result.knowledge += moved * moved;
            }
        }
        const std::vector<double> off = residuals(m_terms);
        result.chiSquare = std::inner_product(off.begin(), off.end(), off.begin(), 0.0);
        for (std::size_t point = 0; point < m_points.size(); ++point) {
            takeLeftOut(result, point, off, covariance);
        }
        result.logVolume = -0.5 * m_normal.logDeterminant();
        return result;
    }

    // A fit follows each point by its leverage H = J C Jᵀ. Without the point, its residual and its covariance are
    // larger by (1 - H)⁻¹.
    void takeLeftOut(TermSolution& result, std::size_t point, const std::vector<double>& off,
                     const std::vector<double>& covariance) const
    {
        const Row& across = m_design[2 * point];
        const Row& up = m_design[2 * point + 1];
        const double restAcross = 1.0 - leverage(across, covariance, across);
        const double restUp = 1.0 - leverage(up, covariance, up);
        const double shared = -leverage(across, covariance, up);
        const double determinant = restAcross * restUp - shared * shared;
        if (determinant < kAllLeverage) {
            result.leftOut.emplace_back();
            result.strangeness.push_back(0.0);
            return;
        }
        const double offAcross = off[2 * point];
        const double offUp = off[2 * point + 1];
        const double withoutAcross = (restUp * offAcross - shared * offUp) / determinant;
        const double withoutUp = (restAcross * offUp - shared * offAcross) / determinant;
        const Angle sigma = m_points[point].sigma;
        result.leftOut.push_back(SkyOffset{sigma * withoutAcross, sigma * withoutUp});
        result.strangeness.push_back(withoutAcross * offAcross + withoutUp * offUp);
    }

    static double leverage(const Row& left, const std::vector<double>& covariance, const Row& right)
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < left.size(); ++i) {
            for (std::size_t j = 0; j < right.size(); ++j) {
                sum += left[i] * covariance[i * right.size() + j] * right[j];
            }
        }
        return sum;
    }

    std::span<const CalibrationPoint> m_points;
    PointingTerms m_terms;
    const TermKnowledge& m_known;
    std::vector<Term> m_unknowns;
    std::vector<Row> m_design;
    NormalMatrix m_normal{0};
    std::vector<double> m_gradient;  // downhill
};

}  // namespace

Angle SkyOffset::size() const
{
    return hypot(across, elevation);
}

SkyOffset offsetOf(const CalibrationPoint& point, const PointingModel& model)
{
    const SkyPointing truth = pointing::upright(point.truth);
    const Vector seen = vectorOf(model.toSky(point.axes));
    const double azimuth = truth.azimuth.radians();
    const double elevation = truth.elevation.radians();
    const Vector east{-std::sin(azimuth), std::cos(azimuth), 0.0};
    const Vector up{-std::sin(elevation) * std::cos(azimuth), -std::sin(elevation) * std::sin(azimuth),
                    std::cos(elevation)};
    const double right = seen.dot(east);
    const double above = seen.dot(up);
    const double away = std::hypot(right, above);
    // Makes the length equal to the arc between the two directions, also for a large arc.
    const double stretch = away > 0.0 ? std::atan2(away, seen.dot(vectorOf(truth))) / away : 1.0;
    return {.across = Angle::fromRadians(right * stretch), .elevation = Angle::fromRadians(above * stretch)};
}

Result<TermSolution> solveTerms(std::span<const CalibrationPoint> points, const PointingTerms& start,
                                const TermSet& set, const TermKnowledge& known)
{
    return Solver(points, start, set, known).run();
}

}  // namespace boresight::calibration
