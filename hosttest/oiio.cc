// SPDX-License-Identifier: MIT
// OpenImageIO behind a C header: the one place of the project that is C++.
#include "oiio.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

namespace {

using OIIO::ImageBuf;
namespace algo = OIIO::ImageBufAlgo;

OIIO::ImageSpec rgb8(int width, int height) { return OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8); }

// A buffer over pixels that stay the caller's; nothing here writes to them.
ImageBuf over(const uint8_t *rgb, int width, int height)
{
    return ImageBuf(rgb8(width, height), const_cast<uint8_t *>(rgb));
}

int complain(const char *path, const std::string &what)
{
    std::fprintf(stderr, "%s: %s\n", path, what.c_str());
    return -1;
}

}  // namespace

int oiio_write(const char *path, const uint8_t *rgb, int width, int height)
{
    std::string folder = OIIO::Filesystem::parent_path(path), error;
    if (!folder.empty() && !OIIO::Filesystem::is_directory(folder)) OIIO::Filesystem::create_directory(folder, error);
    auto out = OIIO::ImageOutput::create(path);
    if (!out) return complain(path, OIIO::geterror());
    OIIO::ImageSpec spec = rgb8(width, height);
    spec.attribute("png:compressionLevel", 6);
    if (!out->open(path, spec) || !out->write_image(OIIO::TypeDesc::UINT8, rgb) || !out->close()) {
        return complain(path, out->geterror());
    }
    return 0;
}

uint8_t *oiio_read(const char *path, int *width, int *height)
{
    auto in = OIIO::ImageInput::open(path);
    if (!in) {
        complain(path, OIIO::geterror());
        return nullptr;
    }
    const OIIO::ImageSpec &spec = in->spec();
    size_t bytes = static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) * 3;
    uint8_t *rgb = spec.nchannels >= 3 ? static_cast<uint8_t *>(std::malloc(bytes)) : nullptr;
    if (!rgb || !in->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, rgb)) {
        complain(path, rgb ? in->geterror() : "not an RGB picture, or out of memory");
        std::free(rgb);
        return nullptr;
    }
    *width = spec.width;
    *height = spec.height;
    return rgb;
}

int oiio_compare(const uint8_t *a, const uint8_t *b, int width, int height, int tolerance, oiio_difference *out)
{
    // half a level above the tolerance: levels are whole, and 1/255 is not a float
    float limit = (static_cast<float>(tolerance) + 0.5f) / 255.0f;
    auto result = algo::compare(over(a, width, height), over(b, width, height), limit, limit);
    if (result.error && result.nfail == 0) return -1;  // it also says so when pixels are over the limit
    out->max = result.maxerror * 255.0;
    out->mean = result.meanerror * 255.0;
    out->rms = result.rms_error * 255.0;
    out->psnr = result.rms_error > 0 ? std::fmin(99.0, result.PSNR) : 99.0;
    out->over = result.nfail;
    out->share_over = static_cast<double>(result.nfail) / (static_cast<double>(width) * height);
    return 0;
}

namespace {

// Light in proportion, as floats: IEC 61966-2-1.
ImageBuf light_of(const uint8_t *rgb, int width, int height)
{
    ImageBuf light = algo::copy(over(rgb, width, height), OIIO::TypeDesc::FLOAT);
    for (ImageBuf::Iterator<float> p(light); !p.done(); ++p) {
        for (int c = 0; c < 3; c++) {
            const float level = p[c];
            p[c] = level <= 0.04045f ? level / 12.92f : std::pow((level + 0.055f) / 1.055f, 2.4f);
        }
    }
    return light;
}

}  // namespace

int oiio_perceptual(const uint8_t *a, const uint8_t *b, int width, int height)
{
    const ImageBuf first = light_of(a, width, height), second = light_of(b, width, height);
    algo::CompareResults result;
    const int seen = algo::compare_Yee(first, second, result);
    return first.has_error() || second.has_error() ? -1 : seen;
}

int oiio_amplify(const uint8_t *a, const uint8_t *b, int width, int height, int gain, enum oiio_look look, uint8_t *out)
{
    ImageBuf first = over(a, width, height), second = over(b, width, height);
    ImageBuf difference, shown;
    auto signed_float = [](const ImageBuf &from) { return algo::copy(from, OIIO::TypeDesc::FLOAT); };
    bool fine = look == OIIO_OFFSET ? algo::sub(difference, signed_float(first), signed_float(second))
                                    : algo::absdiff(difference, signed_float(first), signed_float(second));
    fine = fine && algo::mul(difference, difference, static_cast<float>(gain));
    if (look == OIIO_OFFSET) fine = fine && algo::add(difference, difference, 128.0f / 255.0f);
    fine = fine && algo::clamp(shown, difference, 0.0f, 1.0f);
    return fine && shown.get_pixels(shown.roi(), OIIO::TypeDesc::UINT8, out) ? 0 : -1;
}
