#include "document/settings/settings.h"

namespace ductus {

Settings::Settings(QObject *parent) : QObject(parent) {}

Settings::Settings(const QString &iniFile, QObject *parent)
    : QObject(parent), mSettings(iniFile, QSettings::IniFormat)
{
}

QVariant Settings::raw(const QString &key) const
{
    return mSettings.value(key);
}

void Settings::setRaw(const QString &key, const QVariant &value)
{
    mSettings.setValue(key, value);
    emit changed(key);
}

void Settings::remove(const QString &key)
{
    if (!mSettings.contains(key))
        return;
    mSettings.remove(key);
    emit changed(key);
}

QStringList Settings::keysIn(const QString &section) const
{
    mSettings.beginGroup(section);
    const QStringList keys = mSettings.childKeys();
    mSettings.endGroup();
    return keys;
}

bool Settings::sync()
{
    mSettings.sync();
    return mSettings.status() == QSettings::NoError;
}

} // namespace ductus
