/* Searches over boxes and over spans as Python objects. Checked are widths, finite numbers, forces, counts
 * and who uses a search; the objects keep the arrays and the sets that they were given. */
#include <string.h>

#include "pool_object.h"
#include "sets_object.h"
#include "state.h"

typedef struct {
    PyObject_HEAD
    union {
        Pool pool; /* with which both of these begin */
        BoxSearch boxes;
        SpanSearch spans;
    };
    Py_buffer pieces;
    PyObject *owner;  /* of the sets */
    const Sets *sets;
    int is_busy;
} PoolObject;

/* -- what both have ------------------------------------------------------------------------------- */

static void free_object(PyObject *object) {
    PoolObject *self = (PoolObject *)object;
    PyTypeObject *type = Py_TYPE(object);
    if (self->pieces.obj)
        PyBuffer_Release(&self->pieces);
    Py_XDECREF(self->owner);
    freefunc release = (freefunc)PyType_GetSlot(type, Py_tp_free);
    release(object);
    Py_DECREF(type);
}

/* Make an object that keeps sets, and pieces in rows of `width`, one at least. */
static PoolObject *make_object(PyTypeObject *type, PyObject *owner, PyObject *pieces, int width) {
    const State *state = PyType_GetModuleState(type);
    const Sets *sets = sets_of(state->sets_type, owner);
    if (!sets)
        return NULL;
    allocfunc make = (allocfunc)PyType_GetSlot(type, Py_tp_alloc);
    PoolObject *self = (PoolObject *)make(type, 0);
    if (!self)
        return NULL;
    self->owner = Py_NewRef(owner);
    self->sets = sets;
    if (get_doubles(pieces, &self->pieces, width) == 0) {
        if (self->pieces.len > 0)
            return self;
        PyErr_SetString(PyExc_ValueError, "there are no pieces");
    }
    Py_DECREF(self);
    return NULL;
}

/* Tell whether there are no arguments by keyword; if there are, set an exception. */
static int has_no_names(PyObject *kwargs, const char *name) {
    if (!kwargs || PyDict_Size(kwargs) == 0)
        return 1;
    PyErr_Format(PyExc_TypeError, "%s takes no keyword arguments", name);
    return 0;
}

/* Take a search into use: a signal's handler, or another thread, may call while it runs. Returns NULL
 * with an exception if it is. */
static PoolObject *take(PyObject *object) {
    PoolObject *self = (PoolObject *)object;
    if (self->is_busy) {
        PyErr_SetString(PyExc_RuntimeError, "the search is in use");
        return NULL;
    }
    self->is_busy = 1;
    return self;
}

/* Read (gap, chosen, asks), and take a search of so many pieces into use. */
static PoolObject *take_to_solve(PyObject *object, PyObject *args, int many, double *gap,
                                 const char **chosen, int *asks) {
    Py_ssize_t size = many;
    *chosen = NULL;
    *asks = ASKS;
    if (!PyArg_ParseTuple(args, "dz#|i:solve", gap, chosen, &size, asks))
        return NULL;
    if (*chosen && size != many) {
        PyErr_Format(PyExc_ValueError, "there are %d pieces", many);
        return NULL;
    }
    return take(object);
}

static PyObject *base_get(PyObject *object, void *ignored) {
    const Pool *pool = &((PoolObject *)object)->pool;
    (void)ignored;
    return Py_BuildValue("d(ddd)", pool->quality, pool->weakest[0], pool->weakest[1],
                         pool->weakest[2]);
}

static PyObject *size_get(PyObject *object, void *ignored) {
    (void)ignored;
    return PyFloat_FromDouble(((PoolObject *)object)->pool.size);
}

static PyObject *left_get(PyObject *object, void *ignored) {
    (void)ignored;
    return PyFloat_FromDouble(((PoolObject *)object)->pool.work.left);
}

