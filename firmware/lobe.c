/* SPDX-License-Identifier: MIT */
/* Prepares a lobe: the constants of W_m, or tuned ones from a table.
 *
 * Paper 000 squares an affine function of the cosine, 1 - (n / m) (1 - c), log2 m times; paper 003 takes a parabola with the
 * least largest error. Here the parabola is inside the squarings: one constant after the first of them (or the second), and that
 * with the slope is chosen for the least largest error of the whole. As the centre is to be one, two numbers are left for each n.
 * They are smooth in 2^m / n, so cubics in it serve: no division, and 30 bytes for all lobes from n = 90 on.
 *
 * For the largest n the crossed form errs 0.0007 where the plain one errs 0.0010 and ends in a step of as much; below n = 90 the
 * plain one is better. With three multiplications the same holds from n = 28 on. */
#include "flash.h"

/* Up to which shininess a row serves, its form, and where in its table its numbers start: four constants, or three cubics. */
typedef struct lobe_row {
    uint16_t last;
    uint8_t form, start;
} lobe_row;

/* One of fewer multiplications than the most accurate, and from which shininess on it serves. */
typedef struct cheap_row {
    uint8_t first;
    lobe_row row;
} cheap_row;

/* form: the number of multiplications, and these. */
#define CROSSED 0x80
#define CUBIC 0x40

#include "../tables/lobe_table.h"

/* What the table says of a lobe: alpha, slope * 2^multiplications / n, and the floor in Q2.14; the error bound in UQ0.16. */
typedef struct lobe_constants {
    int32_t alpha, slope, floor, error;
} lobe_constants;

/* The cubic c, highest power first, at y in Q2.14. Each partial sum fits int16_t (tables/gen_lobe.c searches |.| < 2). */
static int32_t curve_at(const LMB_FLASH int16_t *c, int32_t y_q14)
{
    int32_t sum = c[0];
    for (unsigned i = 1; i < 4; i++) sum = lmb_add(lmb_shr(lmb_mul16(sum, y_q14), 14), c[i]);
    return sum;
}

static lobe_constants row_constants(const LMB_FLASH lobe_row *row, const LMB_FLASH int16_t *numbers, unsigned n)
{
    const LMB_FLASH int16_t *c = numbers + row->start;
    lobe_constants k = {c[0], c[1], c[3], c[2]};
    if (row->form & CUBIC) {
        unsigned shift, m = row->form & 7u;
        uint32_t reciprocal = lmb_reciprocal(n, &shift); /* 2^(31 + shift) / n */
        /* 2^m / n to nearest: it is never within 2^-11 of a tie, so that the reciprocal's error cannot show. */
        int32_t y_q14 = (int32_t)(((reciprocal >> (16 + shift - m)) + 1) >> 1);
        k.alpha = curve_at(c, y_q14);
        k.slope = curve_at(c + 4, y_q14);
        k.error = curve_at(c + 8, y_q14);
        k.floor = 0;
    }
    return k;
}

/* The largest g with which the crossed form stays under one just below alpha. There the sum of error and product is 2^32 - 1,
 * and adding the error / 2^16 to g takes less than the error away from it, as x < 2^16, but at least half of it: so g rises to
 * its place from below. */
static int32_t crossed_lift(uint32_t last, unsigned multiplications)
{
    uint32_t x = last, y = lmb_mulu(x, x) >> 16, lift = 0;
    if (multiplications > 2) {
        x = y;
        y = lmb_mulu(y, y) >> 16;
    }
    for (unsigned i = 0; i < 17; i++) lift += ~lmb_mulu(y + lift, x) >> 16;
    return (int32_t)lift;
}

static void lobe_set(lmb_lobe *lobe, unsigned n, unsigned form, const lobe_constants *k)
{
    uint32_t slope = lmb_mulu((uint32_t)k->slope, n); /* below 2^15 * 1000; slope * 2^(14 + multiplications) */
    uint32_t last = (uint32_t)k->alpha * 4 - 1;       /* the largest s below alpha, UQ16.16 */
    unsigned zeros = lmb_clz32(slope);
    lobe->multiplications = (uint8_t)(form & 7u);
    lobe->crossed = (form & CROSSED) != 0;
    lobe->alpha_q30 = lmb_shl(k->alpha, 16);
    /* The largest lift with which last * last + lift is still under one. */
    lobe->lift = lobe->crossed ? crossed_lift(last, lobe->multiplications) : lmb_signed(~(last * last));
    lobe->slope = (uint16_t)((slope << zeros) >> 16);
    lobe->slope_shift = (int8_t)(17 - (int)zeros - (int)lobe->multiplications);
    lobe->floor_q15 = (uint16_t)(k->floor * 2);
    lobe->shininess = (uint16_t)n;
    lobe->error_uq16 = (uint16_t)k->error;
}

/* The lobe of fewest multiplications that promises tolerance; false if there is none but the most accurate. */
static bool set_cheap(lmb_lobe *lobe, unsigned n, uint16_t tolerance)
{
    const LMB_FLASH cheap_row *cheap = cheap_rows, *end = cheap_rows + sizeof cheap_rows / sizeof *cheap_rows;
    for (; cheap != end; cheap++) {
        lobe_constants k;
        if (n < cheap->first || n > cheap->row.last) continue;
        k = row_constants(&cheap->row, cheap_numbers, n);
        if (k.error > tolerance) continue;
        lobe_set(lobe, n, cheap->row.form, &k);
        return true;
    }
    return false;
}

int lmb_lobe_prepare(lmb_lobe *lobe, enum lmb_lobe_kind kind, unsigned n, uint16_t tolerance)
{
    lobe_constants k;
    const unsigned last_kind = LMB_WITH_LOBES ? LMB_LOBE_W16 : LMB_LOBE_TUNED;
    if (n < 1 || n > LMB_SHININESS_MAX || (unsigned)kind > last_kind) return LMB_ERROR_VALUE;
    if (kind != LMB_LOBE_TUNED) {
        k.alpha = k.slope = 16384; /* not an initialiser: that would be copied from flash */
        k.floor = 0;
        k.error = UINT16_MAX;
        lobe_set(lobe, n, (unsigned)kind, &k);
    } else if (!LMB_WITH_LOBES || !set_cheap(lobe, n, tolerance)) {
        const LMB_FLASH lobe_row *row = lobe_rows;
        while (row->last < n) row++;
        k = row_constants(row, lobe_numbers, n);
        lobe_set(lobe, n, row->form, &k);
    }
    return LMB_OK;
}
