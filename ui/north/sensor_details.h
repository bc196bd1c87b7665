// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/sensor_status.h"
#include "ui/kit/table_model.h"

#include <QString>

#include <utility>
#include <vector>

// Everything that the sensor reports, and what was refused with the reason: one line each, in words. Old values show
// their age. Gui thread.
namespace boresight::ui {

class SensorDetails : public TableModel
{
    Q_OBJECT

public:
    explicit SensorDetails(QObject* parent = nullptr);

    void show(const SensorStatus& sensor);
    [[nodiscard]] QString text() const;  // the text to be copied

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_lines.size(); }

private:
    using Lines = std::vector<std::pair<QString, QString>>;

    static void addReadings(const SensorStatus& sensor, Lines& lines);
    static void addFirmware(const SensorStatus& sensor, Lines& lines);
    static void addCounts(const SensorStatus& sensor, Lines& lines);

    Lines m_lines;
};

}  // namespace boresight::ui
