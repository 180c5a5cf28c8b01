/* SPDX-License-Identifier: MIT */
/* lmb-mesh: a Wavefront OBJ file into a const mesh in C, ready for flash.
 *
 * The output depends on nothing but the input's text, its file name and the options. It is written beside its final place and
 * renamed, so that a file is either whole or not there.
 */
#define _XOPEN_SOURCE 700 /* isatty, realpath, open */

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mesh_build.h"

#define COLUMNS 130
#define NAME_MAX_LENGTH 63 /* characters that C99 promises to tell apart within a file */
#define EXIT_USAGE 2

struct job {
    const char *input, *output;
    char name[NAME_MAX_LENGTH + 1];
    struct mesh_options options;
    bool quiet;
};

static const char help[] =
    "usage: lmb-mesh MODEL.obj -o MODEL.c [options]\n"
    "\n"
    "Turns a Wavefront OBJ file into a const lmb_mesh in C, ready for flash.\n"
    "\n"
    "  -o FILE              where the C source goes; - is the standard output\n"
    "  --name IDENT         name of the mesh in C (default: from the file name)\n"
    "  --normals angle      normals that the file lacks: sums over the faces around, weighted by their angle (default)\n"
    "  --normals area       ... weighted by their area\n"
    "  --centre             move the middle of the bounding box to the origin\n"
    "  --fit                --centre, then scale so that the farthest vertex is at distance 1\n"
    "  --drop-degenerate    leave out triangles without area instead of refusing the file\n"
    "  -q, --quiet          no notes and no progress, errors only\n"
    "  -h, --help           this text\n"
    "\n"
    "Reads v, vn and f (any number of corners, concave too; negative indices; missing normals are computed). vt is ignored,\n"
    "other lines are skipped with a note. Bad input gives one line, file:line: what is wrong, exit status 1 and no output;\n"
    "a wrong option gives exit status 2.\n";

static int usage(const char *what, const char *which)
{
    fprintf(stderr, "lmb-mesh: %s%s (see lmb-mesh --help)\n", what, which);
    return EXIT_USAGE;
}

/* ---------------------------------------------------------------------------------------------------------------------- names */

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Keywords of C99 and C++11, and main: not to be a mesh's name. */
static bool is_taken(const char *name)
{
    static const char words[] =
        " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t class compl const "
        "const_cast constexpr continue decltype default delete do double dynamic_cast else enum explicit export extern false "
        "float for friend goto if inline int long main mutable namespace new noexcept not not_eq nullptr operator or or_eq "
        "private protected public register reinterpret_cast restrict return short signed sizeof static static_assert "
        "static_cast struct switch template this thread_local throw true try typedef typeid typename union unsigned using "
        "virtual void volatile wchar_t while xor xor_eq ";
    char padded[NAME_MAX_LENGTH + 3];
    snprintf(padded, sizeof padded, " %s ", name);
    return strstr(words, padded) != NULL;
}

static bool is_word(char c) { return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

static bool is_identifier(const char *name)
{
    const size_t length = strlen(name);
    if (length == 0 || length > NAME_MAX_LENGTH || (name[0] >= '0' && name[0] <= '9')) return false;
    for (size_t i = 0; i < length; i++) {
        if (!is_word(name[i])) return false;
    }
    return !is_taken(name);
}

/* The file's name without its ending, what C does not allow replaced; "mesh_" in front where that is still no name. */
static void name_from_path(char name[NAME_MAX_LENGTH + 1], const char *path)
{
    const char *base = base_name(path), *dot = strrchr(base, '.');
    size_t length = dot && dot > base ? (size_t)(dot - base) : strlen(base);
    if (length > NAME_MAX_LENGTH - 5) length = NAME_MAX_LENGTH - 5;
    memcpy(name, base, length);
    name[length] = 0;
    for (size_t i = 0; i < length; i++) {
        if (!is_word(name[i])) name[i] = '_';
    }
    if (is_identifier(name)) return;
    memmove(name + 5, name, length + 1);
    memcpy(name, "mesh_", 5);
}

/* For a comment: nothing that could end it, continue its line or be a trigraph. */
static void print_harmless(FILE *out, const char *text)
{
    int left = 80;
    for (; *text && left > 0; text++, left--) fputc(is_word(*text) || strchr(" .-+,()", *text) ? *text : '_', out);
}

/* ------------------------------------------------------------------------------------------------------------------- C source */

/* Items in rows no wider than COLUMNS. */
struct rows {
    FILE *out;
    size_t column;
};

static void put_item(struct rows *rows, const char *item)
{
    const size_t length = strlen(item);
    if (rows->column > 0 && rows->column + 2 + length + 1 > COLUMNS) { /* blank, item, comma */
        fputc('\n', rows->out);
        rows->column = 0;
    }
    rows->column += (size_t)fprintf(rows->out, rows->column ? " %s," : "    %s,", item);
}

static void put_vectors(FILE *out, const char *name, const char *what, const lmb_vec *v, uint32_t count)
{
    struct rows rows = {out, 0};
    char item[40];
    fprintf(out, "static const LMB_FLASH lmb_vec %s_%s[%lu] = {\n", name, what, (unsigned long)count);
    for (uint32_t i = 0; i < count; i++) {
        snprintf(item, sizeof item, "{%d, %d, %d}", v[i].x, v[i].y, v[i].z);
        put_item(&rows, item);
    }
    fprintf(out, "\n};\n\n");
}

static void put_indices(FILE *out, const char *name, const lmb_mesh *mesh)
{
    struct rows rows = {out, 0};
    char item[40];
    fprintf(out, "static const LMB_FLASH uint16_t %s_indices[%lu] = {\n", name, 3UL * mesh->triangles);
    for (uint32_t i = 0; i < mesh->triangles; i++) {
        const uint16_t *corner = &mesh->indices[3 * (size_t)i];
        snprintf(item, sizeof item, "%u, %u, %u", corner[0], corner[1], corner[2]);
        put_item(&rows, item);
    }
    fprintf(out, "\n};\n\n");
}

/* Bounds of the quantised positions in space. */
static void put_extents(FILE *out, const lmb_mesh *mesh)
{
    int low[3] = {INT16_MAX, INT16_MAX, INT16_MAX}, high[3] = {INT16_MIN, INT16_MIN, INT16_MIN};
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        const int v[3] = {mesh->positions[i].x, mesh->positions[i].y, mesh->positions[i].z};
        for (int k = 0; k < 3; k++) {
            if (v[k] < low[k]) low[k] = v[k];
            if (v[k] > high[k]) high[k] = v[k];
        }
    }
    for (int k = 0; k < 3; k++) {
        fprintf(out, " * %s%c  %.9g to %.9g\n", k ? "          " : "extents   ", "xyz"[k], ldexp(low[k], mesh->scale),
                ldexp(high[k], mesh->scale));
    }
}

