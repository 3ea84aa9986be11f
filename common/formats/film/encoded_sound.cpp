#include "formats/film/encoded_sound.h"

extern "C" {
#include <libavutil/channel_layout.h>
}

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr char attempted[] = "Writing the sound";
constexpr int outputRate = 48000; // the only one Opus works at; AAC takes it too
constexpr int bitsAChannel = 80000;

Error failed(ErrorCode code, const std::string &problem, const std::string &remedy = "")
{
    return {code, attempted, problem, remedy, ""};
}

class EncodedSound : public SoundTrack
{
public:
    explicit EncodedSound(SoundSource source) : mSource(std::move(source)) {}

    Result<void> open(FilmKind kind, bool needsGlobalHeader)
    {
        if (Result<void> opened = openDecoder(); !opened)
            return opened;
        if (Result<void> opened = openEncoder(kind, needsGlobalHeader); !opened)
            return opened;
        mIn.reset(av_frame_alloc());
        mOut.reset(av_packet_alloc());
        mFifo.reset(av_audio_fifo_alloc(mEncoder->sample_fmt, mEncoder->ch_layout.nb_channels, 4096));
        mParameters.reset(avcodec_parameters_alloc());
        if (!mIn || !mOut || !mFifo || !mParameters ||
            avcodec_parameters_from_context(mParameters.get(), mEncoder.get()) < 0)
            return failed(ErrorCode::TooLarge, "there is not enough memory");
        return {};
    }

    const AVCodecParameters &parameters() const override { return *mParameters; }
    AVRational timeBase() const override { return {1, mEncoder->sample_rate}; }

    Result<void> advance(double seconds, const Take &take) override
    {
        mEnd = std::llround(seconds * mEncoder->sample_rate);
        while (mWritten + av_audio_fifo_size(mFifo.get()) < mEnd && !mIsDrained)
            if (Result<void> decoded = decodeSome(); !decoded)
                return decoded;
        const int wanted = mEncoder->frame_size > 0 ? mEncoder->frame_size : 1024;
        while (mWritten + wanted <= mEnd && av_audio_fifo_size(mFifo.get()) >= wanted)
            if (Result<void> encoded = encode(wanted, take); !encoded)
                return encoded;
        return {};
    }

    Result<void> finish(const Take &take) override
    {
        // The rest, cut at the film's end to the sample.
        const std::int64_t left = std::min<std::int64_t>(av_audio_fifo_size(mFifo.get()), mEnd - mWritten);
        if (left > 0)
            if (Result<void> encoded = encode(int(left), take); !encoded)
                return encoded;
        if (avcodec_send_frame(mEncoder.get(), nullptr) < 0)
            return failed(ErrorCode::WriteFailed, "the sound cannot be ended");
        return drain(take);
    }

private:
    struct FreeParameters
    {
        void operator()(AVCodecParameters *p) const { avcodec_parameters_free(&p); }
    };

    Result<void> openDecoder()
    {
        const AVCodecParameters &parameters = *mSource.stream().codecpar;
        const AVCodec *decoder = avcodec_find_decoder(parameters.codec_id);
        mDecoder.reset(decoder ? avcodec_alloc_context3(decoder) : nullptr);
        if (!mDecoder || avcodec_parameters_to_context(mDecoder.get(), &parameters) < 0)
            return failed(ErrorCode::Unsupported,
                          std::string("there is no decoder for ") + avcodec_get_name(parameters.codec_id),
                          "Export without sound, or convert the clip to MP4");
        mDecoder->pkt_timebase = mSource.stream().time_base;
        if (const int code = avcodec_open2(mDecoder.get(), decoder, nullptr); code < 0)
            return failed(ErrorCode::Unsupported, "its decoder cannot be opened (" + avMessage(code) + ")");
        return {};
    }

    Result<void> openEncoder(FilmKind kind, bool needsGlobalHeader)
    {
        const char *name = kind == FilmKind::Mp4 ? "aac" : "libopus";
        const AVCodec *encoder = avcodec_find_encoder_by_name(name);
        mEncoder.reset(encoder ? avcodec_alloc_context3(encoder) : nullptr);
        if (!mEncoder)
            return failed(ErrorCode::Unsupported,
                          std::string("this computer's FFmpeg has no encoder for sound (") + name + ")",
                          "Install a complete FFmpeg (Debian: libavcodec-extra59), or export without sound");
        const int channels = mDecoder->ch_layout.nb_channels == 1 ? 1 : 2; // surround is mixed down
        mEncoder->sample_rate = outputRate;
        av_channel_layout_default(&mEncoder->ch_layout, channels);
        mEncoder->sample_fmt = encoder->sample_fmts ? encoder->sample_fmts[0] : AV_SAMPLE_FMT_FLTP;
        mEncoder->bit_rate = std::int64_t(bitsAChannel) * channels;
        mEncoder->time_base = {1, outputRate};
        if (needsGlobalHeader)
            mEncoder->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
        if (const int code = avcodec_open2(mEncoder.get(), encoder, nullptr); code < 0)
            return failed(ErrorCode::Unsupported, "the encoder cannot be opened (" + avMessage(code) + ")");
        return {};
    }

