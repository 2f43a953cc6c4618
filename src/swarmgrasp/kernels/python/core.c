/* The kernels as a Python module: arrays in, numbers and bytes out. Checked are sizes, finite numbers
 * and who uses a search; the objects keep the arrays that they were given. */
#include "../place.h"
#include "../quality.h"
#include "../sector.h"
#include "criterion_object.h"
#include "pool_object.h"
#include "sets_object.h"
#include "state.h"

/* -- qualities --------------------------------------------------------------------------------- */

static PyObject *core_weakest(PyObject *module, PyObject *args) {
    PyObject *object;
    Py_buffer view;
    Sweep sweep = {0};
    double quality, bound, units = -1.0, n[3], load[3] = {0.0};
    (void)module;
    if (!PyArg_ParseTuple(args, "O|(ddd)d:weakest", &object, load, load + 1, load + 2, &units)
        || !are_finite(load) || get_doubles(object, &view, 3))
        return NULL;
    int count = rows_of(&view, 3);
    Status status = sweep_room(&sweep, count <= SWEPT ? count : 0, load);
    if (status == SOLVED) {
        Work work = work_of(units < 0.0 ? WORK + PER_ROBOT * count : units, interrupted);
        leave(count > SWEPT);
        status = exact_quality(&sweep, view.buf, count, &work, &quality, &bound, n);
        come_back();
    }
    sweep_free(&sweep);
    PyBuffer_Release(&view);
    if (is_raised(status))
        return NULL;
    return Py_BuildValue("d(ddd)d", quality, n[0], n[1], n[2], bound);
}

static PyObject *core_qualities(PyObject *module, PyObject *args) {
    PyObject *object, *result = NULL;
    Py_buffer view;
    Sweep sweep = {0};
    const double load[3] = {0.0};
    int n;
    (void)module;
    if (!PyArg_ParseTuple(args, "Oi:qualities", &object, &n))
        return NULL;
    if (n < 1 || n > INT_MAX / 3) {
        PyErr_SetString(PyExc_ValueError, "one generator or more is wanted");
        return NULL;
    }
    if (get_doubles(object, &view, 3 * n))
        return NULL;
    int count = rows_of(&view, 3 * n);
    result = PyBytes_FromStringAndSize(NULL, count * (Py_ssize_t)sizeof(double));
    Status status = result ? sweep_room(&sweep, n <= SWEPT ? n : 0, load) : NO_MEMORY;
    if (status == SOLVED) {
        double *values = (double *)PyBytes_AsString(result), bound, weakest[3];
        Work work = work_of(INFINITY, interrupted);
        const double *generators = view.buf;
        leave(count > 1);
        for (int k = 0; k < count && status == SOLVED; k++) {
            status = exact_quality(&sweep, generators + (Py_ssize_t)3 * n * k, n, &work,
                                   values + k, &bound, weakest);
            if (status == SOLVED)
                status = spend(&work, (double)n * n);
        }
        come_back();
    }
    sweep_free(&sweep);
    PyBuffer_Release(&view);
    if (is_raised(status))
        Py_CLEAR(result);
    return result;
}

/* -- the search ----------------------------------------------------------------------------------- */

typedef struct {
    PyObject_HEAD
    Search search;
    Py_buffer generators, pieces;
    PyObject *criterion; /* or NULL */
    Proof *proofs;
    const char *state; /* why it cannot be used, or NULL */
} SearchObject;

static const char BUSY[] = "the search is in use";
static const char BROKEN[] = "the search was stopped while a robot joined";

/* Take a search into use: a signal's handler, or another thread, may call while it runs. */
static Search *take(PyObject *object) {
    SearchObject *self = (SearchObject *)object;
    if (self->state) {
        PyErr_SetString(PyExc_RuntimeError, self->state);
        return NULL;
    }
    self->state = BUSY;
    leave(!self->search.is_small);
    return &self->search;
}

static void give_back(PyObject *object) {
    come_back();
    ((SearchObject *)object)->state = NULL;
}

/* Get rows of pieces, one at least. */
static int get_pieces(PyObject *object, Py_buffer *view) {
    if (get_doubles(object, view, PIECE))
        return -1;
    if (view->len == 0) {
        PyErr_SetString(PyExc_ValueError, "there are no pieces");
        PyBuffer_Release(view);
        return -1;
    }
    return 0;
}