static void put_mesh(FILE *out, const struct job *job, const lmb_mesh *mesh, const struct mesh_info *info)
{
    const unsigned long vectors = (unsigned long)sizeof(lmb_vec) * mesh->vertices;
    fprintf(out, "/* Generated by lmb-mesh from ");
    print_harmless(out, base_name(job->input));
    fprintf(out, "; do not edit.\n *\n");
    fprintf(out, " * vertices  %u\n * triangles %lu\n", mesh->vertices, (unsigned long)mesh->triangles);
    fprintf(out, " * flash     %lu bytes: positions %lu, normals %lu, indices %lu; and one struct lmb_mesh\n", mesh_bytes(mesh),
            vectors, vectors, mesh_bytes(mesh) - 2 * vectors);
    fprintf(out, " * scale     %d: a mesh unit is %.9g units of space\n", mesh->scale, ldexp(1, mesh->scale));
    put_extents(out, mesh);
    fprintf(out, " * error     at most %.3g units of space between a position and its quantised one\n", info->position_error);
    if (job->options.place != MESH_PLACE_KEEP) {
        fprintf(out, " * placed    (file - (%.9g, %.9g, %.9g)) * %.9g\n", info->offset.x, info->offset.y, info->offset.z,
                info->factor);
    }
    fprintf(out, " */\n#include \"lambent.h\"\n\n");
    put_vectors(out, job->name, "positions", mesh->positions, mesh->vertices);
    put_vectors(out, job->name, "normals", mesh->normals, mesh->vertices);
    put_indices(out, job->name, mesh);
    fprintf(out, "extern const lmb_mesh %s;\nconst lmb_mesh %s = {\n", job->name, job->name);
    fprintf(out, "    %s_positions, %s_normals,\n    %s_indices,\n", job->name, job->name, job->name);
    fprintf(out, "    %u, /* vertices */\n    %lu, /* triangles */\n    %d, /* scale */\n    %u, /* bend */\n};\n",
            mesh->vertices, (unsigned long)mesh->triangles, mesh->scale, mesh->bend);
}

/* --------------------------------------------------------------------------------------------------------------- output files */

static int cannot_write(const char *path)
{
    fprintf(stderr, "%s: cannot write: %s\n", path, strerror(errno));
    return EXIT_FAILURE;
}

/* Closes but never the standard output twice; true when every byte has arrived. */
static bool finish(FILE *out)
{
    const bool whole = !ferror(out) && fflush(out) == 0;
    return (out == stdout || fclose(out) == 0) && whole;
}

/* To a name beside the final one, then renamed. */
static int write_beside(const char *path, const struct job *job, const lmb_mesh *mesh, const struct mesh_info *info)
{
    int result = EXIT_SUCCESS;
    const size_t room = strlen(path) + 32;
    char *beside = malloc(room);
    if (!beside) return cannot_write(path);
    snprintf(beside, room, "%s.%ld.tmp", path, (long)getpid());
    const int handle = open(beside, O_WRONLY | O_CREAT | O_EXCL, 0666);
    FILE *out = handle < 0 ? NULL : fdopen(handle, "w");
    if (out) put_mesh(out, job, mesh, info);
    if (!out || !finish(out) || rename(beside, path) != 0) {
        result = cannot_write(job->output);
        if (handle >= 0) remove(beside);
    }
    free(beside);
    return result;
}

