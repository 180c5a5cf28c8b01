/* SPDX-License-Identifier: MIT */
/* The list of ways along a span that are compared. */
#include "steps_parts.h"

const compare_step_kernel compare_steps[] = {
    {"flat", "flat", 28, compare_begin_flat, compare_run_flat},
    {"linear", "linear", 28, compare_begin_linear, compare_run_linear},
    {"quadratic", "quadratic", 27, compare_begin_quadratic, compare_run_quadratic},
    {"normalise_textbook", "normalise", 28, compare_begin_normal, compare_run_normalise_textbook},
    {"normalise_sqrt", "normalise", 14, compare_begin_normal, compare_run_normalise_sqrt},
    {"normalise_multiply", "normalise", 14, compare_begin_normal, compare_run_normalise_multiply},
#if COMPARE_WITH_LIBM
    {"float_normalise_textbook", "normalise", 28, compare_begin_floats, compare_run_floats_textbook},
    {"float_normalise", "normalise", 28, compare_begin_floats, compare_run_floats},
    {"float_eq7_vector", "eq7_vector", 28, compare_begin_float_vector, compare_run_float_vector},
#endif
    {"lyon_taylor", "lyon_taylor", 28, compare_begin_normal, compare_run_taylor},
    {"forward_length", "forward_length", 14, compare_begin_length, compare_run_length},
#if COMPARE_WITH_MAP
    {"reflection_map", "reflection_map", 14, compare_begin_normal, compare_run_map},
#endif
    {"kuijk_blake", "kuijk_blake", 28, compare_begin_kuijk_blake, compare_run_kuijk_blake},
    {"eq7_vector16", "eq7_vector", 28, compare_begin_vector16, compare_run_vector16},
    {"eq7_vector32", "eq7_vector", 28, compare_begin_vector32, compare_run_vector32},
    {"block2", "block2", 14, compare_begin_block16, compare_run_block2},
    {"block3", "block3", 14, compare_begin_block16, compare_run_block3},
    {"block4", "block4", 14, compare_begin_block16, compare_run_block4},
    {"block4_32", "block4", 30, compare_begin_block32, compare_run_block4_32},
    {"plain16", "eq14", 14, compare_begin_plain16, compare_run_plain16},
    {"plain32", "eq14", 30, compare_begin_plain32, compare_run_plain32},
    {"lambent", "lambent", 30, compare_begin_lambent, compare_run_lambent},
};
const unsigned compare_step_count = sizeof compare_steps / sizeof compare_steps[0];