static void search_dealloc(PyObject *object) {
    SearchObject *self = (SearchObject *)object;
    PyTypeObject *type = Py_TYPE(object);
    search_end(&self->search);
    PyMem_Free(self->proofs);
    Py_XDECREF(self->criterion);
    if (self->generators.obj)
        PyBuffer_Release(&self->generators);
    if (self->pieces.obj)
        PyBuffer_Release(&self->pieces);
    freefunc release = (freefunc)PyType_GetSlot(type, Py_tp_free);
    release(object);
    Py_DECREF(type);
}

static PyObject *search_new(PyTypeObject *type, PyObject *args, PyObject *kwargs) {
    PyObject *generators, *pieces, *aim = Py_None;
    const Criterion *criterion = NULL;
    double weights[3], load[3] = {0.0}, units = WORK;
    if (kwargs && PyDict_Size(kwargs) > 0) {
        PyErr_SetString(PyExc_TypeError, "Search takes no keyword arguments");
        return NULL;
    }
    if (!PyArg_ParseTuple(args, "O(ddd)O|(ddd)Od:Search", &generators, weights, weights + 1,
                          weights + 2, &pieces, load, load + 1, load + 2, &aim, &units)
        || !are_finite(weights) || !are_finite(load))
        return NULL;
    const State *state = PyType_GetModuleState(type);
    if (aim != Py_None && !(criterion = criterion_of(state->criterion_type, aim)))
        return NULL;
    allocfunc make = (allocfunc)PyType_GetSlot(type, Py_tp_alloc);
    SearchObject *self = (SearchObject *)make(type, 0);
    if (!self)
        return NULL;
    self->criterion = criterion ? Py_NewRef(aim) : NULL;
    if (get_doubles(generators, &self->generators, 3) || get_pieces(pieces, &self->pieces))
        goto failed;
    int many = rows_of(&self->pieces, PIECE);
    self->proofs = PyMem_Calloc((size_t)many, sizeof *self->proofs);
    if (!self->proofs) {
        PyErr_NoMemory();
        goto failed;
    }
    int count = rows_of(&self->generators, 3);
    leave(count > SWEPT || criterion);
    Status status = search_begin(&self->search, self->generators.buf, count, load, criterion,
                                 weights, self->pieces.buf, many, units, interrupted);
    come_back();
    if (is_raised(status))
        goto failed;
    return (PyObject *)self;
failed:
    Py_DECREF(self);
    return NULL;
}

static PyObject *best_tuple(const Best *best) {
    const double *w = best->wrench;
    return Py_BuildValue("ddddi", best->quality, w[0], w[1], w[2], best->piece);
}

/* solve(gap, chosen) -> (solved, best, top, bounds, rows, shares) */
static PyObject *search_solve_method(PyObject *object, PyObject *args) {
    SearchObject *self = (SearchObject *)object;
    const char *chosen = NULL;
    Py_ssize_t chosen_size = self->search.many;
    double gap;
    Best best;
    if (!PyArg_ParseTuple(args, "dz#:solve", &gap, &chosen, &chosen_size))
        return NULL;
    if (chosen && chosen_size != self->search.many) {
        PyErr_Format(PyExc_ValueError, "there are %d pieces", self->search.many);
        return NULL;
    }
    Search *s = take(object);
    if (!s)
        return NULL;
    Status status = search_solve(s, chosen, gap, &best, self->proofs);
    give_back(object);
    if (is_raised(status))
        return NULL;
    PyObject *bounds = PyBytes_FromStringAndSize(NULL, s->many * (Py_ssize_t)sizeof(double));
    PyObject *rows = PyBytes_FromStringAndSize(NULL, 4 * s->many * (Py_ssize_t)sizeof(int));
    PyObject *shares = PyBytes_FromStringAndSize(NULL, 4 * s->many * (Py_ssize_t)sizeof(double));
    PyObject *tuple = best_tuple(&best);
    if (bounds && rows && shares && tuple) {
        double *bound = (double *)PyBytes_AsString(bounds);
        double *share = (double *)PyBytes_AsString(shares);
        int *row = (int *)PyBytes_AsString(rows);
        double top = 0.0;
        for (int k = 0; k < s->many; k++) {
            const Proof *proof = self->proofs + k;
            bound[k] = proof->bound;
            top = larger(top, proof->bound);
            for (int i = 0; i < 4; i++) {
                row[4 * k + i] = proof->row[i] - LIMITS;
                share[4 * k + i] = proof->row[i] >= LIMITS ? proof->share[i] : 0.0;
                if (share[4 * k + i] > 0.0)
                    share[4 * k + i] *= search_length(s, proof->row[i]);
            }
        }
        return Py_BuildValue("(ONdNNN)", status == SOLVED ? Py_True : Py_False, tuple, top, bounds,
                             rows, shares);
    }
    Py_XDECREF(bounds);
    Py_XDECREF(rows);
    Py_XDECREF(shares);
    Py_XDECREF(tuple);
    return NULL;
}

