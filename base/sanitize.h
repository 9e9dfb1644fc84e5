/* Sanitizes a text for a terminal, as it may hold words of the command line or of a file. */
#pragma once

/* The bytes of the control character of UTF-8 that begins there, those for the direction of writing included; 0: none
 * begins there. Not collective. */
int sanitize_control(const char *c);
/* Whether the text has one. Not collective. */
int sanitize_has_control(const char *text);
/* Control characters except new lines become blanks, and words of more than 300 bytes are shortened in their middle.
 * Not collective. */
void sanitize_text(char *text);
