/* SPDX-License-Identifier: MIT */
/* What image checks take from OpenImageIO: PNG files, and figures that someone else reckons. Pictures are 8-bit RGB
 * without gaps. */
#ifndef LMB_OIIO_H
#define LMB_OIIO_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Writes a PNG file, making its folder. Returns 0, or -1 after a message on stderr. */
int oiio_write(const char *path, const uint8_t *rgb, int width, int height);

/* Reads a picture into memory that the caller frees. NULL after a message on stderr. */
uint8_t *oiio_read(const char *path, int *width, int *height);

/* How far two pictures are apart, in levels of 255 over all channels of all pixels; psnr in dB, 99 for identical ones. */
typedef struct oiio_difference {
    double max, mean, rms, psnr;
    uint64_t over; /* pixels with any channel further apart than the tolerance */
    double share_over;
} oiio_difference;

/* Compares two pictures of the same size; tolerance in levels. Returns 0 or -1. */
int oiio_compare(const uint8_t *a, const uint8_t *b, int width, int height, int tolerance, oiio_difference *out);

/* How many pixels someone would tell apart: Yee's model of the eye (Yee, Pattanaik and Greenberg 2001) at what OpenImageIO and
 * `idiff -p` take by default, a display of 100 cd/m2 seen under 45 degrees. Levels are taken as sRGB's, since the model wants light.
 * Returns -1 if it cannot. */
int oiio_perceptual(const uint8_t *a, const uint8_t *b, int width, int height);

/* The difference times gain: OFFSET shows (a - b) about the middle grey 128, ABSOLUTE shows |a - b|. Returns 0 or -1. */
enum oiio_look { OIIO_OFFSET, OIIO_ABSOLUTE };
int oiio_amplify(const uint8_t *a, const uint8_t *b, int width, int height, int gain, enum oiio_look look, uint8_t *out);

#ifdef __cplusplus
}
#endif
#endif
