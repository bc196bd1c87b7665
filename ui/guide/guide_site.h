// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gpredict/gpredict_qth.h"
#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;

// The guide's step for where the mount stands: degrees or a locator, each follows the other, or a station that a
// Gpredict on this computer knows; and where that Gpredict keeps its files, with how fresh its satellite data are.
namespace boresight::ui {

class CommandButton;
class HostDesk;
class ValueLabel;

class GuideSite : public QWidget
{
    Q_OBJECT

public:
    GuideSite(ProfileChange& change, RequestDesk& desk, HostDesk& host, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void fill(const profile::SiteSettings& site);
    void readLocator();
    void writeLocator();
    void lookForGpredict();
    void chooseFolder();
    void takeFolder(const QString& folder);
    void showGpredict(const profile::GpredictFiles& found);
    void take(int row);
    [[nodiscard]] ProfileChange::Edit edit() const;
    void showButton();

    ProfileChange& m_change;
    HostDesk& m_host;
    StationStatus m_status;
    std::optional<profile::SiteSettings> m_shown;  // of the profile, when the fields were filled
    std::vector<profile::GpredictStation> m_stations;
    QString m_folder;  // of Gpredict, as last asked for
    ValueLabel* m_notice;
    ValueLabel* m_gpredictNote;
    QDoubleSpinBox* m_latitude;
    QDoubleSpinBox* m_longitude;
    QDoubleSpinBox* m_height;
    QLineEdit* m_locator;
    QComboBox* m_gpredict;
    CommandButton* m_choose;  // Gpredict's folder
    CommandButton* m_set;
};

}  // namespace boresight::ui
