/* A JSON file, written aside and renamed. key is NULL inside an array and for the outermost object. Not collective: one
 * rank writes. NaN and infinity, which JSON lacks, are written as null. */
#pragma once
#include <stdio.h>

struct json; /* opaque, owned by the caller */

struct json *json_begin(const char *path);    /* opens the outermost object */
struct json *json_begin_stream(FILE *stream); /* the same to an open stream, which json_end leaves open */
void json_end(struct json *j);                /* closes the outermost object and all that is still open; dies with exit
                                               * code 4 */

void json_object(struct json *j, const char *key);
void json_array(struct json *j, const char *key);
void json_close(struct json *j); /* closes the innermost open object or array */
/* Opens what the words name, each in the one before: an object by its key, an array by its key and [], and - is an
 * object without a key. Returns how many objects and arrays were open before. */
int json_open(struct json *j, const char *words);
void json_close_to(struct json *j, int open); /* until so many are open */

void json_text(struct json *j, const char *key, const char *value);
void json_number(struct json *j, const char *key, double value);
void json_long(struct json *j, const char *key, long value);
void json_bool(struct json *j, const char *key, int value);
