/* SPDX-License-Identifier: MIT */
/* Wavefront OBJ files into memory: lines into statements, statements into positions, normals and faces.
 *
 * The file passes through one buffer that grows with the longest statement only; statements are joined, ended and read in place.
 * A face may name positions that come later in the file, so the range of indices is checked at the end.
 */
#include "obj.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define CHUNK ((size_t)1 << 16)

struct reader {
    struct obj_model *model;
    const struct obj_options *options;
    FILE *file, *errors;
    char *buffer; /* bytes start to end - 1 are read and not yet used; one more byte is there for a final zero */
    size_t size, start, end;
    uint32_t line;  /* where the statement starts */
    uint32_t lines; /* that were taken from the buffer */
    int at_end;
    double file_size, read;
    int percent; /* shown last */
    size_t position_room, line_room, normal_room, corner_room, face_room;
};

/* Takes the progress off the terminal, so that what follows has the line to itself. */
static void clear_progress(struct reader *r)
{
    const struct obj_options *o = r->options;
    if (o && o->progress && o->terminal && r->percent > 0) fprintf(o->progress, "\r%*s\r", (int)strlen(r->model->path) + 8, "");
    r->percent = 0;
}

static int fail_at(struct reader *r, uint32_t line, const char *format, ...)
{
    va_list arguments;
    clear_progress(r);
    fprintf(r->errors, "%s:%lu: ", r->model->path, (unsigned long)line);
    va_start(arguments, format);
    vfprintf(r->errors, format, arguments);
    va_end(arguments);
    fputc('\n', r->errors);
    return -1;
}

static void show_progress(struct reader *r)
{
    const struct obj_options *o = r->options;
    if (!o || !o->progress || r->file_size <= (double)OBJ_PROGRESS_SIZE) return;
    const int percent = r->read >= r->file_size ? 100 : (int)(100 * r->read / r->file_size);
    const int step = o->terminal ? 1 : 25;
    if (percent / step == r->percent / step) return;
    r->percent = percent;
    fprintf(o->progress, o->terminal ? "\r%s: %d %%" : "%s: %d %%\n", r->model->path, percent / step * step);
    fflush(o->progress);
}

/* ------------------------------------------------------------------------------------------------------ bytes into statements */

/* Reads on. What is not yet used moves to the front of the buffer; a buffer that is full doubles. */
static int refill(struct reader *r)
{
    if (r->start > 0) {
        memmove(r->buffer, r->buffer + r->start, r->end - r->start);
        r->end -= r->start;
        r->start = 0;
    }
    if (r->end > OBJ_STATEMENT_MAX) {
        return fail_at(r, r->line, "statement longer than %lu bytes", (unsigned long)OBJ_STATEMENT_MAX);
    }
    if (r->size - r->end <= CHUNK) {
        char *larger = realloc(r->buffer, 2 * r->size);
        if (!larger) return fail_at(r, r->line, "out of memory");
        r->buffer = larger;
        r->size *= 2;
    }
    errno = 0;
    const size_t got = fread(r->buffer + r->end, 1, CHUNK, r->file);
    if (ferror(r->file)) return fail_at(r, r->lines + 1, "cannot read: %s", strerror(errno));
    r->at_end = got < CHUNK;
    r->end += got;
    r->read += (double)got;
    show_progress(r);
    return 0;
}

/* Ends the line in buffer[from] to buffer[to] (its line feed, or the end of the file).
 * Returns 1 if the statement is complete, 0 if it goes on in the next line, -1 for a NUL byte. */
static int end_line(struct reader *r, size_t from, size_t to)
{
    char *line = r->buffer + from, *end = r->buffer + to;
    r->lines++;
    if (memchr(line, 0, to - from)) return fail_at(r, r->lines, "NUL byte: this is not a text file");
    *end = 0;
    char *comment = memchr(line, '#', to - from);
    if (comment) {
        *comment = 0;
        return 1;
    }
    char *last = end;
    if (last > line && last[-1] == '\r') last--;
    if (last == line || last[-1] != '\\') return 1;
    memset(last - 1, ' ', (size_t)(end - last) + 2);
    return 0;
}

