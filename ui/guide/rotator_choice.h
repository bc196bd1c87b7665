// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/adapter.h"
#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QStringList>
#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QLineEdit;
class QSpinBox;

// What turns the mount, in the guide's first step: drives on a bus, or a rotator with a box of its own and where that
// answers. It says what Connect asks there, what has answered, and what to look at when nothing does.
namespace boresight::ui {

class TouchCombo;

class RotatorChoice : public QWidget
{
    Q_OBJECT

public:
    explicit RotatorChoice(QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void showAdapters(const std::vector<Adapter>& adapters);

    [[nodiscard]] bool isRotator() const;   // else the mount has drives on a bus
    [[nodiscard]] bool needsPorts() const;  // its serial ports are listed
    [[nodiscard]] QString whyIncomplete() const;
    [[nodiscard]] ProfileChange::Edit edit() const;  // of what is complete
    [[nodiscard]] QStringList words() const;

Q_SIGNALS:
    void changed();

private:
    void build();
    void showFields();
    void takeFrom(const profile::Profile& profile);
    [[nodiscard]] profile::AxisDriver driver() const;
    [[nodiscard]] Result<std::string> bus() const;
    [[nodiscard]] bool isInUse() const;
    [[nodiscard]] QStringList wordsInUse() const;

    StationStatus m_status;
    std::optional<std::pair<profile::AxisDriver, std::string>> m_taken;  // driver and bus in force, as last shown
    TouchCombo* m_kind;
    QWidget* m_network;
    QWidget* m_serial;
    QLineEdit* m_host;
    QSpinBox* m_port;
    TouchCombo* m_line;
    TouchCombo* m_baud;
};

}  // namespace boresight::ui
