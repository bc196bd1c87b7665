// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QTableView;

// The live readings of both drives, to read, to copy and to save.
namespace boresight::ui {

class ReadingsModel;
class ValueLabel;

class ReadingsTable : public QWidget
{
    Q_OBJECT

public:
    explicit ReadingsTable(QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    QTableView* makeTable();
    void build();
    void copy();
    void askForName();
    void save(const QString& path, const QString& readings);

    ReadingsModel* m_model;
    QTableView* m_table;
    ValueLabel* m_energy;
    ValueLabel* m_notice;
};

}  // namespace boresight::ui