/* The next statement, its lines joined: 1, or 0 at the end of the file, or -1. */
static int next_statement(struct reader *r, char **statement)
{
    size_t from = 0, searched = 0; /* counted from start, which moves */
    r->line = r->lines + 1;
    for (;;) {
        char *feed =
            r->end == r->start + searched ? NULL : memchr(r->buffer + r->start + searched, '\n', r->end - r->start - searched);
        if (!feed && !r->at_end) {
            searched = r->end - r->start;
            if (refill(r)) return -1;
            continue;
        }
        const size_t to = feed ? (size_t)(feed - r->buffer) : r->end;
        if (!feed && r->start + from == r->end && from == 0) return 0;
        const int complete = end_line(r, r->start + from, to);
        if (complete < 0) return -1;
        if (complete || !feed) {
            if (!complete) r->buffer[to] = 0;
            *statement = r->buffer + r->start;
            r->start = feed ? to + 1 : to;
            return 1;
        }
        from = searched = to + 1 - r->start;
    }
}

/* ---------------------------------------------------------------------------------------------------------- words and numbers */

static int is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
static int is_end(char c) { return c == 0 || is_space(c); }
static char *skip_space(char *s)
{
    while (is_space(*s)) s++;
    return s;
}

/* A word from the file in quotes: cut where it is long, everything but printable ASCII replaced. */
static void quote(char out[OBJ_QUOTE], const char *word)
{
    size_t n = 0, i = 0;
    out[n++] = '\'';
    for (; !is_end(word[i]) && n < OBJ_QUOTE - 5; i++) out[n++] = word[i] > ' ' && word[i] <= '~' ? word[i] : '?';
    if (!is_end(word[i])) n += (size_t)sprintf(out + n, "...");
    out[n++] = '\'';
    out[n] = 0;
}

static int fail_word(struct reader *r, const char *word, const char *what)
{
    char quoted[OBJ_QUOTE];
    quote(quoted, word);
    return fail_at(r, r->line, "%s %s", quoted, what);
}

/* Has the word decimal digits only where strtod would also take hexadecimal, "inf" and "nan"? */
static int looks_decimal(const char *s)
{
    if (*s == '+' || *s == '-') s++;
    if (*s == '.') s++;
    return *s >= '0' && *s <= '9' && !(s[0] == '0' && (s[1] == 'x' || s[1] == 'X'));
}

/* "nan", "inf", "infinity", in any case. */
static int looks_infinite(const char *s)
{
    if (*s == '+' || *s == '-') s++;
    const char word[4] = {(char)(s[0] | 32), s[0] ? (char)(s[1] | 32) : '\0', s[0] && s[1] ? (char)(s[2] | 32) : '\0', '\0'};
    return !strcmp(word, "nan") || !strcmp(word, "inf");
}

/* All numbers of a statement: how many, or -1. Those from room on are checked and not kept. */
static int read_numbers(struct reader *r, char *s, double *number, int room)
{
    int count = 0;
    for (s = skip_space(s); *s; s = skip_space(s)) {
        char *end = s;
        const double value = looks_decimal(s) ? strtod(s, &end) : 0;
        if (end == s && looks_infinite(s)) return fail_word(r, s, "is not a finite number");
        if (end == s || !is_end(*end)) return fail_word(r, s, "is not a number");
        if (!(fabs(value) <= OBJ_NUMBER_MAX)) return fail_word(r, s, "is too large a number");
        if (count < room) number[count] = value;
        count++;
        s = end;
    }
    return count;
}

/* ----------------------------------------------------------------------------------------------------------------- statements */

/* Room for one more item after count items of the given size. */
static int make_room(struct reader *r, void *array, size_t *room, size_t count, size_t size)
{
    if (count < *room) return 0;
    if (count >= UINT32_MAX / 2) return fail_at(r, r->line, "too many items for one file");
    void *old;
    memcpy(&old, array, sizeof old);
    const size_t larger = *room ? 2 * *room : 1024;
    void *grown = realloc(old, larger * size);
    if (!grown) return fail_at(r, r->line, "out of memory");
    memcpy(array, &grown, sizeof grown);
    *room = larger;
    return 0;
}

