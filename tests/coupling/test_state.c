/* Every variable of the state is in a table of state, in a checkpoint or in the state kept in memory, and comes back.
 */
#include "coupling/control/rollback.h"
#include "coupling/step.h"
#include "base/files/folder.h"
#include "base/files/state_file.h"
#include "fluid/state_table.h"
#include "solid/measure/detachment.h"
#include "solid/refine/refine.h"
#include "tests/coupling/state_prints.h"
#include "tests/coupling/state_scenes.h"

#include <stdio.h>

/* A run whose fragments are followed and whose bonds that break are recorded. */
static struct run *run_followed(const struct scene *scene) {
    struct run *r = run_new(scene);
    if (r->solid) solid_detachment_begin(r->solid);
    if (r->solid && r->needs.breakage) solid_breaks_begin(r->solid);
    return r;
}

/* What has been tested in some scene. */
enum { TESTED_MAX = 256 };
static const struct state_item *tested[TESTED_MAX];
static int tests;

static int is_tested(const struct state_item *item, enum state_in in) {
    for (int k = 0; k < tests; k++)
        if (tested[k] == item) return (int)(item->in & in) != 0;
    return 0;
}

/* The items of `in` are what they were in `a`, and another thing than in `other`, so that it can be seen. */
static void assert_back(struct run *r, enum state_in in, const struct prints *a, const struct prints *other,
                        const struct prints *back) {
    struct run_state state;
    int lost = 0;
    run_state_of(r, &state);
    assert_int_equal(a->n, back->n);
    for (int k = 0; k < state.list.n; k++) {
        const struct state_item *item = state.list.at[k].item;
        const int is_parameter = item->bytes == 0 && item->shape == STATE_ONE;
        /* where loads are given, s->load is made again by the next step */
        const int is_anew = in == STATE_CHECKPOINT && !strcmp(item->name, "load") && r->solid->external_loads;
        /* body and, kept, which particles there are, are the same throughout */
        const int is_one = !strcmp(item->name, "body") && r->solid->in.bodies == 1;
        const int is_none = (!strcmp(item->name, "contact") && !r->solid->contact) || /* nothing can touch yet */
                            (!strcmp(item->name, "bonds") && !r->needs.breakage);
        if (!(item->in & in) || is_anew || is_none) continue;
        if (!is_parameter && !is_one && a->print[k] == other->print[k]) {
            print_message("%s: the test does not change it\n", item->name);
            lost++;
        }
        if (a->print[k] != back->print[k]) {
            print_message("%s does not come back from %s\n", item->name,
                          in == STATE_CHECKPOINT ? "a checkpoint" : "the state kept in memory");
            lost++;
        }
        if (!is_tested(item, item->in)) tested[tests++] = item;
    }
    if (lost) fail_msg("%d items of state are lost", lost);
}

/* Filled; written; read into another run. */
static void check_checkpoint(struct run *r, const struct scene *scene) {
    char folder[FOLDER_PATH], why[256];
    int head;
    struct run_state state, other_state;
    struct run *other = run_followed(scene);
    snprintf(folder, sizeof folder, "%s/tests/coupling/state_%d", FRANA_BINARY_DIR, par_size());
    folder_make(folder);
    folder_clear(folder);
    fill(r, 1);
    run_state_of(r, &state);
    struct store *s = store_begin(folder, "state", 0);
    state_file_write(s, &state.list);
    store_end(s);
    const struct prints written = prints_of(r, 0), fresh = prints_of(other, 0);
    s = store_read_open_latest(folder);
    assert_non_null(s);
    run_state_of(other, &other_state);
    if (state_file_read(s, &other_state.list, &head, why, sizeof why)) fail_msg("%s %s", why, store_read_error());
    store_read_close(s);
    const struct prints read = prints_of(other, 0);
    assert_back(r, STATE_CHECKPOINT, &written, &fresh, &read);
    if (r->solid) assert_int_equal(r->solid->n_global, other->solid->n_global);
    run_free(other);
}

