// Inspector: the column at the right, 300 px wide: a head that stays, below it sections that fold and scroll.
#pragma once

#include <QWidget>

class QScrollArea;
class QVBoxLayout;

namespace ductus {

class FoldingSection;
class Settings;

class Inspector : public QWidget
{
    Q_OBJECT
public:
    /// \a settings remembers which sections are folded.
    explicit Inspector(Settings &settings, QWidget *parent = nullptr);

    /// Takes the widget.
    void setHead(QWidget *widget);
    FoldingSection *addSection(const QString &id, const QString &title, QWidget *content);

private:
    Settings &mSettings;
    QVBoxLayout *mHead;
    QVBoxLayout *mSections;
    QScrollArea *mArea;
};

} // namespace ductus
