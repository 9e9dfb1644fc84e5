/* Takes out of a text what a terminal must not get. */
#include "base/sanitize.h"

#include <string.h>

/* Whether a byte belongs to a UTF-8 character that has begun before it. */
static int goes_on(char byte) { return ((unsigned char)byte & 0xc0) == 0x80; }

static unsigned at(const char *c, int k) { return (unsigned char)c[k]; }

/* Up to U+001f, U+007f to U+009f, and those that turn the direction of writing or end a line: U+061c, U+200e, U+200f,
 * U+2028 to U+202e, U+2066 to U+2069. */
int sanitize_control(const char *c) {
    if (at(c, 0) < ' ') return *c != '\0';
    if (at(c, 0) == 0x7f) return 1;
    if (at(c, 0) == 0xc2 && at(c, 1) >= 0x80 && at(c, 1) < 0xa0) return 2;
    if (at(c, 0) == 0xd8 && at(c, 1) == 0x9c) return 2;
    if (at(c, 0) != 0xe2) return 0;
    if (at(c, 1) == 0x80) return at(c, 2) == 0x8e || at(c, 2) == 0x8f || (at(c, 2) >= 0xa8 && at(c, 2) <= 0xae) ? 3 : 0;
    return at(c, 1) == 0x81 && at(c, 2) >= 0xa6 && at(c, 2) <= 0xa9 ? 3 : 0;
}

int sanitize_has_control(const char *text) {
    while (*text && !sanitize_control(text)) text++;
    return *text != '\0';
}

void sanitize_text(char *text) {
    enum { MOST = 300, HEAD = 200, TAIL = 60 };
    for (char *c = text; *c; c++)
        if (*c != '\n') memset(c, ' ', (size_t)sanitize_control(c));
    for (char *word = text; *word; word += strspn(word, " \n")) {
        const size_t length = strcspn(word, " \n");
        if (length > MOST) {
            char *head = word + HEAD, *tail = word + length - TAIL;
            while (goes_on(*head)) head--;
            while (goes_on(*tail)) tail++;
            memcpy(head, "...", 3);
            memmove(head + 3, tail, strlen(tail) + 1);
            word = head + 3 + (word + length - tail);
        } else {
            word += length;
        }
    }
}