static PyGetSetDef getset[] = {
    {"base", base_get, NULL, NULL, NULL},
    {"size", size_get, NULL, NULL, NULL},
    {"left", left_get, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};

/* -- boxes ---------------------------------------------------------------------------------------- */

static void boxes_dealloc(PyObject *object) {
    boxes_end(&((PoolObject *)object)->boxes);
    free_object(object);
}

static PyObject *boxes_new(PyTypeObject *type, PyObject *args, PyObject *kwargs) {
    PyObject *sets, *pieces;
    double limit, reverse, units = WORK;
    if (!has_no_names(kwargs, "Boxes")
        || !PyArg_ParseTuple(args, "OOdd|d:Boxes", &sets, &pieces, &limit, &reverse, &units))
        return NULL;
    if (!(limit > 0.0 && limit < INFINITY && reverse >= 0.0 && reverse < INFINITY)) {
        PyErr_SetString(PyExc_ValueError, "a positive limit and a reverse limit are wanted");
        return NULL;
    }
    PoolObject *self = make_object(type, sets, pieces, PIECE);
    if (!self)
        return NULL;
    leave(1);
    Status status = boxes_begin(&self->boxes, self->sets, self->pieces.buf,
                                rows_of(&self->pieces, PIECE), limit, reverse, units, interrupted);
    come_back();
    if (!is_raised(status))
        return (PyObject *)self;
    Py_DECREF(self);
    return NULL;
}

static void write_box(const Box *box, double *row) {
    double head[] = {box->piece, box->from, box->to, box->lo, box->hi, box->bound};
    memcpy(row, head, sizeof head);
    memset(row + 6, 0, TERM_ROW * CORNERS * sizeof *row);
    for (int k = 0; k < box->terms; k++) {
        double *at = row + 6 + TERM_ROW * k;
        at[0] = box->term[k].kind;
        memcpy(at + 1, box->term[k].vector, sizeof box->term[k].vector);
        at[4] = box->term[k].weight;
        for (int l = 0; l < LOST; l++)
            at[5 + l] = box->term[k].lost[l];
    }
}

/* solve(gap, chosen, asks) -> (solved, best, boxes) */
static PyObject *boxes_solve_method(PyObject *object, PyObject *args) {
    BoxSearch *s = &((PoolObject *)object)->boxes;
    const char *chosen;
    int asks;
    double gap;
    Place best;
    PoolObject *self = take_to_solve(object, args, s->many, &gap, &chosen, &asks);
    if (!self)
        return NULL;
    leave(1);
    Status status = boxes_solve(s, chosen, gap, asks, &best);
    come_back();
    self->is_busy = 0;
    if (is_raised(status))
        return NULL;
    PyObject *boxes = PyBytes_FromStringAndSize(NULL, BOX_ROW * s->boxes * (Py_ssize_t)sizeof(double));
    if (!boxes)
        return NULL;
    double *row = (double *)PyBytes_AsString(boxes);
    for (int k = 0; k < s->boxes; k++)
        write_box(s->box + k, row + (Py_ssize_t)BOX_ROW * k);
    return Py_BuildValue("(O(didd)N)", status == SOLVED ? Py_True : Py_False, best.quality,
                         best.piece, best.share, best.direction, boxes);
}

static Status find_quality(void *search, const double *robot, double *found) {
    Status status = boxes_quality(search, robot, robot[2], EXACT, found, found + 1);
    if (status == OUT_OF_BUDGET)
        *found = 0.0;
    return status;
}

/* qualities_at(robots) -> bytes: the quality and its normal with each, (x, y, direction) */
static PyObject *boxes_qualities_method(PyObject *object, PyObject *robots) {
    PoolObject *self = take(object);
    if (!self)
        return NULL;
    PyObject *result = each_row(robots, 3, 4, 1, find_quality, &self->boxes);
    self->is_busy = 0;
    return result;
}

/* normals() -> bytes: those met */
static PyObject *boxes_normals_method(PyObject *object, PyObject *ignored) {
    PoolObject *self = take(object);
    (void)ignored;
    if (!self)
        return NULL;
    const Pool *pool = &self->pool;
    PyObject *result = PyBytes_FromStringAndSize(NULL, 3 * pool->count * (Py_ssize_t)sizeof(double));
    double *out = result ? (double *)PyBytes_AsString(result) : NULL;
    for (int k = 0; result && k < pool->count; k++)
        memcpy(out + 3 * k, pool->row[k].normal, sizeof pool->row[k].normal);
    self->is_busy = 0;
    return result;
}

static PyMethodDef boxes_methods[] = {
    {"solve", boxes_solve_method, METH_VARARGS, NULL},
    {"qualities_at", boxes_qualities_method, METH_O, NULL},
    {"normals", boxes_normals_method, METH_NOARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static PyType_Slot boxes_slots[] = {
    {Py_tp_dealloc, boxes_dealloc}, {Py_tp_new, boxes_new}, {Py_tp_methods, boxes_methods},
    {Py_tp_getset, getset},         {0, NULL},
};

static PyType_Spec boxes_spec = {
    .name = "swarmgrasp.kernels.core.Boxes",
    .basicsize = sizeof(PoolObject),
    .flags = Py_TPFLAGS_DEFAULT,
    .slots = boxes_slots,
};

PyObject *make_boxes_type(PyObject *module) {
    return PyType_FromModuleAndSpec(module, &boxes_spec, NULL);
}

/* -- spans ---------------------------------------------------------------------------------------- */

static void spans_dealloc(PyObject *object) {
    spans_end(&((PoolObject *)object)->spans);
    free_object(object);
}

/* Begin with the elements of each piece, if there are so many. */
static int begin_spans(PoolObject *self, const Py_buffer *elements, const Py_buffer *counts,
                       double units) {
    int many = rows_of(&self->pieces, 4);
    const double *count = counts->buf;
    double all = 0.0;
    for (int k = 0; k < many && k < rows_of(counts, 1); k++)
        all += count[k] >= 1.0 && count[k] == (double)(int)count[k] ? count[k] : NAN;
    if (rows_of(counts, 1) != many || all != rows_of(elements, ELEMENT)) {
        PyErr_SetString(PyExc_ValueError, "elements for each piece are wanted");
        return 0;
    }
    leave(1);
    Status status = spans_begin(&self->spans, self->sets, self->pieces.buf, many,
                                elements->buf, count, units, interrupted);
    come_back();
    return !is_raised(status);
}

static PyObject *spans_new(PyTypeObject *type, PyObject *args, PyObject *kwargs) {
    PyObject *sets, *ends, *rows, *counts;
    double units = WORK;
    if (!has_no_names(kwargs, "Spans")
        || !PyArg_ParseTuple(args, "OOOO|d:Spans", &sets, &ends, &rows, &counts, &units))
        return NULL;
    PoolObject *self = make_object(type, sets, ends, 4);
    Py_buffer row = {0}, count = {0};
    int is_begun = self && get_doubles(rows, &row, ELEMENT) == 0
                   && get_doubles(counts, &count, 1) == 0 && begin_spans(self, &row, &count, units);
    if (row.obj)
        PyBuffer_Release(&row);
    if (count.obj)
        PyBuffer_Release(&count);
    if (is_begun)
        return (PyObject *)self;
    Py_XDECREF((PyObject *)self);
    return NULL;
}

static void write_span(const Span *span, double *row) {
    double head[] = {span->piece, span->from, span->to, span->bound, span->kind};
    memcpy(row, head, sizeof head);
    memset(row + 5, 0, 8 * sizeof *row);
    for (int k = 0; k < span->terms; k++) {
        memcpy(row + 5 + 4 * k, span->normal[k], sizeof span->normal[k]);
        row[8 + 4 * k] = span->weight[k];
    }
}

/* solve(gap, chosen, asks) -> (solved, best, spans) */
static PyObject *spans_solve_method(PyObject *object, PyObject *args) {
    SpanSearch *s = &((PoolObject *)object)->spans;
    const char *chosen;
    int asks;
    double gap;
    Stand best;
    PoolObject *self = take_to_solve(object, args, s->many, &gap, &chosen, &asks);
    if (!self)
        return NULL;
    leave(1);
    Status status = spans_solve(s, chosen, gap, asks, &best);
    come_back();
    self->is_busy = 0;
    if (is_raised(status))
        return NULL;
    PyObject *spans = PyBytes_FromStringAndSize(NULL, SPAN_ROW * s->spans * (Py_ssize_t)sizeof(double));
    if (!spans)
        return NULL;
    double *row = (double *)PyBytes_AsString(spans);
    for (int k = 0; k < s->spans; k++)
        write_span(s->span + k, row + (Py_ssize_t)SPAN_ROW * k);
    return Py_BuildValue("(O(did)N)", status == SOLVED ? Py_True : Py_False, best.quality,
                         best.piece, best.share, spans);
}

/* quality_at(piece, share, enough) -> (quality, normal) */
static PyObject *spans_quality_method(PyObject *object, PyObject *args) {
    int piece;
    double share, enough = 0.0, quality, n[3];
    if (!PyArg_ParseTuple(args, "id|d:quality_at", &piece, &share, &enough))
        return NULL;
    SpanSearch *s = &((PoolObject *)object)->spans;
    if (piece < 0 || piece >= s->many || !(share >= 0.0 && share <= 1.0)) {
        PyErr_SetString(PyExc_ValueError, "a piece and a share of the way are wanted");
        return NULL;
    }
    PoolObject *self = take(object);
    if (!self)
        return NULL;
    leave(1);
    Status status = spans_quality(s, piece, share, enough, &quality, n);
    come_back();
    self->is_busy = 0;
    return is_raised(status) ? NULL : Py_BuildValue("d(ddd)", quality, n[0], n[1], n[2]);
}

/* Write what newcomers add along normals, if they stand on pieces; if not, set an exception. */
static int find_gains(const SpanSearch *s, const Py_buffer *stands, const Py_buffer *normals,
                      double *gains) {
    int many = rows_of(normals, 3), count = rows_of(stands, 2);
    const double *stand = stands->buf;
    for (int k = 0; k < count; k++, stand += 2, gains += many) {
        if (!(stand[0] >= 0.0 && stand[0] < s->many && stand[1] >= 0.0 && stand[1] <= 1.0)) {
            PyErr_SetString(PyExc_ValueError, "pieces and shares of the way are wanted");
            return 0;
        }
        spans_gains(s, (int)stand[0], stand[1], normals->buf, many, gains);
    }
    return 1;
}

/* gains(stands, normals) -> bytes: what newcomers add along normals */
static PyObject *spans_gains_method(PyObject *object, PyObject *args) {
    PyObject *array[2], *result = NULL;
    Py_buffer stands = {0}, normals = {0};
    if (!PyArg_ParseTuple(args, "OO:gains", array, array + 1))
        return NULL;
    if (get_doubles(array[0], &stands, 2) == 0 && get_doubles(array[1], &normals, 3) == 0) {
        Py_ssize_t size = (Py_ssize_t)rows_of(&stands, 2) * rows_of(&normals, 3);
        result = PyBytes_FromStringAndSize(NULL, size * (Py_ssize_t)sizeof(double));
        if (result
            && !find_gains(&((PoolObject *)object)->spans, &stands, &normals,
                           (double *)PyBytes_AsString(result)))
            Py_CLEAR(result);
    }
    if (stands.obj)
        PyBuffer_Release(&stands);
    if (normals.obj)
        PyBuffer_Release(&normals);
    return result;
}

static PyMethodDef spans_methods[] = {
    {"solve", spans_solve_method, METH_VARARGS, NULL},
    {"quality_at", spans_quality_method, METH_VARARGS, NULL},
    {"gains", spans_gains_method, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static PyType_Slot spans_slots[] = {
    {Py_tp_dealloc, spans_dealloc}, {Py_tp_new, spans_new}, {Py_tp_methods, spans_methods},
    {Py_tp_getset, getset},         {0, NULL},
};

static PyType_Spec spans_spec = {
    .name = "swarmgrasp.kernels.core.Spans",
    .basicsize = sizeof(PoolObject),
    .flags = Py_TPFLAGS_DEFAULT,
    .slots = spans_slots,
};

PyObject *make_spans_type(PyObject *module) {
    return PyType_FromModuleAndSpec(module, &spans_spec, NULL);
}
