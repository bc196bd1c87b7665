// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_draft.h"
#include "ui/sky/region_edit.h"

#include <QWidget>

class QPushButton;
class QTableView;

// The region in which the mount may work, in numbers: limits of both axes, the horizon and the keep-outs. The same
// draft as on the plot. Nothing takes effect before Apply.
namespace boresight::ui {

class LimitRow;
class ProfileDraftBar;
class DraftTableModel;
class ValueLabel;

class LimitsPanel : public QWidget
{
    Q_OBJECT

public:
    LimitsPanel(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void importHorizon(const QString& path);
    void exportHorizon(const QString& path);

private:
    void build();
    QTableView* makeTable(DraftTableModel& model, const QString& name);
    QWidget* makeHorizonBox();
    QWidget* makeKeepOutBox();
    QPushButton* makeButton(const QString& text, const QString& name);
    void addPoint();
    void addSector();
    void askForHorizon();
    void askWhereToExport();
    void removeCurrent(const QTableView& table, RegionPart part);
    void say(const QString& reason);
    void tell(const QString& text);

    ProfileDraft& m_draft;
    LimitRow* m_azimuth;
    LimitRow* m_elevation;
    QTableView* m_horizon;
    QTableView* m_keepOuts;
    ValueLabel* m_notice;
    ProfileDraftBar* m_bar;
    SkyPointing m_place;  // direction of the mount: a new keep-out begins there
};

}  // namespace boresight::ui
