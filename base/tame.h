/* A text that may hold words of the command line or of a file. */
#pragma once

/* Changes a text for a terminal: control characters but new lines become blanks, and a word of more than 300 bytes
 * loses its middle. Not collective. */
void tame_text(char *text);
