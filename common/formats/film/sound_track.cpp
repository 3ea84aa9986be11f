#include "formats/film/sound_track.h"

#include "formats/film/encoded_sound.h"
#include "formats/film/sound_source.h"

namespace ductus {

namespace {

// What a decoder needs before the first moment that is heard: AAC and Opus overlap one packet with the next.
constexpr double leadIn = 0.1; // seconds

bool takes(FilmKind kind, AVCodecID codec)
{
    if (kind == FilmKind::Mp4)
        return codec == AV_CODEC_ID_AAC || codec == AV_CODEC_ID_MP3;
    return codec == AV_CODEC_ID_OPUS || codec == AV_CODEC_ID_VORBIS;
}

class CopiedSound : public SoundTrack
{
public:
    explicit CopiedSound(SoundSource source) : mSource(std::move(source)) { mNext = mSource.next(); }

    const AVCodecParameters &parameters() const override { return *mSource.stream().codecpar; }
    AVRational timeBase() const override { return mSource.stream().time_base; }

    Result<void> advance(double seconds, const Take &take) override
    {
        const double unit = av_q2d(timeBase());
        const std::int64_t begin = std::llround(mSource.begins() / unit);
        for (; mNext; mNext = mSource.next()) {
            if (mNext->pts == AV_NOPTS_VALUE)
                continue;
            const double time = double(mNext->pts - begin) * unit;
            if (time >= seconds)
                return {};
            if (time < -leadIn)
                continue;
            mNext->pts -= begin;
            mNext->dts = mNext->dts == AV_NOPTS_VALUE ? mNext->pts : mNext->dts - begin;
            if (Result<void> taken = take(*mNext); !taken)
                return taken;
        }
        return {};
    }
    Result<void> finish(const Take &) override { return {}; }

private:
    SoundSource mSource;
    AVPacket *mNext = nullptr; // the source's, not given yet
};

} // namespace

Result<std::unique_ptr<SoundTrack>> openSoundTrack(const FilmOptions &options, bool needsGlobalHeader)
{
    if (options.soundFrom.empty())
        return std::unique_ptr<SoundTrack>();
    Result<std::optional<SoundSource>> source = SoundSource::open(options.soundFrom, options.soundBegins);
    if (!source)
        return source.error();
    if (!*source)
        return std::unique_ptr<SoundTrack>();
    if (takes(options.kind, (*source)->stream().codecpar->codec_id))
        return std::unique_ptr<SoundTrack>(std::make_unique<CopiedSound>(std::move(**source)));
    return openEncodedSound(std::move(**source), options.kind, needsGlobalHeader);
}

} // namespace ductus
