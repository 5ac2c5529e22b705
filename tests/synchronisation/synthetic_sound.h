// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/sound_track.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace odo::test {

using Sound = std::vector<float>;

/// Sounds of a classroom, made from a seed; all at SoundTrack::rate, their peaks at 1.
class SoundMaker
{
public:
    explicit SoundMaker(std::uint32_t seed) : m_random(seed) {}

    double uniform(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(m_random);
    }
    double normal() { return std::normal_distribution<double>()(m_random); }

    Sound clap()
    {
        Sound sound(at(0.06));
        const double decay = uniform(0.003, 0.009), ring = uniform(900, 2200), q = uniform(0.3, 0.8);
        double low = 0;
        for (std::size_t i = 0; i < sound.size(); ++i) {
            const double t = double(i) / rate;
            low += 0.6 * (normal() - low);
            sound[i] = float(std::exp(-t / decay) * (low * (1 - q) * 2 + q * std::sin(turn * ring * t)));
        }
        return scaled(std::move(sound), 1);
    }
    Sound knock()
    {
        Sound sound(at(0.12));
        const double a = uniform(160, 320), b = uniform(450, 800);
        for (std::size_t i = 0; i < sound.size(); ++i) {
            const double t = double(i) / rate;
            sound[i] = float(std::exp(-t / 0.025) * std::sin(turn * a * t) +
                             0.6 * std::exp(-t / 0.012) * std::sin(turn * b * t) +
                             0.5 * std::exp(-t / 0.0015) * normal());
        }
        return scaled(std::move(sound), 1);
    }
    Sound whistle()
    {
        const double lengthS = uniform(0.25, 0.6), pitch = uniform(2000, 3400), trill = uniform(20, 40),
                     depth = uniform(20, 120), rise = uniform(0.008, 0.03);
        Sound sound(at(lengthS));
        double phase = 0;
        for (std::size_t i = 0; i < sound.size(); ++i) {
            const double t = double(i) / rate, left = lengthS - t;
            phase += turn / rate * (pitch + depth * std::sin(turn * trill * t) + 3 * normal());
            const double level =
                std::min({1.0, t / rise, left / 0.02}) * (0.8 + 0.2 * std::sin(turn * trill * t));
            sound[i] = float(level * (std::sin(phase) + 0.05 * normal()));
        }
        return scaled(std::move(sound), 1);
    }
    /// Syllables of a voice with formants, and hissing consonants between them.
    Sound speech(double lengthS)
    {
        Sound sound(at(lengthS));
        double t = uniform(0, 0.4);
        while (t < lengthS) {
            const double syllable = uniform(0.09, 0.28), pitch = uniform(100, 230), loud = uniform(0.3, 1);
            const double f1 = uniform(300, 800), f2 = uniform(900, 2300), rise = uniform(0.015, 0.04);
            if (uniform(0, 1) < 0.4)
                hiss(sound, t - 0.05, uniform(0.04, 0.09), loud * 0.25);
            for (std::size_t i = at(t); i < std::min(sound.size(), at(t + syllable)); ++i) {
                const double u = double(i) / rate - t;
                const double level = loud * std::min({1.0, u / rise, (syllable - u) / 0.05});
                double value = 0;
                for (int h = 1; h * pitch < 4000; ++h) {
                    const double f = h * pitch;
                    value += (std::exp(-std::pow((f - f1) / 120, 2)) +
                              0.5 * std::exp(-std::pow((f - f2) / 200, 2)) + 0.03) *
                             std::sin(turn * f * (1 + 0.02 * u) * u);
                }
                sound[i] += float(level * value);
            }
            t += syllable + (uniform(0, 1) < 0.2 ? uniform(0.2, 0.9) : uniform(0.02, 0.1));
        }
        return scaled(std::move(sound), 1);
    }
    /// Chords and drums in a regular beat.
    Sound music(double lengthS, bool drums)
    {
        Sound sound(at(lengthS));
        const double beat = uniform(0.35, 0.65);
        double chord = 220;
        int count = 0;
        for (double t = uniform(0, beat); t < lengthS; t += beat / 2, ++count) {
            if (count % 8 == 0)
                chord = 110 * std::pow(2, std::floor(uniform(0, 12)) / 12);
            const double f = chord * std::pow(2, std::floor(uniform(0, 24)) / 12);
            for (std::size_t i = at(t); i < std::min(sound.size(), at(t + 0.6)); ++i) {
                const double u = double(i) / rate - t;
                for (int h = 1; h <= 5; ++h)
                    sound[i] +=
                        float(std::min(1.0, u / 0.005) * std::exp(-u / 0.2) / h * std::sin(turn * f * h * u));
            }
            if (drums && count % 2 == 0)
                hiss(sound, t, 0.03, 1.0 + 0.1 * normal());
        }
        return scaled(std::move(sound), 1);
    }
    Sound hum(double lengthS)
    {
        Sound sound(at(lengthS));
        const double f = uniform(49.9, 50.1), phase = uniform(0, 6);
        for (std::size_t i = 0; i < sound.size(); ++i)
            for (int h = 1; h < 14; ++h)
                sound[i] += float(std::sin(turn * f * h * double(i) / rate + h * phase) / h);
        return scaled(std::move(sound), 1);
    }
    /// Noise whose low pitches are louder.
    Sound roomNoise(std::size_t count)
    {
        Sound sound(count);
        double slow = 0, slower = 0;
        for (float &value : sound) {
            const double white = normal();
            slow += 0.2 * (white - slow);
            slower += 0.02 * (white - slower);
            value = float(0.3 * white + slow + 3 * slower);
        }
        return sound;
    }

