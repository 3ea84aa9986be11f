#include "widgets/pages/tablet_page.h"

#include "widgets/pages/pressure_curve_editor.h"
#include "widgets/pages/pressure_test_field.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace ductus {

TabletPage::TabletPage(Settings &settings, QWidget *parent) : QWidget(parent)
{
    auto *editor = new PressureCurveEditor;
    auto *field = new PressureTestField;
    auto *straight = new QPushButton(tr("&Straight line"));
    auto *clean = new QPushButton(tr("&Clean field"));
    auto *curveHeading = new QLabel(tr("Pressure"));
    auto *fieldHeading = new QLabel(tr("Try it"));
    auto *note = new QLabel(tr("Raise the left part if you press lightly, lower it if you press hard. "
                               "The other end of the pen erases."));
    straight->setAccessibleName(tr("Straight line"));
    clean->setAccessibleName(tr("Clean field"));
    for (QLabel *heading : {curveHeading, fieldHeading})
        heading->setProperty("heading", true);
    note->setProperty("dim", true);
    note->setWordWrap(true);
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(16);
    layout->setVerticalSpacing(8);
    layout->addWidget(curveHeading, 0, 0);
    layout->addWidget(fieldHeading, 0, 1);
    layout->addWidget(editor, 1, 0);
    layout->addWidget(field, 1, 1);
    layout->addWidget(straight, 2, 0, Qt::AlignLeft);
    layout->addWidget(clean, 2, 1, Qt::AlignLeft);
    layout->addWidget(note, 3, 0, 1, 2);
    layout->setRowStretch(4, 1);
    layout->setColumnStretch(0, 1);
    layout->setColumnStretch(1, 1);

    const auto take = [&settings, editor, field](const PressureCurve &curve) {
        editor->setCurve(curve);
        field->setCurve(curve);
        if (curve == PressureCurve())
            settings.reset(pressureCurveSetting);
        else
            settings.set(pressureCurveSetting, curve.toText());
    };
    take(PressureCurve::fromText(settings.value(pressureCurveSetting)));
    connect(editor, &PressureCurveEditor::curveChanged, this, take);
    connect(straight, &QPushButton::clicked, this, [take] { take(PressureCurve()); });
    connect(clean, &QPushButton::clicked, field, &PressureTestField::clear);
    connect(field, &PressureTestField::pressureChanged, editor, &PressureCurveEditor::setLivePressure);
}

} // namespace ductus
