// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

#include <array>

class QPlainTextEdit;
class QStackedWidget;
class QTableView;

// Step 4 of finding north: the pointing model from the points. Three views: its terms, in effect and proposed, with
// remarks of the fit. The points with their residuals, in a table and on the sky. Terms to be typed, or exchanged with
// a file.
namespace boresight::ui {

class ChoiceButton;
class CommandButton;
class PointModel;
class RequestDesk;
class ResidualSky;
class TermModel;
class TermsBox;
class ValueLabel;

class ModelPage : public QWidget
{
    Q_OBJECT

public:
    explicit ModelPage(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    enum class View
    {
        Terms,
        Points,
        Given
    };

    void build();
    [[nodiscard]] QWidget* makeTerms();
    [[nodiscard]] QWidget* makePoints();
    [[nodiscard]] int selected() const;  // row of the points, or -1
    void showView(View view);
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
    TermsBox* m_given;
    QStackedWidget* m_views;
    std::array<ChoiceButton*, 3> m_choices{};  // by View
};

}  // namespace boresight::ui
