// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/normal_matrix.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace boresight::calibration {
namespace {

Eigen::Map<const Eigen::MatrixXd> matrixOf(const std::vector<double>& cells, std::size_t unknowns)
{
    const auto size = static_cast<Eigen::Index>(unknowns);
    return {cells.data(), size, size};
}

}  // namespace

void NormalMatrix::add(std::span<const double> coefficients, double weight)
{
    for (std::size_t i = 0; i < m_unknowns; ++i) {
        for (std::size_t j = 0; j < m_unknowns; ++j) {
            m_cells[i * m_unknowns + j] += weight * coefficients[i] * coefficients[j];
        }
    }
}

NormalMatrix NormalMatrix::scaled() const
{
    NormalMatrix result(m_unknowns);
    for (std::size_t i = 0; i < m_unknowns; ++i) {
        for (std::size_t j = 0; j < m_unknowns; ++j) {
            result.m_cells[i * m_unknowns + j] = m_cells[i * m_unknowns + j] / std::sqrt(diagonal(i) * diagonal(j));
        }
    }
    return result;
}

bool NormalMatrix::isDetermined(double worstCondition) const
{
    if (!std::all_of(m_cells.begin(), m_cells.end(), [](double cell) { return std::isfinite(cell); })) {
        return false;
    }
    const auto factors = matrixOf(m_cells, m_unknowns).ldlt();
    return factors.vectorD().minCoeff() > 0.0 && factors.rcond() * worstCondition > 1.0;
}

std::vector<double> NormalMatrix::solve(std::span<const double> right) const
{
    const Eigen::Map<const Eigen::VectorXd> vector(right.data(), static_cast<Eigen::Index>(right.size()));
    const Eigen::VectorXd solution = matrixOf(m_cells, m_unknowns).ldlt().solve(vector);
    return {solution.begin(), solution.end()};
}

std::vector<double> NormalMatrix::inverse() const
{
    std::vector<double> result;
    std::vector<double> unit(m_unknowns);
    for (std::size_t i = 0; i < m_unknowns; ++i) {
        unit[i] = 1.0;
        const std::vector<double> row = solve(unit);
        result.insert(result.end(), row.begin(), row.end());
        unit[i] = 0.0;
    }
    return result;
}

double NormalMatrix::logDeterminant() const
{
    const Eigen::VectorXd factors = matrixOf(m_cells, m_unknowns).ldlt().vectorD();
    return std::accumulate(factors.begin(), factors.end(), 0.0,
                           [](double sum, double factor) { return sum + std::log(factor); });
}

}  // namespace boresight::calibration
