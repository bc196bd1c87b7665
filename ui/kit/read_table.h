// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAbstractItemModel;
class QTableView;
class QWidget;

// A small read-only table: whole rows are selected, and the Tab key leaves it.
namespace boresight::ui {

[[nodiscard]] QTableView* makeReadTable(const QString& name, QAbstractItemModel& model, QWidget* parent);

}  // namespace boresight::ui