/* A checkpoint without pi: it starts from p. */
static void check_without_predictor(struct run *r, const struct scene *scene) {
    char folder[FOLDER_PATH], why[256];
    int head, n = 0;
    struct run_state state, other_state;
    struct run *other = run_followed(scene);
    const struct fluid_state *from = fluid_state_of(r->fluid), *to = fluid_state_of(other->fluid);
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    snprintf(folder, sizeof folder, "%s/tests/coupling/state_without_%d", FRANA_BINARY_DIR, par_size());
    folder_make(folder);
    folder_clear(folder);
    fill(r, 1);
    run_state_of(r, &state);
    for (int k = 0; k < state.list.n; k++)
        if (strcmp(state.list.at[k].item->name, "pi") != 0) state.list.at[n++] = state.list.at[k];
    assert_int_equal(n, state.list.n - 1);
    state.list.n = n;
    struct store *s = store_begin(folder, "state", 0);
    state_file_write(s, &state.list);
    store_end(s);
    s = store_read_open_latest(folder);
    assert_non_null(s);
    run_state_of(other, &other_state);
    if (state_file_read(s, &other_state.list, &head, why, sizeof why)) fail_msg("%s %s", why, store_read_error());
    store_read_close(s);
    for (int k = 0; k <= g->m[2]; k++) /* the ghosts that the momentum equation reads are set */
        for (int j = 0; j <= g->m[1]; j++)
            for (int i = 0; i <= g->m[0]; i++) {
                const size_t at = fluid_grid_at(g, i, j, k);
                check_equal(to->pi[at], to->p[at]);
                if (i < g->m[0] && j < g->m[1] && k < g->m[2]) check_equal(to->pi[at], from->p[at]);
            }
    run_free(other);
}

/* Filled; kept; filled with other values; restored. */
static void check_kept(struct run *r) {
    struct rollback *g = rollback_new(r);
    fill(r, 1);
    const struct prints kept = prints_of(r, 1);
    rollback_save(g, r);
    fill(r, 2);
    const struct prints other = prints_of(r, 1);
    assert_true(rollback_restore(g, r) >= 0);
    const struct prints back = prints_of(r, 1);
    assert_back(r, STATE_SNAPSHOT, &kept, &other, &back);
    rollback_free(g);
}

static struct run *run_of(struct scene *scene, int steps) {
    struct run *r = run_followed(scene);
    step_begin_stage(r);
    for (int k = 0; k < steps; k++) step_advance(r);
    return r;
}

static void go(const char *text, int steps, int settings, const char *const *set) {
    struct scene *scene = scene_of(text, "", settings, set);
    struct run *r = run_of(scene, steps);
    if (r->needs.bonds && r->solid->refine) {
        uint8_t *mark = calloc((size_t)r->solid->n + 1, 1);
        for (int h = 0; h < r->solid->n; h++) mark[h] = r->solid->x0[0][h] < 0.01;
        assert_true(solid_refine_marked(r->solid, mark) > 0);
        free(mark);
    }
    check_checkpoint(r, scene);
    check_kept(r);
    run_free(r);
    scene_free(scene);
}

/* A checkpoint of an earlier version, or of a flow with implicit diffusion. */
static void test_without_predictor(void **state) {
    (void)state;
    struct scene *scene = scene_of(flow, "", 0, NULL);
    struct run *r = run_of(scene, 3);
    check_without_predictor(r, scene);
    run_free(r);
    scene_free(scene);
}

static void test_flow(void **state) {
    (void)state;
    const char *const implicit[] = {"fluid.diffusion=implicit", "solid.materials.soft.fracture_energy=.inf"};
    const char *const multistep[] = {"stages.first.fluid_integrator=ab2"};
    go(flow, 3, 0, NULL);
    go(flow, 3, 2, implicit);
    go(flow, 3, 1, multistep);
}

static void test_indented(void **state) {
    (void)state;
    go(indented, 30, 0, NULL);
}

static void test_cracked(void **state) {
    (void)state;
    go(cracked, 10, 0, NULL);
    go(open_notch, 3, 0, NULL);
}

static void test_blocks(void **state) {
    (void)state;
    go(blocks, 30, 0, NULL);
}

static void test_plate(void **state) {
    (void)state;
    go(plate, 3, 0, NULL);
}

/* A struct whose members between two offsets are state, and nothing else. */
struct group {
    const char *name, *table;
    struct state_part part;
    size_t from, to;
};

/* The item whose member ends at an offset. */
static const char *behind(const struct group *g, size_t at) {
    for (int k = 0; k < g->part.items; k++)
        if (g->part.item[k].offset + g->part.item[k].bytes == at) return g->part.item[k].name;
    return "nothing";
}

