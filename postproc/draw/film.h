/* A film as one animated PNG, which browsers play and show in a page. */
#pragma once

/* Writes the file from the PNGs folder/NAME_0001.png ... of that many frames; each stands for `rest` thousandths of a
 * second, and the film begins again at its end. Returns 0; 1: the pictures are not of one size; -1: a picture cannot be
 * read or the file cannot be written (errno). Unless it returns 0 there is no file. */
int postproc_film_write(const char *path, const char *folder, const char *name, int frames, int rest);
