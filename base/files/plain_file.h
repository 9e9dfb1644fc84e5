/* Opens regular files alone: what is written goes through no symbolic link, and no pipe is waited for. */
#pragma once
#include <stdio.h>

/* For reading; a link is followed. NULL: errno, for plain_file_why. Not collective, as all functions here. */
FILE *plain_file_read(const char *path);
/* For writing, in place of what the file holds or, with append 1, behind it. NULL: errno. */
FILE *plain_file_write(const char *path, int append);
/* A new file in the place of a file, link or pipe of this name, which is removed. -1: errno. */
int plain_file_create(const char *path);
/* A sentence on errno of the above. */
const char *plain_file_why(int fault);
