/* What a command has begun and would leave behind if it ended at once: files under temporary names, and one program
 * that writes such files. */
#pragma once
#include <sys/types.h>

/* From now on the file is one of them, until it is dropped or renamed. What is beyond a fixed number is not kept. Not
 * collective. */
void unfinished_add(const char *path);
void unfinished_drop(const char *path);
/* The program that writes them; 0: none. Not collective. */
void unfinished_program(pid_t pid);
/* Ends the program and removes the files. May be called by the handler of a signal. Not collective. */
void unfinished_remove(void);
