// AppearancePage: dark, light or as the system.
#pragma once

#include <QWidget>

namespace ductus {

class Settings;

class AppearancePage : public QWidget
{
    Q_OBJECT
public:
    explicit AppearancePage(Settings &settings, QWidget *parent = nullptr);
};

} // namespace ductus