/* break_tie(best, target) -> best */
static PyObject *search_break_tie_method(PyObject *object, PyObject *args) {
    SearchObject *self = (SearchObject *)object;
    Best best;
    double target, *w = best.wrench;
    if (!PyArg_ParseTuple(args, "(ddddi)d:break_tie", &best.quality, w, w + 1, w + 2, &best.piece,
                          &target))
        return NULL;
    Search *s = take(object);
    if (!s)
        return NULL;
    Status status = SOLVED;
    if (search_is_tied(s, &best, self->proofs, target))
        status = search_break_tie(s, self->proofs, target, &best);
    give_back(object);
    return is_raised(status) ? NULL : best_tuple(&best);
}

/* join(c, s, torque, pieces): the robot belongs to the swarm from now on */
static PyObject *search_join_method(PyObject *object, PyObject *args) {
    SearchObject *self = (SearchObject *)object;
    PyObject *pieces;
    Py_buffer view, before;
    double wrench[3];
    if (!PyArg_ParseTuple(args, "dddO:join", wrench, wrench + 1, wrench + 2, &pieces)
        || !are_finite(wrench) || get_pieces(pieces, &view))
        return NULL;
    int many = rows_of(&view, PIECE);
    Proof *proofs = PyMem_Calloc((size_t)many, sizeof *proofs), *old = self->proofs;
    Search *s = proofs ? take(object) : NULL;
    if (!s) {
        int is_full = !proofs;
        PyMem_Free(proofs);
        PyBuffer_Release(&view);
        return is_full ? PyErr_NoMemory() : NULL;
    }
    before = self->pieces;
    self->proofs = proofs;
    self->pieces = view;
    Status status = search_join(s, wrench, view.buf, many);
    give_back(object);
    PyMem_Free(old);
    PyBuffer_Release(&before);
    if (is_raised(status)) {
        self->state = BROKEN;
        return NULL;
    }
    return Py_NewRef(Py_None);
}

/* quality_with(c, s, torque) -> (quality, normal) */
static PyObject *search_quality_method(PyObject *object, PyObject *args) {
    double wrench[3], quality, n[3];
    if (!PyArg_ParseTuple(args, "ddd:quality_with", wrench, wrench + 1, wrench + 2)
        || !are_finite(wrench))
        return NULL;
    Search *s = take(object);
    if (!s)
        return NULL;
    Status status = search_value(s, wrench, &quality, n);
    give_back(object);
    if (is_raised(status))
        return NULL;
    return Py_BuildValue("d(ddd)", quality, n[0], n[1], n[2]);
}

static Status find_quality(void *search, const double *robot, double *found) {
    double normal[3];
    return search_value(search, robot, found, normal);
}

/* qualities_with(robots) -> bytes */
static PyObject *search_qualities_method(PyObject *object, PyObject *robots) {
    Search *s = take(object);
    if (!s)
        return NULL;
    come_back(); /* until it is known what robots there are */
    PyObject *result = each_row(robots, 3, 1, !s->is_small, find_quality, s);
    give_back(object);
    return result;
}

/* height(x, y, z) -> float */
static PyObject *search_height_method(PyObject *object, PyObject *args) {
    double n[3];
    if (!PyArg_ParseTuple(args, "ddd:height", n, n + 1, n + 2))
        return NULL;
    const Search *s = take(object);
    if (!s)
        return NULL;
    double height;
    Status status = search_height(s, n, &height);
    give_back(object);
    return is_raised(status) ? NULL : PyFloat_FromDouble(height);
}

/* normals() -> bytes: the pool's unit normals */
static PyObject *search_normals_method(PyObject *object, PyObject *ignored) {
    const Search *s = take(object);
    (void)ignored;
    if (!s)
        return NULL;
    give_back(object); /* nothing below lets others run */
    int count = s->count - LIMITS;
    PyObject *result = PyBytes_FromStringAndSize(NULL, 3 * count * (Py_ssize_t)sizeof(double));
    if (!result)
        return NULL;
    double *normals = (double *)PyBytes_AsString(result);
    for (int k = 0; k < count; k++, normals += 3) {
        for (int i = 0; i < 3; i++)
            normals[i] = s->pool[k + LIMITS].m[i] / s->weights[i];
        double size = length(normals);
        for (int i = 0; i < 3; i++)
            normals[i] /= size;
    }
    return result;
}