/* The first offset in from .. to-1 that no item covers, or `to`. Bytes of padding count as not covered. */
static size_t uncovered(const struct state_item *item, int items, size_t from, size_t to) {
    for (int i = 0; i < items && from < to;) {
        const int covers = item[i].offset <= from && from < item[i].offset + item[i].bytes;
        if (covers) from = item[i].offset + item[i].bytes;
        i = covers ? 0 : i + 1;
    }
    return from < to ? from : to;
}

/* No member has been added to a struct's state that its table does not have. */
static void test_covered(void **state) {
    (void)state;
    struct scene *scene = scene_of(flow, "", 0, NULL);
    struct run *r = run_followed(scene);
    struct solid_state_owner owner = {r->solid, r->surface};
    const struct state_part run = run_state_part(r);
    const size_t control = offsetof(struct run, control);
    const struct group group[] = {
        {"run", "coupling/run_state.c", run, offsetof(struct run, t), offsetof(struct run, parts)},
        {"control", "coupling/run_state.c", run, control + offsetof(struct step_control, approach),
         control + offsetof(struct step_control, limits)},
        {"solid", "solid/state_table.c", solid_state_table_part(&owner), offsetof(struct solid, d),
         offsetof(struct solid, a)},
        {"fluid_state", "fluid/state_table.c", fluid_state_table_part(r->fluid), 0,
         offsetof(struct fluid_state, driven)}};
    struct scene *wet = scene_of(cracked, "", 0, NULL);
    struct run *of_wet = run_new(wet);
    const struct group cracks = {"cracks", "cracks/state_table.c", cracks_state_table_part(of_wet->cracks),
                                 offsetof(struct cracks, p), offsetof(struct cracks, struts)};
    int gaps = uncovered(cracks.part.item, cracks.part.items, cracks.from, cracks.to) < cracks.to;
    if (gaps) print_message("struct %s has state that is in no line of %s\n", cracks.name, cracks.table);
    run_free(of_wet);
    scene_free(wet);
    for (size_t k = 0; k < sizeof group / sizeof group[0]; k++) {
        const struct group *g = &group[k];
        size_t at = g->from;
        while ((at = uncovered(g->part.item, g->part.items, at, g->to)) < g->to) {
            size_t end = at;
            while (end < g->to && uncovered(g->part.item, g->part.items, end, g->to) == end) end++;
            print_message("struct %s: bytes %zu to %zu, behind %s, are state and in no line of %s\n", g->name, at,
                          end - 1, behind(g, at), g->table);
            at = end;
            gaps++;
        }
    }
    run_free(r);
    scene_free(scene);
    if (gaps) fail_msg("%d gaps in the tables of state", gaps);
}

/* Each line says why it is not stored or not kept, has a name of its own, and some scene above has it. */
static void test_lines(void **state) {
    (void)state;
    struct scene *scene = scene_of(flow, "", 0, NULL);
    struct run *r = run_followed(scene);
    struct run_state all;
    int bad = 0;
    run_state_of(r, &all);
    for (int p = 0; p < all.parts; p++)
        for (int k = 0; k < all.part[p].items; k++) {
            const struct state_item *item = &all.part[p].item[k];
            int same = 0, after = item->after == NULL;
            for (int q = 0; q < all.parts; q++)
                for (int l = 0; l < all.part[q].items; l++) {
                    same += !strcmp(all.part[q].item[l].name, item->name);
                    after |= item->after && !strcmp(all.part[q].item[l].name, item->after);
                }
            const char *fault = same != 1                                 ? "is there twice"
                                : !after                                  ? "follows an item that there is not"
                                : (item->in == STATE_BOTH) == !!item->why ? "says why, or does not, for no reason"
                                : !is_tested(item, item->in)              ? "is of none of the scenes here"
                                                                          : NULL;
            if (fault) print_message("%s %s\n", item->name, fault);
            bad += fault != NULL;
        }
    run_free(r);
    scene_free(scene);
    assert_int_equal(bad, 0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest all[] = {
        cmocka_unit_test(test_covered),           cmocka_unit_test(test_flow),    cmocka_unit_test(test_blocks),
        cmocka_unit_test(test_indented),          cmocka_unit_test(test_cracked), cmocka_unit_test(test_plate),
        cmocka_unit_test(test_without_predictor), cmocka_unit_test(test_lines)};
    const int failed = cmocka_run_group_tests(all, NULL, NULL);
    par_end();
    return failed;
}
