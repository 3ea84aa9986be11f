#include "sketchsurfacer/ui/presentation/print_findings.h"

#include "sketchsurfacer/ui/viewport/length_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double linesOfAWall = 2.0; // fewer break in the hand

class Words
{
    Q_DECLARE_TR_FUNCTIONS(ductus::PrintFindings)
public:
    Words(const PrintCheck &check, const PrintSize &size, const QLocale &locale)
        : mCheck(check), mSize(size), mLocale(locale)
    {
    }

    PrintFinding watertight() const
    {
        PrintFinding finding{QStringLiteral("watertight"), FindingKind::Good, {}, {}};
        if (mCheck.isWatertight) {
            finding.text = mCheck.shells == 1 ? tr("Watertight, in one piece.")
                                              : tr("Watertight, in %n pieces.", nullptr, mCheck.shells);
            return finding;
        }
        finding.kind = FindingKind::Bad;
        finding.text =
            tr("Not watertight: the surface ends at a border. A printer needs a closed shape, or a "
               "sheet that is given a thickness elsewhere.");
        if (mCheck.border)
            finding.place = FoundPlace{*mCheck.border, std::nullopt, tr("ends here")};
        return finding;
    }

    std::optional<PrintFinding> wall() const
    {
        if (!mCheck.thinnestWall)
            return std::nullopt;
        const double length = mCheck.thinnestWall->length * mSize.metresPerUnit;
        const QString text = lengthText(length, mLocale);
        PrintFinding finding{QStringLiteral("wall"), FindingKind::Good, {}, placeOf(*mCheck.thinnestWall)};
        if (length < mSize.nozzleMetres) {
            finding.kind = FindingKind::Bad;
            finding.text =
                tr("Thinnest wall %1: less than one line of the nozzle, it will be missing. %2 of the "
                   "surface is as thin.")
                    .arg(text, shareText(mSize.nozzleMetres));
        } else if (length < linesOfAWall * mSize.nozzleMetres) {
            finding.kind = FindingKind::Doubtful;
            finding.text = tr("Thinnest wall %1: less than two lines of the nozzle, it breaks easily. %2 of "
                              "the surface is "
                              "as thin.")
                               .arg(text, shareText(linesOfAWall * mSize.nozzleMetres));
        } else {
            finding.text = tr("Thinnest wall %1.").arg(text);
        }
        return finding;
    }

    std::optional<PrintFinding> gap() const
    {
        if (!mCheck.narrowestGap)
            return std::nullopt;
        const double length = mCheck.narrowestGap->length * mSize.metresPerUnit;
        const QString text = lengthText(length, mLocale);
        PrintFinding finding{QStringLiteral("gap"), FindingKind::Good, {}, placeOf(*mCheck.narrowestGap)};
        if (length < mSize.nozzleMetres) {
            finding.kind = FindingKind::Doubtful;
            finding.text =
                tr("Narrowest gap %1: less than one line of the nozzle, it will grow shut.").arg(text);
        } else {
            finding.text = tr("Narrowest gap %1.").arg(text);
        }
        return finding;
    }

    PrintFinding crossing() const
    {
        PrintFinding finding{
            QStringLiteral("crossing"), FindingKind::Good, tr("Nowhere runs through itself."), {}};
        if (mCheck.crossing) {
            finding.kind = FindingKind::Bad;
            finding.text = tr("Runs through itself: slicers may leave holes there.");
            finding.place = FoundPlace{*mCheck.crossing, std::nullopt, tr("runs through itself")};
        }
        return finding;
    }

    std::optional<PrintFinding> overlap() const
    {
        if (!mCheck.overlap)
            return std::nullopt;
        return PrintFinding{QStringLiteral("overlap"), FindingKind::Doubtful,
                            tr("Pieces overlap: most slicers join them to one."),
                            FoundPlace{*mCheck.overlap, std::nullopt, tr("pieces overlap")}};
    }

private:
    FoundPlace placeOf(const ThicknessSample &sample) const
    {
        return {sample.place, sample.opposite, lengthText(sample.length * mSize.metresPerUnit, mLocale)};
    }

    QString shareText(double metres) const
    {
        const double percent = 100.0 * mCheck.thickness.shareThinnerThan(metres / mSize.metresPerUnit);
        return percent < 1.0 ? tr("Less than 1 %") : tr("%1 %").arg(std::lround(percent));
    }

    const PrintCheck &mCheck;
    const PrintSize &mSize;
    const QLocale &mLocale;
};

} // namespace

std::vector<PrintFinding> printFindings(const PrintCheck &check, const PrintSize &size, const QLocale &locale)
{
    const Words words(check, size, locale);
    std::vector<PrintFinding> findings{words.watertight()};
    for (const std::optional<PrintFinding> &finding : {words.wall(), words.gap()})
        if (finding)
            findings.push_back(*finding);
    findings.push_back(words.crossing());
    if (const std::optional<PrintFinding> overlap = words.overlap())
        findings.push_back(*overlap);
    std::stable_sort(findings.begin(), findings.end(),
                     [](const PrintFinding &a, const PrintFinding &b) { return a.kind > b.kind; });
    return findings;
}

} // namespace ductus
