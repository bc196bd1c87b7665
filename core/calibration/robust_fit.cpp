// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/robust_fit.h"

#include "core/calibration/normal_matrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace boresight::calibration {
namespace {

// Huber's and Tukey's usual constants: 95 % of the efficiency of least squares when the noise is Gaussian.
constexpr double kHuber = 1.345;
constexpr double kTukey = 4.685;
constexpr double kMedianToSigma = 1.4826;  // of the median of |residual|, for Gaussian noise
constexpr double kCut = 3.0;
constexpr int kHuberRounds = 15;
constexpr int kTukeyRounds = 10;
constexpr int kCutRounds = 10;
constexpr double kWorstCorrelation = 0.95;
constexpr double kFewestFree = 2.5;               // degrees of freedom; with two or less the variance is infinite
constexpr double kRobustFitWorstCondition = 1e8;  // of the normal matrix

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

class RobustSolver
{
public:
    RobustSolver(const RobustProblem& problem, double noiseFloor)
        : m_problem(problem), m_floor(noiseFloor), m_normal(problem.unknowns())
    {}

    std::optional<RobustFit> run()
    {
        solve(m_problem.weights());
        reweigh(kHuberRounds, [](double away) { return away <= kHuber ? 1.0 : kHuber / away; });
        reweigh(kTukeyRounds, [](double away) {
            const double rest = 1.0 - (away / kTukey) * (away / kTukey);
            return rest > 0.0 ? rest * rest : 0.0;
        });
        cut();
        return result();
    }

private:
    void solve(const std::vector<double>& weights)
    {
        const std::vector<double>& values = m_problem.values();
        m_normal = NormalMatrix(m_problem.unknowns());
        std::vector<double> right(m_problem.unknowns());
        for (std::size_t i = 0; i < m_problem.rows(); ++i) {
            const std::span<const double> row = m_problem.row(i);
            m_normal.add(row, weights[i]);
            for (std::size_t j = 0; j < row.size(); ++j) {
                right[j] += weights[i] * values[i] * row[j];
            }
        }
        m_solution = m_normal.solve(right);
        m_residuals.clear();
        m_away.clear();
        for (std::size_t i = 0; i < m_problem.rows(); ++i) {
            const std::span<const double> row = m_problem.row(i);
            m_residuals.push_back(values[i] - std::inner_product(row.begin(), row.end(), m_solution.begin(), 0.0));
            m_away.push_back(std::abs(m_residuals.back()) * std::sqrt(m_problem.weights()[i]));
        }
    }

    // From the median of the residuals, so that up to half of them may be outliers.
    [[nodiscard]] double scale() const
    {
        const auto rows = static_cast<double>(m_problem.rows());
        const auto free = static_cast<double>(m_problem.rows() - m_problem.unknowns());
        const double spread = kMedianToSigma * median(m_away) * std::sqrt(rows / free);
        return std::max(spread, m_floor);
    }

    template <class Weight>
    void reweigh(int rounds, Weight weight)
    {
        for (int round = 0; round < rounds; ++round) {
            const double sigma = scale();
            std::vector<double> weights = m_problem.weights();
            for (std::size_t i = 0; i < weights.size(); ++i) {
                weights[i] *= weight(m_away[i] / sigma);
            }
            solve(weights);
        }
    }

    void cut()
    {
        for (int round = 0; round < kCutRounds; ++round) {
            const double sigma = scale();
            std::vector<double> weights = m_problem.weights();
            std::vector<bool> used(weights.size());
            for (std::size_t i = 0; i < weights.size(); ++i) {
                used[i] = m_away[i] <= kCut * sigma;
                weights[i] *= used[i] ? 1.0 : 0.0;
            }
            if (used == m_used) {
                return;
            }
            m_used = used;
            solve(weights);
        }
    }

    // The correlation of neighbouring residuals that are both used. The estimate from n rows is too low by about 2 r /
    // n (Kendall 1954). Each unknown adds (1 + r) / n, because it removes slow changes.
    [[nodiscard]] double correlation(double n, double p) const
    {
        double product = 0.0;
        double square = 0.0;
        for (std::size_t i = 0; i + 1 < m_residuals.size(); ++i) {
            if (m_used[i] && m_used[i + 1]) {
                product += m_residuals[i] * m_residuals[i + 1];
                square += (m_residuals[i] * m_residuals[i] + m_residuals[i + 1] * m_residuals[i + 1]) / 2.0;
            }
        }
        const double seen = square > 0.0 ? product / square : 0.0;
        return std::clamp(seen + (p * (1.0 + seen) + 2.0 * seen) / n, 0.0, kWorstCorrelation);
    }

    std::optional<RobustFit> result()
    {
        RobustFit fit;
        fit.used = m_used;
        const auto n = static_cast<double>(fit.usedRows());
        const auto p = static_cast<double>(m_problem.unknowns());
        fit.correlation = correlation(n, p);
        fit.free = n * (1.0 - fit.correlation) / (1.0 + fit.correlation) - p;
        if (n - p < kFewestFree || !m_normal.isDetermined(kRobustFitWorstCondition)) {
            return std::nullopt;
        }
        const double free = std::max(fit.free, kFewestFree);
        double square = 0.0;
        for (std::size_t i = 0; i < m_away.size(); ++i) {
            square += m_used[i] ? m_away[i] * m_away[i] : 0.0;
        }
        fit.rms = std::sqrt(square / n);
        const double worth = (free + p) / n;  // of one row
        const double noise = std::max(square / std::max(n - p / worth, kFewestFree), m_floor * m_floor / 12.0);
        fit.solution = m_solution;
        fit.covariance = m_normal.inverse();
        for (double& cell : fit.covariance) {
            cell *= noise / worth * free / (free - 2.0);
        }
        fit.residuals = m_residuals;
        return fit;
    }

    const RobustProblem& m_problem;
    double m_floor;
    NormalMatrix m_normal;
    std::vector<double> m_solution;
    std::vector<double> m_residuals;
    std::vector<double> m_away;  // |residual| at weight 1
    std::vector<bool> m_used;
};

}  // namespace

void RobustProblem::add(std::span<const double> coefficients, double value, double weight)
{
    m_coefficients.insert(m_coefficients.end(), coefficients.begin(), coefficients.end());
    m_values.push_back(value);
    m_weights.push_back(weight);
}

std::size_t RobustFit::usedRows() const
{
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

std::optional<RobustFit> fitRobustly(const RobustProblem& problem, double noiseFloor)
{
    if (problem.rows() <= problem.unknowns()) {
        return std::nullopt;
    }
    return RobustSolver(problem, noiseFloor).run();
}

}  // namespace boresight::calibration
