/* SPDX-License-Identifier: MIT */
/* Integer arithmetic of Lambent: every product, sum and shift of the library goes through these inlines.
 *
 * Three kinds of addition and shift are told apart by name:
 *   lmb_add         the result is proven to fit; the checked twin asserts it
 *   lmb_add_wrap    wraps modulo 2^32 on purpose; the caller says why the wraps cancel
 * Shifts right of negative values are arithmetic (checked below) and therefore floor: they round towards -infinity.
 * Left shifts of negative values do not occur: lmb_shl multiplies.
 *
 * The checked twin (-DLMB_CHECKED) replaces each inline by one that computes in 64 bits, reports a result out of range
 * with the caller's file and line through lmb_check_failed (supplied by the test program), and counts operations.
 */
#ifndef LMB_ARITH_H
#define LMB_ARITH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A constant inequality beside the code that it protects, in any of C99, C11 and C++11. */
#define LMB_STATIC_ASSERT(what) extern char lmb_static_assert[(what) ? 1 : -1]

/* What C leaves to the implementation and Lambent relies on; everything else is plain C99. */
LMB_STATIC_ASSERT((-5 >> 1) == -3); /* shifts right are arithmetic */
LMB_STATIC_ASSERT((-1 & 3) == 3);   /* two's complement */

/* 1 where a product of 64 bits is an instruction or two, 0 where it would be a call. Results are the same. */
#ifndef LMB_LONG_PRODUCTS
#if defined(__AVR__) || (defined(__riscv) && !defined(__riscv_mul)) ||                                                           \
    (defined(__arm__) && (defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)))
#define LMB_LONG_PRODUCTS 0
#else
#define LMB_LONG_PRODUCTS 1
#endif
#endif

/* Where size is asked for, small functions that are called several times stay out of line. */
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define LMB_OUTLINE __attribute__((noinline))
#define LMB_OUTLINE_OR_INLINE LMB_OUTLINE
#else
#define LMB_OUTLINE
#define LMB_OUTLINE_OR_INLINE inline
#endif

/* Code that is there for speed alone is left out where compilers are asked for small code. */
#ifdef __OPTIMIZE_SIZE__
#define LMB_SHORT_CUTS 0
#else
#define LMB_SHORT_CUTS 1
#endif

/* Kept out of a short loop, whose registers it would take. */
#if LMB_SHORT_CUTS && defined(__GNUC__)
#define LMB_APART __attribute__((noinline))
#define LMB_IN_LINE inline __attribute__((always_inline)) /* however long it is */
#else
#define LMB_APART
#define LMB_IN_LINE inline
#endif

/* The same where a core has but eight registers; others take it in line. */
#if defined(__thumb__) && !defined(__thumb2__)
#define LMB_APART_IF_FEW LMB_APART
#else
#define LMB_APART_IF_FEW inline
#endif

/* Compilers may write short loops out, where code need not be small. */
#if defined(__GNUC__) && __GNUC__ >= 8 && !defined(__OPTIMIZE_SIZE__)
#define LMB_UNROLL _Pragma("GCC unroll 8")
#else
#define LMB_UNROLL
#endif

/* Kept out of line (wide.c), where cores with small instruction sets would take a hundred bytes for each copy. */
unsigned lmb_clz32_search(uint32_t x);
int64_t lmb_mul_wide(int32_t a, int32_t b);

/* Whether the core has a CLZ instruction. */
#if defined(__GNUC__) && (!defined(__arm__) || defined(__ARM_FEATURE_CLZ)) && !defined(__riscv) && !defined(__AVR__) &&          \
    !defined(__XTENSA__)
#define LMB_CLZ 1
#else
#define LMB_CLZ 0
#endif

/* Number of leading zero bits of x in 32; 32 for x = 0. Cores without a CLZ instruction take a binary search in five steps,
 * so that no library helper with a table is linked. */
static inline unsigned lmb_clz32(uint32_t x)
{
#if LMB_CLZ
    return x ? (unsigned)__builtin_clz(x) : 32u;
#else
    return lmb_clz32_search(x);
#endif
}

static inline int32_t lmb_min(int32_t a, int32_t b) { return a < b ? a : b; }
static inline int32_t lmb_max(int32_t a, int32_t b) { return a > b ? a : b; }

/* Bit i of a mask, i below 8. */
static inline bool lmb_bit(uint8_t mask, unsigned i) { return ((uint32_t)mask >> i & 1u) != 0; }

/* A uint32_t bit pattern as int32_t, without the implementation-defined conversion. Compilers make it nothing. */
static inline int32_t lmb_signed(uint32_t x) { return x <= (uint32_t)INT32_MAX ? (int32_t)x : -(int32_t)(UINT32_MAX - x) - 1; }

