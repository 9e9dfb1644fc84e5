/* Texts for a terminal: without control characters and without long words. */
#include "base/sanitize.h"
#include "base/text.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

/* What a user's words may hold: an escape sequence, a delete, a control character of two bytes; a letter stays. */
static void control_characters_become_blanks(void **state) {
    (void)state;
    char text[] = "a\033[31mb\tc\x7f d\302\233e\nf\303\251";
    sanitize_text(text);
    assert_string_equal(text, "a [31mb c  d  e\nf\303\251");
    char turned[] =
        "a\342\200\256b\342\201\246c\330\234d\342\200\250e \342\200\223 \342\202\254"; /* a dash, a sign of money */
    sanitize_text(turned);
    assert_string_equal(turned, "a   b   c  d   e \342\200\223 \342\202\254");
    char cut[] = "a\342\200"; /* ends within a character */
    sanitize_text(cut);
    assert_string_equal(cut, "a\342\200");
}

/* 300 bytes stay; of more, 200 of the head, 60 of the tail; a character of two bytes is not divided. */
static void a_long_word_loses_its_middle(void **state) {
    (void)state;
    char *text = text_new("key %0300d %0301d %0*d\nunknown", 7, 8, 100000, 9);
    sanitize_text(text);
    char *expected = text_new("key %0300d %0200d...%060d %0200d...%060d\nunknown", 7, 0, 8, 0, 9);
    assert_string_equal(text, expected);
    free(text);
    free(expected);
    char word[401];
    for (int k = 0; k < 400; k += 2) memcpy(word + k, "\303\251", 2);
    word[400] = '\0';
    memmove(word + 1, word, 399); /* characters begin at odd bytes */
    word[0] = 'a';
    sanitize_text(word);
    assert_memory_equal(word + 195, "\303\251\303\251...\303\251", 9);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(control_characters_become_blanks),
                                       cmocka_unit_test(a_long_word_loses_its_middle)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
