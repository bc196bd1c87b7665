// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/robust_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace boresight::calibration {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Huber's and Tukey's usual constants: 95 % of the efficiency of least squares when the noise is Gaussian.
constexpr double kHuber = 1.345;
constexpr double kTukey = 4.685;
constexpr double kMedianToSigma = 1.4826;  // of the median of |residual|, for Gaussian noise
constexpr double kCut = 3.0;
constexpr int kHuberRounds = 15;
constexpr int kTukeyRounds = 10;
constexpr int kCutRounds = 10;
constexpr double kWorstCorrelation = 0.95;
constexpr double kFewestFree = 2.5;               // degrees of freedom; with two the variance has no end
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
        : m_rows(static_cast<Eigen::Index>(problem.rows())),
          m_unknowns(static_cast<Eigen::Index>(problem.unknowns())),
          m_design(Eigen::Map<const RowMajor>(problem.coefficients().data(), m_rows, m_unknowns)),
          m_values(Eigen::Map<const Eigen::VectorXd>(problem.values().data(), m_rows)),
          m_given(Eigen::Map<const Eigen::VectorXd>(problem.weights().data(), m_rows)),
          m_floor(noiseFloor)
    {}

    std::optional<RobustFit> run()
    {
        solve(m_given);
        reweigh(kHuberRounds, [](double away) { return away <= kHuber ? 1.0 : kHuber / away; });
        reweigh(kTukeyRounds, [](double away) {
            const double rest = 1.0 - (away / kTukey) * (away / kTukey);
            return rest > 0.0 ? rest * rest : 0.0;
        });
        cut();
        return result();
    }

private:
    void solve(const Eigen::VectorXd& weights)
    {
        m_normal = m_design.transpose() * weights.asDiagonal() * m_design;
        const Eigen::LDLT<Eigen::MatrixXd> factors(m_normal);
        m_solution = factors.solve(m_design.transpose() * weights.cwiseProduct(m_values));
        m_residuals = m_values - m_design * m_solution;
        m_away = m_residuals.cwiseAbs().cwiseProduct(m_given.cwiseSqrt());
    }

    // From the middle of the residuals: half of them may be anything.
    [[nodiscard]] double scale() const
    {
        const std::vector<double> away(m_away.begin(), m_away.end());
        const auto free = static_cast<double>(std::max<Eigen::Index>(m_rows - m_unknowns, 1));
        const double spread = kMedianToSigma * median(away) * std::sqrt(static_cast<double>(m_rows) / free);
        return std::max(spread, m_floor);
    }

    template <class Weight>
    void reweigh(int rounds, Weight weight)
    {
        for (int round = 0; round < rounds; ++round) {
            const double sigma = scale();
            Eigen::VectorXd weights = m_given;
            for (Eigen::Index i = 0; i < m_rows; ++i) {
                weights[i] *= weight(m_away[i] / sigma);
            }
            solve(weights);
        }
    }

    void cut()
    {
        for (int round = 0; round < kCutRounds; ++round) {
            const double sigma = scale();
            std::vector<bool> used(static_cast<std::size_t>(m_rows));
            Eigen::VectorXd weights = m_given;
            for (Eigen::Index i = 0; i < m_rows; ++i) {
                used[static_cast<std::size_t>(i)] = m_away[i] <= kCut * sigma;
                weights[i] *= m_away[i] <= kCut * sigma ? 1.0 : 0.0;
            }
            if (used == m_used) {
                return;
            }
            m_used = used;
            solve(weights);
        }
    }

    // Of neighbours that are both used. The estimate from n rows is too low by about 2 r / n (Kendall 1954), and by
    // (1 + r) / n for each unknown, which takes away what is slow.
    [[nodiscard]] double correlation(double n, double p) const
    {
        double product = 0.0;
        double square = 0.0;
        for (Eigen::Index i = 0; i + 1 < m_rows; ++i) {
            if (m_used[static_cast<std::size_t>(i)] && m_used[static_cast<std::size_t>(i + 1)]) {
                product += m_residuals[i] * m_residuals[i + 1];
                square += (m_residuals[i] * m_residuals[i] + m_residuals[i + 1] * m_residuals[i + 1]) / 2.0;
            }
        }
        const double seen = square > 0.0 ? product / square : 0.0;
        return std::clamp(seen + (p * (1.0 + seen) + 2.0 * seen) / n, 0.0, kWorstCorrelation);
    }

    [[nodiscard]] bool isDetermined() const
    {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(m_normal, Eigen::EigenvaluesOnly);
        const double smallest = eigen.eigenvalues().minCoeff();
        return std::isfinite(smallest) && smallest * kRobustFitWorstCondition > eigen.eigenvalues().maxCoeff();
    }

    std::optional<RobustFit> result()
    {
        RobustFit fit;
        fit.used = m_used;
        const auto n = static_cast<double>(fit.usedRows());
        const auto p = static_cast<double>(m_unknowns);
        fit.correlation = correlation(n, p);
        fit.free = n * (1.0 - fit.correlation) / (1.0 + fit.correlation) - p;
        if (n - p < kFewestFree || !isDetermined()) {
            return std::nullopt;
        }
        const double free = std::max(fit.free, kFewestFree);
        double square = 0.0;
        for (Eigen::Index i = 0; i < m_rows; ++i) {
            square += m_used[static_cast<std::size_t>(i)] ? m_away[i] * m_away[i] : 0.0;
        }
        fit.rms = std::sqrt(square / n);
        const double worth = (free + p) / n;  // of a row
        const double noise = std::max(square / std::max(n - p / worth, kFewestFree), m_floor * m_floor / 12.0);
        const RowMajor covariance = m_normal.inverse() * (noise / worth * free / (free - 2.0));
        fit.solution.assign(m_solution.begin(), m_solution.end());
        fit.covariance.assign(covariance.data(), covariance.data() + covariance.size());
        fit.residuals.assign(m_residuals.begin(), m_residuals.end());
        return fit;
    }

    Eigen::Index m_rows;
    Eigen::Index m_unknowns;
    RowMajor m_design;
    Eigen::VectorXd m_values;
    Eigen::VectorXd m_given;  // weights
    double m_floor;
    Eigen::MatrixXd m_normal;
    Eigen::VectorXd m_solution;
    Eigen::VectorXd m_residuals;
    Eigen::VectorXd m_away;  // |residual| at weight 1
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