static PyObject *search_quality_get(PyObject *object, void *ignored) {
    (void)ignored;
    return PyFloat_FromDouble(((SearchObject *)object)->search.quality);
}

static PyObject *search_weakest_get(PyObject *object, void *ignored) {
    const double *n = ((SearchObject *)object)->search.weakest;
    (void)ignored;
    return Py_BuildValue("(ddd)", n[0], n[1], n[2]);
}

static PyObject *search_size_get(PyObject *object, void *ignored) {
    (void)ignored;
    return PyFloat_FromDouble(((SearchObject *)object)->search.size);
}

static PyObject *search_left_get(PyObject *object, void *ignored) {
    (void)ignored;
    return PyFloat_FromDouble(((SearchObject *)object)->search.work.left);
}

static PyMethodDef search_methods[] = {
    {"solve", search_solve_method, METH_VARARGS, NULL},
    {"break_tie", search_break_tie_method, METH_VARARGS, NULL},
    {"join", search_join_method, METH_VARARGS, NULL},
    {"quality_with", search_quality_method, METH_VARARGS, NULL},
    {"qualities_with", search_qualities_method, METH_O, NULL},
    {"height", search_height_method, METH_VARARGS, NULL},
    {"normals", search_normals_method, METH_NOARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static PyGetSetDef search_getset[] = {
    {"quality", search_quality_get, NULL, NULL, NULL},
    {"weakest", search_weakest_get, NULL, NULL, NULL},
    {"size", search_size_get, NULL, NULL, NULL},
    {"left", search_left_get, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};

static PyType_Slot search_slots[] = {
    {Py_tp_new, search_new},         {Py_tp_dealloc, search_dealloc},
    {Py_tp_methods, search_methods}, {Py_tp_getset, search_getset},
    {0, NULL},
};

static PyType_Spec search_spec = {
    .name = "swarmgrasp.kernels.core.Search",
    .basicsize = sizeof(SearchObject),
    .flags = Py_TPFLAGS_DEFAULT,
    .slots = search_slots,
};

/* -- the module ------------------------------------------------------------------------------------ */

static PyMethodDef methods[] = {
    {"weakest", core_weakest, METH_VARARGS, NULL},
    {"qualities", core_qualities, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL},
};

/* Put an object that was just made, or NULL with an exception, into a module, which takes it. */
static int put(PyObject *module, const char *name, PyObject *object) {
    int outcome = PyModule_AddObjectRef(module, name, object);
    Py_XDECREF(object);
    return outcome;
}

static int fill(PyObject *module) {
    State *state = PyModule_GetState(module);
    state->criterion_type = make_criterion_type(module);
    state->sets_type = make_sets_type(module);
    return put(module, "Criterion", Py_XNewRef(state->criterion_type))
           || put(module, "Sets", Py_XNewRef(state->sets_type))
           || put(module, "Boxes", make_boxes_type(module))
           || put(module, "Spans", make_spans_type(module))
           || put(module, "Search", PyType_FromModuleAndSpec(module, &search_spec, NULL))
           || put(module, "MARGINAL", PyFloat_FromDouble(ZERO))
           || put(module, "FLOOR", PyFloat_FromDouble(FLOOR))
           || put(module, "UNASKED", PyFloat_FromDouble(UNASKED))
           || put(module, "ASKS", PyLong_FromLong(ASKS))
           || put(module, "BOX", PyLong_FromLong(BOX_ROW))
           || put(module, "TERM", PyLong_FromLong(TERM_ROW))
           || put(module, "SPAN", PyLong_FromLong(SPAN_ROW))
           || put(module, "WORK", PyFloat_FromDouble(WORK)) ? -1 : 0;
}

static int visit_state(PyObject *module, visitproc visit, void *arg) {
    Py_VISIT(((State *)PyModule_GetState(module))->criterion_type);
    Py_VISIT(((State *)PyModule_GetState(module))->sets_type);
    return 0;
}

static int clear_state(PyObject *module) {
    Py_CLEAR(((State *)PyModule_GetState(module))->criterion_type);
    Py_CLEAR(((State *)PyModule_GetState(module))->sets_type);
    return 0;
}

static void free_state(void *module) { clear_state(module); }

static PyModuleDef_Slot slots[] = {{Py_mod_exec, fill}, {0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, .m_name = "core", .m_size = sizeof(State), .m_slots = slots,
    .m_methods = methods, .m_traverse = visit_state, .m_clear = clear_state, .m_free = free_state,
};

PyMODINIT_FUNC PyInit_core(void) { return PyModuleDef_Init(&definition); }