    /// What a room makes of it on the way to a microphone: reflections and a tail behind the direct sound,
    /// which comes after `lateS`.
    Sound response(double lateS, double reverbS, double directToReverb)
    {
        Sound room(at(lateS + std::min(0.6, reverbS)) + 40);
        Sound tail(room.size());
        const std::size_t first = at(lateS);
        for (int i = 0; i < 8; ++i)
            put(tail, lateS + 0.001 + std::pow(uniform(0, 1), 1.5) * 0.04,
                uniform(0.2, 1) * (uniform(0, 1) < 0.3 ? -1 : 1));
        for (std::size_t i = first + at(0.003); i < tail.size(); ++i) {
            const double t = double(i - first) / rate;
            tail[i] += float(0.08 * normal() * std::exp(-6.9 * t / reverbS) * std::min(1.0, t / 0.02));
        }
        double energy = 0;
        for (const float value : tail)
            energy += value * value;
        const double level = std::sqrt(1 / (directToReverb * energy));
        for (std::size_t i = 0; i < room.size(); ++i)
            room[i] = float(level * tail[i]);
        put(room, lateS, 1);
        return room;
    }

    static Sound convolved(const Sound &sound, const Sound &room)
    {
        std::size_t size = 1;
        while (size < sound.size() + room.size())
            size *= 2;
        Eigen::FFT<float> fft;
        std::vector<float> a = sound, b = room, out;
        a.resize(size);
        b.resize(size);
        std::vector<std::complex<float>> fa, fb;
        fft.fwd(fa, a);
        fft.fwd(fb, b);
        for (std::size_t i = 0; i < fa.size(); ++i)
            fa[i] *= fb[i];
        fft.inv(out, fa);
        out.resize(sound.size());
        return out;
    }

    static void add(Sound &to, const Sound &what, double timeS, double level)
    {
        for (std::size_t i = 0; i < what.size(); ++i)
            if (at(timeS) + i < to.size())
                to[at(timeS) + i] += float(level) * what[i];
    }
    static Sound scaled(Sound sound, double peak)
    {
        float most = 1e-9F;
        for (const float value : sound)
            most = std::max(most, std::abs(value));
        for (float &value : sound)
            value *= float(peak) / most;
        return sound;
    }
    static std::size_t at(double timeS) { return timeS <= 0 ? 0 : std::size_t(std::lround(timeS * rate)); }