/* Wrapping kinds: identical in the library and in its twin. */
static inline int32_t lmb_add_wrap(int32_t a, int32_t b) { return lmb_signed((uint32_t)a + (uint32_t)b); }
static inline int32_t lmb_sub_wrap(int32_t a, int32_t b) { return lmb_signed((uint32_t)a - (uint32_t)b); }
static inline int32_t lmb_mul_wrap(int32_t a, int32_t b) { return lmb_signed((uint32_t)a * (uint32_t)b); }
static inline int32_t lmb_shl_wrap(int32_t a, unsigned s) { return lmb_signed((uint32_t)a << s); }

/* floor(a * b / 2^s) of the whole 64-bit product; what does not fit int32_t becomes its nearest end. Out of line (wide.c): cores
 * with 32-bit products alone take a hundred bytes for it. */
int32_t lmb_mul_shr_sat(int32_t a, int32_t b, unsigned s);

/* a * b + c * d of whole products; must fit int64_t. For what is rare: where 64-bit products are calls it costs hundreds of
 * cycles. */
static inline int64_t lmb_dot_wide(int32_t a, int32_t b, int32_t c, int32_t d) { return (int64_t)a * b + (int64_t)c * d; }

/* How many bits |a| | |b| has, 0 to 64. */
static inline unsigned lmb_bits_wide(int64_t a, int64_t b)
{
    uint64_t m = (a < 0 ? 0u - (uint64_t)a : (uint64_t)a) | (b < 0 ? 0u - (uint64_t)b : (uint64_t)b);
    uint32_t high = (uint32_t)(m >> 32);
    return high ? 64u - lmb_clz32(high) : 32u - lmb_clz32((uint32_t)m);
}

#ifndef LMB_CHECKED

/* a + b, a - b; must fit int32_t. */
static inline int32_t lmb_add(int32_t a, int32_t b) { return a + b; }
static inline int32_t lmb_sub(int32_t a, int32_t b) { return a - b; }

/* a * b, both within int16_t: on 8- and 16-bit cores that is the cheap product, elsewhere narrowing would cost. */
static inline int32_t lmb_mul16(int32_t a, int32_t b) { return sizeof(int) == 2 ? (int32_t)(int16_t)a * (int16_t)b : a * b; }

/* a * b; must fit int32_t. */
static inline int32_t lmb_mul(int32_t a, int32_t b) { return a * b; }

/* a * b; must fit uint32_t. */
static inline uint32_t lmb_mulu(uint32_t a, uint32_t b) { return a * b; }

/* floor(a / 2^s), s in 0..31. */
static inline int32_t lmb_shr(int32_t a, unsigned s) { return a >> s; }

/* a / 2^s rounded to nearest, halves up, s in 1..31; a + 2^(s-1) must fit. */
static inline int32_t lmb_shr_round(int32_t a, unsigned s) { return (a + ((int32_t)1 << (s - 1))) >> s; }

/* a * 2^s, s in 0..30; must fit int32_t. */
static inline int32_t lmb_shl(int32_t a, unsigned s) { return a * ((int32_t)1 << s); }

/* floor(a * b / 2^s) of the whole 64-bit product, s in 0..63; must fit int32_t. */
static inline int32_t lmb_mul_shr(int32_t a, int32_t b, unsigned s) { return (int32_t)(((int64_t)a * b) >> s); }

/* floor(a * b / 2^16) with b in 0..65535, in two 32-bit products and without a 64-bit one. |a * b| must stay under 2^47. */
static inline int32_t lmb_mul_q16(int32_t a, uint32_t b)
{
    return (a >> 16) * (int32_t)b + (int32_t)(((uint32_t)(a & 0xffff) * b) >> 16);
}

/* floor(a * b / 2^15) with b in int16_t, in two 32-bit products. |a * b| must stay under 2^46. */
static inline int32_t lmb_mul_q15(int32_t a, int32_t b) { return (a >> 16) * b * 2 + (((a & 0xffff) * b) >> 15); }

/* Whether a * b < c * d, of the whole 64-bit products. */
static inline bool lmb_product_less(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return lmb_mul_wide(a, b) < lmb_mul_wide(c, d);
}

#else /* the checked twin */

typedef struct lmb_counts {
    uint64_t multiplications, additions;
} lmb_counts;
extern lmb_counts lmb_count;
/* Reports and does not return control to a wrong result silently: the test program prints file:line and fails. */
void lmb_check_failed(const char *file, int line, const char *operation, int64_t a, int64_t b, int64_t result);

