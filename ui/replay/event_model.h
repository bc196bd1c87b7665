// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/table_model.h"
#include "ui/replay/replay_tape.h"

// The events of a recording as a table. The start of a motion is marked. Gui thread.
namespace boresight::ui {

class RecordedEventModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Time,
        Kind,
        From,
        Text
    };

    explicit RecordedEventModel(SharedTape tape, QObject* parent = nullptr);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

    // "14:10:23Z  operator: Go to 113.0° 10.0°"
    [[nodiscard]] static QString sentence(const recording::Event& event);

protected:
    [[nodiscard]] std::size_t rows() const override { return m_tape->events().size(); }

private:
    SharedTape m_tape;
};

}  // namespace boresight::ui