    /// What a camera hears that begins at `startS` and whose clock runs faster by `drift`.
    static Sound recorded(const Sound &world, double startS, double lengthS, double drift)
    {
        Sound sound(at(lengthS));
        for (std::size_t i = 0; i < sound.size(); ++i) {
            const double from = (startS + double(i) / rate / (1 + drift)) * rate;
            const auto whole = std::int64_t(std::floor(from));
            double sum = 0;
            for (std::int64_t k = whole - 15; k <= whole + 16; ++k)
                if (k >= 0 && k < std::int64_t(world.size()))
                    sum += world[std::size_t(k)] * sinc(from - double(k));
            sound[i] = float(sum);
        }
        return sound;
    }
    static SoundTrack track(const Sound &sound, double firstS)
    {
        SoundTrack track;
        track.firstS = firstS;
        for (const float value : sound)
            track.samples.push_back(std::int16_t(std::clamp(std::lround(32'000 * value), -32'767L, 32'767L)));
        return track;
    }

    static constexpr double rate = SoundTrack::rate;

private:
    static constexpr double turn = 2 * std::numbers::pi;

    static double sinc(double x)
    {
        if (std::abs(x) < 1e-9)
            return 1;
        const double y = std::numbers::pi * x;
        return std::sin(y) / y * (0.5 + 0.5 * std::cos(y / 16));
    }
    static void put(Sound &room, double timeS, double level)
    {
        const double from = timeS * rate;
        const auto whole = std::int64_t(std::floor(from));
        for (std::int64_t k = whole - 15; k <= whole + 16; ++k)
            if (k >= 0 && k < std::int64_t(room.size()))
                room[std::size_t(k)] += float(level * sinc(from - double(k)));
    }
    void hiss(Sound &sound, double timeS, double lengthS, double level)
    {
        double before = 0;
        for (std::size_t i = at(timeS); i < std::min(sound.size(), at(timeS + lengthS)); ++i) {
            const double u = double(i) / rate - timeS, white = normal();
            sound[i] +=
                float(level * std::exp(-2 * u / lengthS) * std::min(1.0, u / 0.002) * (white - before));
            before = white;
        }
    }

    std::mt19937 m_random;
};

enum class HeardKind { Clap, DoubleClap, Whistle, Knock, ClapOverSpeech, Music, Drums, Hum };

/// What two cameras in one room record of 20 s.
struct HeardPair
{
    SoundTrack first, second;
    double offsetS = 0; ///< of the second, by what its clock showed at its first frame
};

inline void addKind(SoundMaker &maker, Sound &world, HeardKind kind)
{
    const double timeS = maker.uniform(5, 9);
    const double lengthS = double(world.size()) / SoundMaker::rate;
    if (kind == HeardKind::Clap || kind == HeardKind::DoubleClap || kind == HeardKind::ClapOverSpeech)
        SoundMaker::add(world, maker.clap(), timeS, 1);
    if (kind == HeardKind::DoubleClap)
        SoundMaker::add(world, maker.clap(), timeS + maker.uniform(0.25, 0.6), maker.uniform(0.5, 1));
    if (kind == HeardKind::Whistle)
        SoundMaker::add(world, maker.whistle(), timeS, 0.5);
    if (kind == HeardKind::Knock)
        SoundMaker::add(world, maker.knock(), timeS, 1);
    if (kind == HeardKind::ClapOverSpeech)
        SoundMaker::add(world, maker.speech(lengthS), 0, 0.15);
    if (kind == HeardKind::Music || kind == HeardKind::Drums)
        SoundMaker::add(world, maker.music(lengthS, kind == HeardKind::Drums), 0, 0.5);
    if (kind == HeardKind::Hum)
        SoundMaker::add(world, maker.hum(lengthS), 0, 0.5);
}

/// Each camera hears its own echoes and its own noise; the second clock runs fast by up to 100 ppm. related:
/// they hear the same; else something of the same kind.
inline HeardPair hear(HeardKind kind, std::uint32_t seed, bool related = true)
{
    SoundMaker maker(seed * 7919 + std::uint32_t(kind));
    Sound world(SoundMaker::at(20)), other(world.size());
    addKind(maker, world, kind);
    if (!related)
        addKind(maker, other, kind);
    const double reverbS = maker.uniform(0.3, 0.9);
    const auto microphone = [&](const Sound &sound) {
        Sound heard = SoundMaker::convolved(sound, maker.response(0.010, reverbS, maker.uniform(0.3, 3)));
        SoundMaker::add(heard, maker.roomNoise(heard.size()), 0,
                        0.003 * std::pow(10, maker.uniform(-0.3, 0.6)));
        return SoundMaker::scaled(std::move(heard), 0.9);
    };
    constexpr double firstStartS = 2.5;
    HeardPair pair;
    pair.offsetS = maker.uniform(-2, 3);
    const double drift = maker.uniform(0, 1e-4), firstS = maker.uniform(-0.02, 0.05),
                 secondS = maker.uniform(-0.02, 0.05);
    pair.first =
        SoundMaker::track(SoundMaker::recorded(microphone(world), firstStartS + firstS, 10, 0), firstS);
    pair.second = SoundMaker::track(SoundMaker::recorded(microphone(related ? world : other),
                                                         firstStartS + pair.offsetS + secondS, 9, drift),
                                    secondS);
    return pair;
}

} // namespace odo::test
