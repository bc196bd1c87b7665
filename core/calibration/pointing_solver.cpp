// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/pointing_solver.h"

#include "core/base/text.h"
#include "core/calibration/fit_words.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace boresight::calibration {
namespace {

using pointing::PointingModel;
using pointing::PointingTerms;

constexpr int kPointingSolverRounds = 30;
constexpr int kFreshDerivatives = 2;  // rounds; then they are right, for the model is nearly linear
constexpr double kConverged = 1e-11;  // rad
constexpr double kStep = 1e-5;        // rad, of the derivatives: their error is its square
constexpr double kWorstCondition = 1e10;
constexpr double kAllLeverage = 1e-6;  // of a point that alone determines what it is held against

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
        m_size = static_cast<Eigen::Index>(m_unknowns.size());
    }

    Result<TermSolution> run()
    {
        for (int round = 0; round < kPointingSolverRounds; ++round) {
            linearise(round < kFreshDerivatives);
            if (round < kFreshDerivatives && !isDetermined()) {
                return failure(ErrorCode::Refused, Text::tr("The points do not determine the azimuth offset."));
            }
            const Eigen::VectorXd step = m_normal.ldlt().solve(m_gradient);
            for (Eigen::Index i = 0; i < m_size; ++i) {
                valueOf(m_terms, m_unknowns[static_cast<std::size_t>(i)]) += Angle::fromRadians(step[i]);
            }
            if (step.lpNorm<Eigen::Infinity>() < kConverged) {
                return solution();
            }
        }
        return failure(ErrorCode::Refused, Text::tr("No model fits these points. Check the direction of each point."));
    }

private:
    // In units of each point's sigma: across and elevation, one after the other.
    [[nodiscard]] Eigen::VectorXd residuals(const PointingTerms& terms) const
    {
        const PointingModel model(terms);
        Eigen::VectorXd result(2 * static_cast<Eigen::Index>(m_points.size()));
        Eigen::Index row = 0;
        for (const CalibrationPoint& point : m_points) {
            const SkyOffset off = offsetOf(point, model);
            result[row++] = off.across / point.sigma;
            result[row++] = off.elevation / point.sigma;
        }
        return result;
    }

    [[nodiscard]] Eigen::MatrixXd derivatives() const
    {
        Eigen::MatrixXd result(2 * static_cast<Eigen::Index>(m_points.size()), m_size);
        for (Eigen::Index i = 0; i < m_size; ++i) {
            const Term term = m_unknowns[static_cast<std::size_t>(i)];
            PointingTerms below = m_terms;
            PointingTerms above = m_terms;
            valueOf(below, term) -= Angle::fromRadians(kStep);
            valueOf(above, term) += Angle::fromRadians(kStep);
            result.col(i) = (residuals(above) - residuals(below)) / (2.0 * kStep);
        }
        return result;
    }

    void linearise(bool afresh)
    {
        if (afresh) {
            m_design = derivatives();
        }
        m_normal = m_design.transpose() * m_design;
        m_gradient = -m_design.transpose() * residuals(m_terms);
        for (Eigen::Index i = 0; i < m_size; ++i) {
            const Term term = m_unknowns[static_cast<std::size_t>(i)];
            if (const auto& before = m_known.of(term)) {
                const double weight = 1.0 / (before->sigma.radians() * before->sigma.radians());
                m_normal(i, i) += weight;
                m_gradient[i] += weight * (before->value - valueOf(m_terms, term)).radians();
            }
        }
    }

    // Of the normal matrix scaled to ones on its diagonal: units and weights do not count, only what resembles what.
    [[nodiscard]] double condition() const
    {
        const Eigen::VectorXd scale = m_normal.diagonal().cwiseSqrt().cwiseInverse();
        const Eigen::MatrixXd scaled = scale.asDiagonal() * m_normal * scale.asDiagonal();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled, Eigen::EigenvaluesOnly);
        return eigen.eigenvalues().maxCoeff() / std::max(eigen.eigenvalues().minCoeff(), 1e-300);
    }

    [[nodiscard]] bool isDetermined() const
    {
        return m_normal.allFinite() && m_normal.diagonal().minCoeff() > 0.0 && condition() < kWorstCondition;
    }

    [[nodiscard]] TermSolution solution() const
    {
        TermSolution result;
        result.terms = m_terms;
        const Eigen::MatrixXd covariance = m_normal.inverse();
        for (Eigen::Index i = 0; i < m_size; ++i) {
            const Term term = m_unknowns[static_cast<std::size_t>(i)];
            result.sigmas[indexOf(term)] = Angle::fromRadians(std::sqrt(covariance(i, i)));
            if (const auto& before = m_known.of(term)) {
                const double moved = (valueOf(m_terms, term) - before->value) / before->sigma;
                result.knowledge += moved * moved;
            }
        }
        const Eigen::VectorXd off = residuals(m_terms);
        result.chiSquare = off.squaredNorm();
        takeLeftOut(result, off, covariance);
        result.logVolume = -0.5 * m_normal.ldlt().vectorD().array().log().sum();
        result.condition = condition();
        return result;
    }

    // A fit follows each point by its leverage H = J C Jᵀ, so without it the point is off by (1 - H)⁻¹ times as much.
    // Of the same size is its covariance.
    void takeLeftOut(TermSolution& result, const Eigen::VectorXd& off, const Eigen::MatrixXd& covariance) const
    {
        Eigen::Index row = 0;
        for (const CalibrationPoint& point : m_points) {
            const Eigen::MatrixXd design = m_design.middleRows(row, 2);
            const Eigen::Matrix2d rest = Eigen::Matrix2d::Identity() - design * covariance * design.transpose();
            if (rest.determinant() < kAllLeverage) {
                result.leftOut.emplace_back();
                result.strangeness.push_back(0.0);
            } else {
                const Eigen::Vector2d without = rest.inverse() * off.segment<2>(row);
                result.leftOut.push_back(SkyOffset{point.sigma * without[0], point.sigma * without[1]});
                result.strangeness.push_back(without.dot(off.segment<2>(row)));
            }
            row += 2;
        }
    }

    std::span<const CalibrationPoint> m_points;
    PointingTerms m_terms;
    const TermKnowledge& m_known;
    std::vector<Term> m_unknowns;
    Eigen::Index m_size = 0;
    Eigen::MatrixXd m_design;
    Eigen::MatrixXd m_normal;
    Eigen::VectorXd m_gradient;  // downhill
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
    // As long as the arc between the two, also where that is not small.
    const double stretch = away > 0.0 ? std::atan2(away, seen.dot(vectorOf(truth))) / away : 1.0;
    return {.across = Angle::fromRadians(right * stretch), .elevation = Angle::fromRadians(above * stretch)};
}

Result<TermSolution> solveTerms(std::span<const CalibrationPoint> points, const PointingTerms& start,
                                const TermSet& set, const TermKnowledge& known)
{
    return Solver(points, start, set, known).run();
}

}  // namespace boresight::calibration
