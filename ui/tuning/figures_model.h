// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/table_model.h"
#include "ui/tuning/tuning_words.h"

#include <vector>

// The figures of one kind of run, before and after a change of the gains.
namespace boresight::ui {

class FiguresModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Name,
        Before,
        After
    };

    explicit FiguresModel(QObject* parent = nullptr);

    void show(const BeforeAndAfter& results);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_rows.size(); }

private:
    struct Row
    {
        QString name;
        QString before{};
        QString after{};

        bool operator==(const Row&) const = default;
    };

    // From both results, by the name of the figure.
    [[nodiscard]] static std::vector<Row> rowsOf(const BeforeAndAfter& results);

    std::vector<Row> m_rows;
};

}  // namespace boresight::ui
