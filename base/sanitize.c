/* Takes out of a text what a terminal must not get. */
#include "base/sanitize.h"

#include <string.h>

/* Whether a byte belongs to a UTF-8 character that has begun before it. */
static int goes_on(char byte) { return ((unsigned char)byte & 0xc0) == 0x80; }

void sanitize_text(char *text) {
    enum { MOST = 300, HEAD = 200, TAIL = 60 };
    for (char *c = text; *c; c++) {
        const unsigned char byte = (unsigned char)*c;
        if ((byte < ' ' && byte != '\n') || byte == 0x7f) *c = ' ';
        /* U+0080 to U+009f are control characters too */
        if (byte == 0xc2 && (unsigned char)c[1] >= 0x80 && (unsigned char)c[1] < 0xa0) c[0] = c[1] = ' ';
    }
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