static int read_position(struct reader *r, char *s)
{
    struct obj_model *m = r->model;
    double n[3];
    const int count = read_numbers(r, s, n, 3);
    if (count < 0) return -1;
    if (count < 3 || count == 5 || count > 8) {
        return fail_at(r, r->line, "v needs x y z, and a weight or a colour at most; got %d number%s", count,
                       count == 1 ? "" : "s");
    }
    if (make_room(r, &m->position, &r->position_room, m->positions, sizeof *m->position)) return -1;
    if (make_room(r, &m->position_line, &r->line_room, m->positions, sizeof *m->position_line)) return -1;
    struct point3 p = {n[0], n[1], n[2]};
    m->position_line[m->positions] = r->line;
    m->position[m->positions++] = p;
    return 0;
}

static int read_normal(struct reader *r, char *s)
{
    struct obj_model *m = r->model;
    double n[3];
    const int count = read_numbers(r, s, n, 3);
    if (count < 0) return -1;
    if (count != 3) return fail_at(r, r->line, "vn needs x y z; got %d number%s", count, count == 1 ? "" : "s");
    struct point3 p = {n[0], n[1], n[2]};
    if (!(point3_largest(p) > 0)) return fail_at(r, r->line, "vn has no length");
    if (make_room(r, &m->normal, &r->normal_room, m->normals, sizeof *m->normal)) return -1;
    m->normal[m->normals++] = point3_unit(p);
    return 0;
}

/* One index at *s, which moves behind it; counted from 0 on return. That a positive one is in range is checked at the end. */
static int read_index(struct reader *r, char **s, const char *word, uint32_t count, const char *what, uint32_t *index)
{
    char *p = *s;
    const int negative = *p == '-';
    if (*p == '-' || *p == '+') p++;
    if (*p < '0' || *p > '9') return fail_word(r, word, "is not a corner (v, v/vt, v//vn or v/vt/vn)");
    uint64_t value = 0;
    for (; *p >= '0' && *p <= '9'; p++) {
        if (value < UINT32_MAX) value = 10 * value + (uint64_t)(*p - '0');
    }
    *s = p;
    if (value == 0) return fail_word(r, word, "has an index of 0 (the first is 1)");
    if (value >= OBJ_NONE || (negative && value > count)) {
        char quoted[OBJ_QUOTE];
        quote(quoted, word);
        return fail_at(r, r->line, "index out of range: %s, with %lu %s so far", quoted, (unsigned long)count, what);
    }
    *index = negative ? count - (uint32_t)value : (uint32_t)value - 1;
    return 0;
}

/* One corner at *s, which moves behind it. */
static int read_corner(struct reader *r, char **s, struct obj_corner *corner)
{
    char *word = *s, *p = *s;
    uint32_t texture;
    corner->normal = OBJ_NONE;
    if (read_index(r, &p, word, r->model->positions, "v", &corner->position)) return -1;
    if (*p == '/') {
        p++;
        if (*p != '/' && read_index(r, &p, word, UINT32_MAX, "vt", &texture)) return -1;
        if (*p == '/') {
            p++;
            if (read_index(r, &p, word, r->model->normals, "vn", &corner->normal)) return -1;
        }
    }
    if (!is_end(*p)) return fail_word(r, word, "is not a corner (v, v/vt, v//vn or v/vt/vn)");
    *s = p;
    return 0;
}

static int read_face(struct reader *r, char *s)
{
    struct obj_model *m = r->model;
    struct obj_face face = {m->corners, 0, r->line};
    for (s = skip_space(s); *s; s = skip_space(s)) {
        if (make_room(r, &m->corner, &r->corner_room, m->corners, sizeof *m->corner)) return -1;
        struct obj_corner *corner = &m->corner[m->corners];
        if (read_corner(r, &s, corner)) return -1;
        if ((corner->normal == OBJ_NONE) != (m->corner[face.first].normal == OBJ_NONE)) {
            return fail_at(r, r->line, "corners with and without a normal in one face");
        }
        m->corners++;
        face.corners++;
    }
    if (face.corners < 3) return fail_at(r, r->line, "a face needs 3 corners; got %lu", (unsigned long)face.corners);
    if (make_room(r, &m->face, &r->face_room, m->faces, sizeof *m->face)) return -1;
    m->face[m->faces++] = face;
    return 0;
}