static inline int64_t lmb_checked_(int64_t r, int64_t low, int64_t high, const char *op, int64_t a, int64_t b, const char *file,
                                   int line)
{
    if (r < low || r > high) lmb_check_failed(file, line, op, a, b, r);
    return r;
}
static inline int32_t lmb_i32_(int64_t r, const char *op, int64_t a, int64_t b, const char *file, int line)
{
    return (int32_t)lmb_checked_(r, INT32_MIN, INT32_MAX, op, a, b, file, line);
}
static inline int32_t lmb_add_(int64_t a, int64_t b, const char *f, int l)
{
    lmb_count.additions++;
    return lmb_i32_(a + b, "add", a, b, f, l);
}
static inline int32_t lmb_sub_(int64_t a, int64_t b, const char *f, int l)
{
    lmb_count.additions++;
    return lmb_i32_(a - b, "sub", a, b, f, l);
}
static inline int32_t lmb_mul16_(int64_t a, int64_t b, const char *f, int l)
{
    lmb_count.multiplications++;
    lmb_checked_(a, INT16_MIN, INT16_MAX, "mul16: first factor", a, b, f, l);
    lmb_checked_(b, INT16_MIN, INT16_MAX, "mul16: second factor", a, b, f, l);
    return (int32_t)(a * b);
}
static inline int32_t lmb_mul_(int64_t a, int64_t b, const char *f, int l)
{
    lmb_count.multiplications++;
    return lmb_i32_(a * b, "mul", a, b, f, l);
}
static inline uint32_t lmb_mulu_(uint32_t a, uint32_t b, const char *f, int l)
{
    lmb_count.multiplications++;
    if (b != 0 && a > UINT32_MAX / b) lmb_check_failed(f, l, "mulu", a, b, 0);
    return a * b;
}
static inline int32_t lmb_shr_(int64_t a, unsigned s, const char *f, int l)
{
    lmb_checked_(s, 0, 31, "shr: distance", a, s, f, l);
    return (int32_t)(a >> (s & 31u));
}
static inline int32_t lmb_shr_round_(int64_t a, unsigned s, const char *f, int l)
{
    lmb_count.additions++;
    lmb_checked_(s, 1, 31, "shr_round: distance", a, s, f, l);
    return lmb_i32_(a + ((int64_t)1 << (s - 1)), "shr_round", a, s, f, l) >> (s & 31u);
}
static inline int32_t lmb_shl_(int64_t a, unsigned s, const char *f, int l)
{
    lmb_checked_(s, 0, 30, "shl: distance", a, s, f, l);
    return lmb_i32_(a * ((int64_t)1 << (s & 31u)), "shl", a, s, f, l);
}
static inline int32_t lmb_mul_shr_(int64_t a, int64_t b, unsigned s, const char *f, int l)
{
    lmb_count.multiplications++;
    lmb_checked_(s, 0, 63, "mul_shr: distance", a, s, f, l);
    return lmb_i32_((a * b) >> (s & 63u), "mul_shr", a, b, f, l);
}
static inline int32_t lmb_mul_q16_(int64_t a, int64_t b, const char *f, int l)
{
    lmb_count.multiplications++;
    lmb_checked_(b, 0, 65535, "mul_q16: second factor", a, b, f, l);
    return lmb_i32_((a * b) >> 16, "mul_q16", a, b, f, l);
}
static inline int32_t lmb_mul_q15_(int64_t a, int64_t b, const char *f, int l)
{
    lmb_count.multiplications++;
    lmb_checked_(b, INT16_MIN, INT16_MAX, "mul_q15: second factor", a, b, f, l);
    return lmb_i32_((a * b) >> 15, "mul_q15", a, b, f, l);
}
static inline bool lmb_product_less(int32_t a, int32_t b, int32_t c, int32_t d)
{
    lmb_count.multiplications += 2;
    return (int64_t)a * b < (int64_t)c * d;
}

#define lmb_add(a, b) lmb_add_((a), (b), __FILE__, __LINE__)
#define lmb_sub(a, b) lmb_sub_((a), (b), __FILE__, __LINE__)
#define lmb_mul16(a, b) lmb_mul16_((a), (b), __FILE__, __LINE__)
#define lmb_mul(a, b) lmb_mul_((a), (b), __FILE__, __LINE__)
#define lmb_mulu(a, b) lmb_mulu_((a), (b), __FILE__, __LINE__)
#define lmb_shr(a, s) lmb_shr_((a), (s), __FILE__, __LINE__)
#define lmb_shr_round(a, s) lmb_shr_round_((a), (s), __FILE__, __LINE__)
#define lmb_shl(a, s) lmb_shl_((a), (s), __FILE__, __LINE__)
#define lmb_mul_shr(a, b, s) lmb_mul_shr_((a), (b), (s), __FILE__, __LINE__)
#define lmb_mul_q15(a, b) lmb_mul_q15_((a), (b), __FILE__, __LINE__)
#define lmb_mul_q16(a, b) lmb_mul_q16_((a), (b), __FILE__, __LINE__)

#endif

#ifdef __cplusplus
}
#endif
#endif
