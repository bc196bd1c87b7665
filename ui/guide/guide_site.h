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

// The guide's step for the site. The operator enters degrees or a locator, and each changes the other, or chooses a
// station of Gpredict on this computer. The step also sets the folder of Gpredict, and shows how old its satellite data
// is.
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
    std::optional<profile::SiteSettings> m_shown;  // of the profile, when the fields were last filled
    std::vector<profile::GpredictStation> m_stations;
    QString m_folder;  // Gpredict's folder in the last request
    ValueLabel* m_notice;
    ValueLabel* m_gpredictNote;
    QDoubleSpinBox* m_latitude;
    QDoubleSpinBox* m_longitude;
    QDoubleSpinBox* m_height;
    QLineEdit* m_locator;
    QComboBox* m_gpredict;
    CommandButton* m_choose;  // chooses Gpredict's folder
    CommandButton* m_set;
};

}  // namespace boresight::ui
