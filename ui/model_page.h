// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station_status.h"

#include <QWidget>

class QPlainTextEdit;
class QStackedWidget;
class QTableView;

// Step 4 of finding north: the pointing model that the points speak for. Two views: its terms, in force and proposed,
// with what the fit remarks; and the points with their residuals, in a table and on the sky.
namespace boresight::ui {

class CommandButton;
class PointModel;
class RequestDesk;
class ResidualSky;
class TermModel;
class ValueLabel;

class ModelPage : public QWidget
{
    Q_OBJECT

public:
    explicit ModelPage(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    [[nodiscard]] QWidget* makeTerms();
    [[nodiscard]] QWidget* makePoints();
    [[nodiscard]] int selected() const;  // row of the points; -1: none
    void showSelected();
    void useOrNot();
    void drop();

    StationStatus m_status;
    TermModel* m_terms;
    PointModel* m_points;
    ValueLabel* m_summary;
    ValueLabel* m_notice;
    QPlainTextEdit* m_remarks;
    QTableView* m_termTable;
    QTableView* m_pointTable;
    ResidualSky* m_sky;
    CommandButton* m_use;
    CommandButton* m_drop;
    QStackedWidget* m_views;
};

}  // namespace boresight::ui