/* Devices and pipes are written as they are; of a link, what it points to is replaced. */
static int write_output(const struct job *job, const lmb_mesh *mesh, const struct mesh_info *info)
{
    struct stat in, old;
    if (!strcmp(job->output, "-")) {
        put_mesh(stdout, job, mesh, info);
        return finish(stdout) ? EXIT_SUCCESS : cannot_write("standard output");
    }
    if (stat(job->output, &old) != 0) return write_beside(job->output, job, mesh, info);
    if (stat(job->input, &in) == 0 && in.st_dev == old.st_dev && in.st_ino == old.st_ino) {
        fprintf(stderr, "%s: is the input, and would be overwritten\n", job->output);
        return EXIT_FAILURE;
    }
    if (S_ISREG(old.st_mode)) {
        char *path = realpath(job->output, NULL);
        const int result = path ? write_beside(path, job, mesh, info) : cannot_write(job->output);
        free(path);
        return result;
    }
    FILE *out = fopen(job->output, "w");
    if (!out) return cannot_write(job->output);
    put_mesh(out, job, mesh, info);
    return finish(out) ? EXIT_SUCCESS : cannot_write(job->output);
}

/* --------------------------------------------------------------------------------------------------------------- command line */

/* If argv[*i] is this option, its value: behind an equals sign, or the next argument. NULL if it is another; "" if missing. */
static const char *value_of(const char *option, int argc, char **argv, int *i)
{
    const size_t length = strlen(option);
    if (!strcmp(argv[*i], option)) return *i + 1 < argc ? argv[++*i] : "";
    return option[1] == '-' && !strncmp(argv[*i], option, length) && argv[*i][length] == '=' ? argv[*i] + length + 1 : NULL;
}

/* One option at argv[*i], which moves to its last word. Returns 0, or an exit status. */
static int read_option(struct job *job, int argc, char **argv, int *i)
{
    const char *option = argv[*i], *value;
    if ((value = value_of("-o", argc, argv, i))) {
        job->output = value;
        return *value ? 0 : usage("-o needs a file", "");
    }
    if ((value = value_of("--name", argc, argv, i))) {
        if (!is_identifier(value)) return usage("--name needs an identifier of C, not ", *value ? value : "nothing");
        snprintf(job->name, sizeof job->name, "%s", value);
        return 0;
    }
    if ((value = value_of("--normals", argc, argv, i))) {
        const bool area = !strcmp(value, "area");
        if (!area && strcmp(value, "angle")) return usage("--normals needs area or angle, not ", *value ? value : "nothing");
        job->options.normals = area ? MESH_WEIGHT_AREA : MESH_WEIGHT_ANGLE;
        return 0;
    }
    if (!strcmp(option, "--centre") || !strcmp(option, "--center")) {
        if (job->options.place == MESH_PLACE_KEEP) job->options.place = MESH_PLACE_CENTRE;
        return 0;
    }
    if (!strcmp(option, "--fit")) return job->options.place = MESH_PLACE_FIT, 0;
    if (!strcmp(option, "--drop-degenerate")) return job->options.drop_degenerate = true, 0;
    if (!strcmp(option, "-q") || !strcmp(option, "--quiet")) return job->quiet = true, 0;
    return usage("unknown option ", option);
}

static int read_options(struct job *job, int argc, char **argv)
{
    bool only_files = false;
    for (int i = 1; i < argc; i++) {
        if (!only_files && !strcmp(argv[i], "--")) {
            only_files = true;
        } else if (!only_files && argv[i][0] == '-' && argv[i][1]) {
            const int status = read_option(job, argc, argv, &i);
            if (status) return status;
        } else if (job->input) {
            return usage("one input file only, not also ", argv[i]);
        } else {
            job->input = argv[i];
        }
    }
    if (!job->input) return usage("no input file", "");
    if (!job->output) return usage("no output file: add -o FILE", "");
    if (!job->name[0]) name_from_path(job->name, job->input);
    return 0;
}

static int convert(const struct job *job)
{
    struct obj_options reading = {job->quiet ? NULL : stderr, isatty(STDERR_FILENO)};
    struct obj_model model;
    struct mesh_info info;
    lmb_mesh mesh = {NULL, NULL, NULL, 0, 0, 0, 0};
    int result = EXIT_FAILURE;
    if (obj_read(&model, job->input, &reading, stderr) == 0 && mesh_build(&mesh, &info, &model, &job->options, stderr) == 0) {
        result = write_output(job, &mesh, &info);
        if (result == EXIT_SUCCESS && !job->quiet) {
            obj_print_notes(&model, stderr);
            mesh_print_notes(&info, job->input, stderr);
        }
    }
    mesh_free(&mesh);
    obj_free(&model);
    return result;
}

int main(int argc, char **argv)
{
    struct job job = {.input = NULL};
    for (int i = 1; i < argc && strcmp(argv[i], "--"); i++) {
        if (!strcmp(argv[i], "-h") || !strcmp(argv[i], "--help")) {
            fputs(help, stdout);
            return finish(stdout) ? EXIT_SUCCESS : cannot_write("standard output");
        }
    }
    const int status = read_options(&job, argc, argv);
    return status ? status : convert(&job);
}
