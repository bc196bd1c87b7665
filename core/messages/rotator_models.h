// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <QString>

#include <vector>

// The models among which a person chooses a rotator that another program drives. Plain values.
namespace boresight {

struct RotatorModel
{
    int number = 0;
    QString name;  // maker and model

    bool operator==(const RotatorModel&) const = default;
};

struct RotatorModels
{
    std::vector<RotatorModel> list;
    QString problem;  // why there is no list, and what to do

    bool operator==(const RotatorModels&) const = default;
};

}  // namespace boresight

Q_DECLARE_METATYPE(boresight::RotatorModels)
