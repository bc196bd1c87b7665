// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

// The matrix of the normal equations: symmetric, with a row for each unknown. Pure value. Only its source includes
// Eigen, whose templates cost the compiler many seconds in each file.
namespace boresight::calibration {

class NormalMatrix
{
public:
    explicit NormalMatrix(std::size_t unknowns) : m_unknowns(unknowns), m_cells(unknowns * unknowns) {}

    // One more equation with these coefficients.
    void add(std::span<const double> coefficients, double weight = 1.0);
    // Adds what is known about one unknown by itself.
    void addKnown(std::size_t unknown, double weight) { m_cells[unknown * m_unknowns + unknown] += weight; }

    [[nodiscard]] std::size_t unknowns() const { return m_unknowns; }
    [[nodiscard]] double diagonal(std::size_t unknown) const { return m_cells[unknown * m_unknowns + unknown]; }
    // The same matrix with ones on its diagonal. It shows only how the unknowns resemble each other, independent of
    // units and weights.
    [[nodiscard]] NormalMatrix scaled() const;

    // Positive definite, with a condition number (by column sums) below this limit.
    [[nodiscard]] bool isDetermined(double worstCondition) const;

    [[nodiscard]] std::vector<double> solve(std::span<const double> right) const;
    [[nodiscard]] std::vector<double> inverse() const;  // row after row
    [[nodiscard]] double logDeterminant() const;

private:
    std::size_t m_unknowns;
    std::vector<double> m_cells;  // row after row
};

}  // namespace boresight::calibration
