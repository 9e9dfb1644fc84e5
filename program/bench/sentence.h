/* Sentences of a page whose numbers come from the files that it is made of. */
#pragma once
#include "program/bench/page.h"

#include <stdio.h>

/* Writes a sentence, with a number in place of each pair of braces:
 *     {ms PART SIZE RANKS}  {ns ...}  {bytes ...}  {flops ...}   of a row; SIZE -: any; bytes and flops are a unit's
 *     {roofline PART SIZE RANKS}  {least PART SIZE RANKS}        share of the machine's limits, %; the time they allow,
 * ms {cans PART SIZE}  {cans_best ...}  {cans_ours ...}         CaNS as it comes, at its best, and ours then, ms
 *     {lammps}  {lammps_ratio}                                   ns a directed bond; over ours in double
 *     {stage STAGE PART}                                         of the main case by Verlet, ms a step
 *     {share PART}  {waiting}                                    of its time, %
 *     {sweeps}  {substeps RK3}                                   its sweeps a step in fracture; the last step's
 * substeps {peers RK3}  {before PART SIZE RANKS}              program/bench/value.h "–": not measured. An unknown word
 * is our mistake. */
void bench_sentence_write(FILE *to, const struct bench_page_files *p, const char *sentence);
