// Settings: what is remembered of the user between runs, typed. A setting is declared once, with its default:
//
//     inline const Setting<double> lineWidth{"view/lineWidth", 1.5};
//     settings.set(lineWidth, 2.0);
#pragma once

#include <QObject>
#include <QSettings>
#include <QVariant>

namespace ductus {

template <typename T>
struct Setting
{
    const char *key; // "section/name", never translated
    T fallback;
};

class Settings : public QObject
{
    Q_OBJECT
public:
    /// The user's own, in the place the system has for them (application and organization name are those of
    /// QCoreApplication).
    explicit Settings(QObject *parent = nullptr);
    /// Those of an INI file, for tests.
    explicit Settings(const QString &iniFile, QObject *parent = nullptr);

    /// The fallback also if what stands in the file is no T.
    template <typename T>
    T value(const Setting<T> &setting) const
    {
        const QVariant stored = raw(setting.key);
        QVariant converted = stored;
        if (!stored.isValid() || !converted.convert(QMetaType::fromType<T>()))
            return setting.fallback;
        return converted.value<T>();
    }

    /// Emits changed() if it is another value.
    template <typename T>
    void set(const Setting<T> &setting, const T &value)
    {
        if (this->value(setting) != value)
            setRaw(setting.key, QVariant::fromValue(value));
    }

    /// Back to the fallback.
    template <typename T>
    void reset(const Setting<T> &setting)
    {
        remove(setting.key);
    }

    QVariant raw(const QString &key) const;
    void setRaw(const QString &key, const QVariant &value);
    void remove(const QString &key);
    /// Names right below \a section that have a value.
    QStringList keysIn(const QString &section) const;

    /// Writes to the disk now; false if that failed.
    bool sync();

signals:
    void changed(const QString &key);

private:
    mutable QSettings mSettings;
};

} // namespace ductus
