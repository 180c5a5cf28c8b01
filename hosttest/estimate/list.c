/* SPDX-License-Identifier: MIT */
/* Lists of frames. */
#include "list.h"

#include <stdlib.h>
#include <string.h>

#define LINE 400

static void *room(size_t bytes)
{
    void *p = calloc(1, bytes ? bytes : 1);
    if (!p) {
        fprintf(stderr, "estimate: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return p;
}

static char *copy_of(const char *text)
{
    char *copy = room(strlen(text) + 1);
    return strcpy(copy, text);
}

/* The model of a case: read when it is named first. */
static int model_of(list *l, const char *name, const char *folder, const view *like)
{
    view v = *like;
    char path[LINE];
    unsigned i;
    for (i = 0; i < l->models; i++)
        if (!strcmp(l->names[i], name)) return (int)i;
    snprintf(path, sizeof path, "%s/%s.obj", folder, name);
    v.input = path;
    v.quiet = true;
    if (i == sizeof l->names / sizeof l->names[0] || view_read(&v, &l->meshes[i])) {
        fprintf(stderr, "estimate: no model %s\n", name);
        exit(EXIT_FAILURE);
    }
    l->names[l->models++] = copy_of(name);
    return (int)i;
}

static void add(list *l, const char *text, const char *folder)
{
    static const char help[] = "";
    list_case *c;
    char *word;
    int count = 1;
    l->cases = realloc(l->cases, (l->count + 1) * sizeof *l->cases);
    if (!l->cases) exit(EXIT_FAILURE);
    c = &l->cases[l->count++];
    memset(c, 0, sizeof *c);
    c->text = copy_of(text);
    c->arguments[0] = copy_of("estimate");
    for (word = strtok(copy_of(text), " "); word && count < 63; word = strtok(NULL, " ")) c->arguments[count++] = word;
    {
        const view_program program = {"estimate", help, estimate_option, NULL, &c->view};
        if (view_parse(&c->view.view, &program, count, c->arguments) >= 0) {
            fprintf(stderr, "estimate: wrong line: %s\n", text);
            exit(EXIT_FAILURE);
        }
    }
    c->model = model_of(l, c->view.view.input, folder, &c->view.view);
}

void list_read(list *l, const char *path, const char *folder)
{
    FILE *f = fopen(path, "r");
    char line[LINE];
    memset(l, 0, sizeof *l);
    if (!f) {
        fprintf(stderr, "estimate: cannot read %s\n", path);
        exit(EXIT_FAILURE);
    }
    while (fgets(line, sizeof line, f)) {
        line[strcspn(line, "\n")] = 0;
        if (line[0] && line[0] != '#') add(l, line, folder);
    }
    fclose(f);
}