    // One frame's samples, or the end, into the queue. Broken packets are passed over.
    Result<void> decodeSome()
    {
        const int code = avcodec_receive_frame(mDecoder.get(), mIn.get());
        if (code >= 0) {
            const Result<void> queued = queue();
            av_frame_unref(mIn.get());
            return queued;
        }
        if (code != AVERROR(EAGAIN)) {
            mIsDrained = true;
            return {};
        }
        AVPacket *packet = mSource.next();
        avcodec_send_packet(mDecoder.get(), packet); // null: no more will come
        return {};
    }

    Result<void> openResampler()
    {
        AVChannelLayout from = {};
        if (mIn->ch_layout.order != AV_CHANNEL_ORDER_UNSPEC)
            av_channel_layout_copy(&from, &mIn->ch_layout);
        else
            av_channel_layout_default(&from, mIn->ch_layout.nb_channels);
        SwrContext *resampler = nullptr;
        swr_alloc_set_opts2(&resampler, &mEncoder->ch_layout, mEncoder->sample_fmt, mEncoder->sample_rate,
                            &from, AVSampleFormat(mIn->format), mIn->sample_rate, 0, nullptr);
        av_channel_layout_uninit(&from);
        mResampler.reset(resampler);
        if (!mResampler || swr_init(mResampler.get()) < 0)
            return failed(ErrorCode::Unsupported, "the sound is of a kind that cannot be converted");
        // The first sample decides where the sound begins; later ones follow on.
        const double unit = av_q2d(mSource.stream().time_base);
        const std::int64_t time = mIn->best_effort_timestamp;
        const double seconds = time == AV_NOPTS_VALUE ? 0.0 : double(time) * unit - mSource.begins();
        const std::int64_t offset = std::llround(seconds * mEncoder->sample_rate);
        mToDrop = std::max<std::int64_t>(0, -offset);
        mWritten = std::max<std::int64_t>(0, offset);
        return {};
    }

    Result<void> queue()
    {
        if (!mResampler)
            if (Result<void> opened = openResampler(); !opened)
                return opened;
        const int room = swr_get_out_samples(mResampler.get(), mIn->nb_samples);
        std::uint8_t *planes[8] = {};
        if (room <= 0)
            return {};
        if (av_samples_alloc(planes, nullptr, mEncoder->ch_layout.nb_channels, room, mEncoder->sample_fmt,
                             0) < 0)
            return failed(ErrorCode::TooLarge, "there is not enough memory");
        const int made = swr_convert(mResampler.get(), planes, room,
                                     const_cast<const std::uint8_t **>(mIn->extended_data), mIn->nb_samples);
        const int stored =
            made > 0 ? av_audio_fifo_write(mFifo.get(), reinterpret_cast<void **>(planes), made) : 0;
        av_freep(&planes[0]);
        if (made < 0 || stored < 0)
            return failed(ErrorCode::WriteFailed, "the sound cannot be converted");
        const std::int64_t dropped = std::min<std::int64_t>(mToDrop, av_audio_fifo_size(mFifo.get()));
        av_audio_fifo_drain(mFifo.get(), int(dropped));
        mToDrop -= dropped;
        return {};
    }

    Result<void> encode(int samples, const Take &take)
    {
        const AvOwned<AVFrame> frame(av_frame_alloc());
        if (!frame)
            return failed(ErrorCode::TooLarge, "there is not enough memory");
        frame->nb_samples = samples;
        frame->format = mEncoder->sample_fmt;
        av_channel_layout_copy(&frame->ch_layout, &mEncoder->ch_layout);
        frame->sample_rate = mEncoder->sample_rate;
        frame->pts = mWritten;
        if (av_frame_get_buffer(frame.get(), 0) < 0)
            return failed(ErrorCode::TooLarge, "there is not enough memory");
        av_audio_fifo_read(mFifo.get(), reinterpret_cast<void **>(frame->extended_data), samples);
        mWritten += samples;
        if (avcodec_send_frame(mEncoder.get(), frame.get()) < 0)
            return failed(ErrorCode::WriteFailed, "the sound cannot be encoded");
        return drain(take);
    }

    Result<void> drain(const Take &take)
    {
        while (avcodec_receive_packet(mEncoder.get(), mOut.get()) >= 0)
            if (Result<void> taken = take(*mOut); !taken)
                return taken;
        return {};
    }

    SoundSource mSource;
    AvOwned<AVCodecContext> mDecoder, mEncoder;
    AvOwned<SwrContext> mResampler;
    AvOwned<AVFrame> mIn;
    AvOwned<AVPacket> mOut;
    AvOwned<AVAudioFifo> mFifo;
    std::unique_ptr<AVCodecParameters, FreeParameters> mParameters;
    std::int64_t mToDrop = 0;  // samples before the film begins
    std::int64_t mWritten = 0; // where the next sample belongs
    std::int64_t mEnd = 0;     // samples up to here are wanted
    bool mIsDrained = false;
};

} // namespace

Result<std::unique_ptr<SoundTrack>> openEncodedSound(SoundSource source, FilmKind kind,
                                                     bool needsGlobalHeader)
{
    auto sound = std::make_unique<EncodedSound>(std::move(source));
    if (Result<void> opened = sound->open(kind, needsGlobalHeader); !opened)
        return opened.error();
    return std::unique_ptr<SoundTrack>(std::move(sound));
}

} // namespace ductus
