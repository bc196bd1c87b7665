// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

// The matrix of normal equations: symmetric, a row for each unknown. Pure value. Its source alone knows Eigen, whose
// templates cost the compiler many seconds in each file that uses them.
namespace boresight::calibration {

class NormalMatrix
{
public:
    explicit NormalMatrix(std::size_t unknowns) : m_unknowns(unknowns), m_cells(unknowns * unknowns) {}

    // One more equation with these coefficients.
    void add(std::span<const double> coefficients, double weight = 1.0);
    // What is known of an unknown by itself.
    void addKnown(std::size_t unknown, double weight) { m_cells[unknown * m_unknowns + unknown] += weight; }

    [[nodiscard]] std::size_t unknowns() const { return m_unknowns; }
    [[nodiscard]] double diagonal(std::size_t unknown) const { return m_cells[unknown * m_unknowns + unknown]; }
    // With ones on its diagonal: units and weights do not count, only what resembles what.
    [[nodiscard]] NormalMatrix scaled() const;

    // Positive, and its condition (by the sum of columns) is better than this.
    [[nodiscard]] bool isDetermined(double worstCondition) const;

    [[nodiscard]] std::vector<double> solve(std::span<const double> right) const;
    [[nodiscard]] std::vector<double> inverse() const;  // row after row
    [[nodiscard]] double logDeterminant() const;

private:
    std::size_t m_unknowns;
    std::vector<double> m_cells;  // row after row
};

}  // namespace boresight::calibration
