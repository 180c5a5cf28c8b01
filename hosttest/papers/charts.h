/* SPDX-License-Identifier: MIT */
/* Data of the charts: one text file for each, columns named in its first line, as hosttest/charts/NAME.gp reads them. */
#ifndef PAPERS_CHARTS_H
#define PAPERS_CHARTS_H

#include <stdio.h>

/* Opens FOLDER/NAME.dat for writing; the program ends with an error if that fails. The caller closes it with chart_close. */
FILE *chart_open(const char *folder, const char *name);
void chart_close(FILE *file);

/* Each writes the data of its charts into a folder. */
void charts_lobes(const char *folder);     /* papers 000 and 003 */
void charts_steps(const char *folder);     /* paper 001 */
void charts_stability(const char *folder); /* where methods fail */
void charts_pareto(const char *folder);    /* speed against accuracy, from report/pareto.csv beside the folder */

#endif