static void count_skipped(struct obj_model *m, const char *keyword)
{
    char quoted[OBJ_QUOTE];
    int i = 0;
    quote(quoted, keyword);
    while (i < m->keywords && strcmp(m->skipped[i].quoted, quoted)) i++;
    if (i == m->keywords && i < OBJ_KEYWORDS) memcpy(m->skipped[m->keywords++].quoted, quoted, sizeof quoted);
    m->skipped[i].lines++;
}

static int read_statement(struct reader *r, char *s)
{
    s = skip_space(s);
    if (s[0] == 'v' && is_end(s[1])) return read_position(r, s + 1);
    if (s[0] == 'f' && is_end(s[1])) return read_face(r, s + 1);
    if (s[0] == 'v' && s[1] == 'n' && is_end(s[2])) return read_normal(r, s + 2);
    if (s[0] == 'v' && s[1] == 't' && is_end(s[2])) return 0;
    if (*s) count_skipped(r->model, s);
    return 0;
}

/* ------------------------------------------------------------------------------------------------------------- the whole file */

static int check_range(struct reader *r)
{
    const struct obj_model *m = r->model;
    for (uint32_t i = 0; i < m->faces; i++) {
        for (uint32_t k = 0; k < m->face[i].corners; k++) {
            const struct obj_corner *c = &m->corner[m->face[i].first + k];
            const int bad_position = c->position >= m->positions, bad_normal = c->normal != OBJ_NONE && c->normal >= m->normals;
            if (!bad_position && !bad_normal) continue;
            return fail_at(r, m->face[i].line, "index out of range: %s %lu, of %lu in the file", bad_position ? "v" : "vn",
                           (bad_position ? c->position : c->normal) + 1UL,
                           (unsigned long)(bad_position ? m->positions : m->normals));
        }
    }
    if (m->faces == 0) return fail_at(r, r->lines ? r->lines : 1, "the file ends without a face");
    return 0;
}

static int read_all(struct reader *r)
{
    char *statement;
    int got;
    if (refill(r)) return -1;
    if (r->end >= 3 && !memcmp(r->buffer, "\xEF\xBB\xBF", 3)) r->start = 3; /* byte order mark */
    while ((got = next_statement(r, &statement)) > 0) {
        if (read_statement(r, statement)) return -1;
    }
    if (got < 0) return -1;
    clear_progress(r);
    return check_range(r);
}

/* Pipes have no size; they are read without progress. */
static double size_of(FILE *file)
{
    double size = 0;
    if (fseek(file, 0, SEEK_END) == 0) {
        size = (double)ftell(file);
        rewind(file);
    }
    clearerr(file);
    return size;
}

int obj_read(struct obj_model *model, const char *path, const struct obj_options *options, FILE *errors)
{
    struct reader r = {.model = model, .options = options, .errors = errors, .size = 4 * CHUNK};
    int result = -1;
    memset(model, 0, sizeof *model);
    model->path = malloc(strlen(path) + 1);
    r.buffer = malloc(r.size);
    if (!model->path || !r.buffer) {
        fprintf(errors, "%s: out of memory\n", path);
    } else if (strcpy(model->path, path), !(r.file = fopen(path, "rb"))) {
        fprintf(errors, "%s: cannot open: %s\n", path, strerror(errno));
    } else {
        r.file_size = size_of(r.file);
        result = read_all(&r);
        fclose(r.file);
    }
    free(r.buffer);
    return result;
}

void obj_print_notes(const struct obj_model *model, FILE *notes)
{
    for (int i = 0; i < model->keywords; i++) {
        const struct obj_skipped *s = &model->skipped[i];
        fprintf(notes, "%s: note: skipped %lu %s line%s\n", model->path, s->lines, s->quoted, s->lines == 1 ? "" : "s");
    }
    if (model->skipped[OBJ_KEYWORDS].lines > 0) {
        fprintf(notes, "%s: note: skipped %lu lines of other keywords\n", model->path, model->skipped[OBJ_KEYWORDS].lines);
    }
}

void obj_free(struct obj_model *model)
{
    free(model->path);
    free(model->position);
    free(model->position_line);
    free(model->normal);
    free(model->corner);
    free(model->face);
    memset(model, 0, sizeof *model);
}
