/* SPDX-License-Identifier: MIT */
/* What the float methods take from libm, declared here since <math.h> is no part of a freestanding C. */
#ifndef COMPARE_FLOATS_H
#define COMPARE_FLOATS_H

#if defined(__AVR__) /* double is float there, and the library has no names with an f */
double sqrt(double x);
double pow(double x, double y);
double acos(double x);
#define sqrtf sqrt
#define powf pow
#define acosf acos
#else
float sqrtf(float x);
float powf(float x, float y);
float acosf(float x);
#endif

#if defined(__GNUC__)
#define COMPARE_ROOT(x) __builtin_sqrtf(x) /* an instruction, where there is one */
#else
#define COMPARE_ROOT(x) sqrtf(x)
#endif

#endif
