// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

// Linear least squares that tolerates outliers: first Huber's weights, then Tukey's, then rows beyond three sigma are
// left out and the rest is fitted with its given weights. Any unit; rows in the order of time. Pure.
namespace boresight::calibration {

class RobustProblem
{
public:
    explicit RobustProblem(std::size_t unknowns) : m_unknowns(unknowns) {}

    // value = Σ coefficients × unknowns + noise. Weight 1 has the noise to be estimated, weight 0.25 twice that noise.
    void add(std::span<const double> coefficients, double value, double weight = 1.0);

    [[nodiscard]] std::size_t unknowns() const { return m_unknowns; }
    [[nodiscard]] std::size_t rows() const { return m_values.size(); }
    [[nodiscard]] std::span<const double> row(std::size_t i) const  // the coefficients of row i
    {
        return std::span(m_coefficients).subspan(i * m_unknowns, m_unknowns);
    }
    [[nodiscard]] const std::vector<double>& values() const { return m_values; }
    [[nodiscard]] const std::vector<double>& weights() const { return m_weights; }

private:
    std::size_t m_unknowns;
    std::vector<double> m_coefficients;  // row after row
    std::vector<double> m_values;
    std::vector<double> m_weights;
};

struct RobustFit
{
    std::vector<double> solution;
    std::vector<double> covariance;  // row after row
    std::vector<double> residuals;   // value - fitted, of every row
    std::vector<bool> used;
    double rms = 0.0;          // of the rows used, at weight 1
    double correlation = 0.0;  // of a residual with the next one, 0…0.95
    double free = 0.0;         // independent rows beyond the unknowns; below about two the sigmas are only a guess

    [[nodiscard]] double variance(std::size_t unknown) const { return covariance[unknown * solution.size() + unknown]; }
    [[nodiscard]] std::size_t usedRows() const;
};

// Empty if the rows do not determine the unknowns and their noise.
// `noiseFloor`: a residual below three times this is never an outlier, however well the other rows agree.
//
// The covariance comes from the scatter of the residuals. It allows for noise that lasts from one row to the next (n
// rows are then worth n (1 - r) / (1 + r)), and for a scatter known from few rows only (Student's distribution has the
// variance f / (f - 2) at f degrees of freedom).
[[nodiscard]] std::optional<RobustFit> fitRobustly(const RobustProblem& problem, double noiseFloor);

}  // namespace boresight::calibration
