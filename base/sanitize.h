/* Sanitizes a text for a terminal, as it may hold words of the command line or of a file. */
#pragma once

/* Control characters except new lines become blanks, and words of more than 300 bytes are shortened in their middle.
 * Not collective. */
void sanitize_text(char *text);
