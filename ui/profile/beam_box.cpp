// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/beam_box.h"

#include "core/pointing/beam.h"
#include "ui/kit/caption.h"
#include "ui/kit/format.h"
#include "ui/kit/guide_fields.h"
#include "ui/kit/push_button.h"
#include "ui/link/profile_draft.h"

#include <QDoubleSpinBox>
#include <QGridLayout>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr double kMegahertz = 1e6;
constexpr double kFinest = 0.01;  // degrees, the narrowest width that the profile accepts

Angle rounded(Angle width)
{
    return Angle::fromDegrees(std::max(1.0, std::round(width.degrees() / kFinest)) * kFinest);
}

}  // namespace

BeamBox::BeamBox(ProfileDraft& draft, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_diameter(makeField({.name = tr("Diameter of the dish"),
                            .help = tr("Diameter of the dish in metres"),
                            .min = 0.1,
                            .max = 100.0,
                            .unit = QStringLiteral(" m")},
                           this)),
      m_frequency(makeField({.name = tr("Frequency"),
                             .help = tr("Frequency in megahertz"),
                             .min = 1.0,
                             .max = 300000.0,
                             .decimals = 0,
                             .unit = QStringLiteral(" MHz")},
                            this)),
      m_gain(makeField({.name = tr("Gain of the antenna"),
                        .help = tr("Gain over an isotropic antenna"),
                        .min = 0.0,
                        .max = 80.0,
                        .decimals = 1,
                        .unit = QStringLiteral(" dBi")},
                       this)),
      m_useDish(makePushButton({.text = {},
                                .name = tr("Use the beam width of the dish"),
                                .help = tr("Beam width 70° × wavelength / diameter")},
                               this)),
      m_useGain(makePushButton({.text = {},
                                .name = tr("Use the beam width of the gain"),
                                .help = tr("For an antenna whose beam is as wide as it is high")},
                               this))
{
    m_diameter->setValue(1.0);
    m_frequency->setValue(1296.0);
    m_gain->setValue(20.0);
    build();
    for (QDoubleSpinBox* const field : {m_diameter, m_frequency, m_gain}) {
        connect(field, &QDoubleSpinBox::valueChanged, this, &BeamBox::describe);
    }
    connect(m_useDish, &QPushButton::clicked, this, [this] { use(widthOfDish()); });
    connect(m_useGain, &QPushButton::clicked, this, [this] { use(widthOfGain()); });
    describe();
}

void BeamBox::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    grid->addWidget(makeCaption(tr("Dish"), *m_diameter), 0, 0);
    grid->addWidget(m_diameter, 0, 1);
    grid->addWidget(m_frequency, 0, 2);
    grid->addWidget(m_useDish, 0, 3);
    grid->addWidget(makeCaption(tr("Gain"), *m_gain), 1, 0);
    grid->addWidget(m_gain, 1, 1);
    grid->addWidget(m_useGain, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
}

Angle BeamBox::widthOfDish() const
{
    return rounded(pointing::beamWidthOfDish(m_diameter->value(), m_frequency->value() * kMegahertz));
}

Angle BeamBox::widthOfGain() const
{
    return rounded(pointing::beamWidthOfGain(m_gain->value()));
}

void BeamBox::describe()
{
    m_useDish->setText(tr("Use %1").arg(angleText(widthOfDish())));
    m_useGain->setText(tr("Use %1").arg(angleText(widthOfGain())));
}

void BeamBox::use(Angle width)
{
    m_draft.edit([width](profile::Profile& profile) { profile.mount.beamWidth = width; });
}

}  // namespace boresight::ui

#include "moc_beam_box.cpp"
