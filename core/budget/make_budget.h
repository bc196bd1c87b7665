// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/budget/budget_facts.h"
#include "core/budget/error_budget.h"

// From the facts to the budget. Pure, any thread.
namespace boresight::budget {

[[nodiscard]] ErrorBudget makeBudget(const BudgetFacts& facts);

}  // namespace boresight::budget
