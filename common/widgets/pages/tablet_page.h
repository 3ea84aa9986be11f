// TabletPage: the pressure curve beside a field to try it on.
#pragma once

#include "document/settings/settings.h"

#include <QWidget>

namespace ductus {

/// PressureCurve::toText()
inline const Setting<QString> pressureCurveSetting{"tablet/pressureCurve", ""};

class TabletPage : public QWidget
{
    Q_OBJECT
public:
    explicit TabletPage(Settings &settings, QWidget *parent = nullptr);
};

} // namespace ductus
