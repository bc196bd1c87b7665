// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QLineEdit;
class QPushButton;
class QTableView;

// Targets other than satellites: Sun, Moon, planets and radio sources in a table, a typed target, a path from a file,
// the Moon of WSJT-X, and a balloon or rocket that reports its position. Gui thread.
namespace boresight::ui {

class AzelBox;
class CommandButton;
class HostDesk;
class PositionBox;
class RequestDesk;
class TargetTable;
class TypedTarget;
class ValueLabel;

class TargetsPage : public QWidget
{
    Q_OBJECT

public:
    TargetsPage(RequestDesk& desk, HostDesk& host, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    [[nodiscard]] QString whyNotTracked(const StationStatus& status) const;  // for the selected target
    void trackChosen();
    void trackTyped();
    void showTyped();
    void clearNotice();
    void chooseTable();

    TargetTable* m_targets;
    QTableView* m_table;
    QLineEdit* m_typed;
    TypedTarget* m_typedTarget;
    ValueLabel* m_refused;
    CommandButton* m_trackChosen;
    CommandButton* m_trackTyped;
    QPushButton* m_chooseTable;
    AzelBox* m_azel;
    PositionBox* m_position;
    QString m_aboutTable;  // as it was last judged; the notice line may show a refusal instead
    UtcTime m_now{};
};

}  // namespace boresight::ui
