// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/adapter.h"
#include "core/messages/scan_result.h"
#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

#include <optional>

class QListWidget;
class QPlainTextEdit;
class QPushButton;

// The guide's first step. It shows the kinds of rotators, the adapters of this computer by their own names, and the
// drives that answer on the selected adapter. Connect uses the selected adapter for the mount. If the station already
// uses the bus, the station reports the drives.
namespace boresight::ui {

class BusPicture;
class CommandButton;
class GuideBoards;
class HostDesk;
class RotatorChoice;
class ValueLabel;

class GuideConnect : public QWidget
{
    Q_OBJECT

public:
    GuideConnect(ProfileChange& change, RequestDesk& desk, HostDesk& host, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void showAdapters(const std::vector<Adapter>& adapters);
    void showResult(const ScanResult& result);
    void showButtons();
    void scan();
    void use();
    void showFound();
    [[nodiscard]] QString whyAlready() const;
    void showBoards();
    [[nodiscard]] QString selectedBus() const;
    [[nodiscard]] QString busInUse() const;
    [[nodiscard]] bool isSimulated(const QString& bus) const;
    [[nodiscard]] ProfileChange::Edit useSelected() const;
    [[nodiscard]] std::vector<int> idsFound() const;

    ProfileChange& m_change;
    HostDesk& m_host;
    StationStatus m_status;
    std::vector<Adapter> m_adapters;
    std::optional<ScanResult> m_result;
    QString m_scanning;  // the bus that is being scanned
    ValueLabel* m_notice;
    RotatorChoice* m_choice;
    QListWidget* m_list;
    QPlainTextEdit* m_found;
    BusPicture* m_picture;
    GuideBoards* m_boards;  // shown in place of m_picture
    QPushButton* m_refresh;
    CommandButton* m_scan;
    CommandButton* m_use;
};

}  // namespace boresight::ui
