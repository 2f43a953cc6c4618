/* Sets of forces as Python objects. Checked are widths, finite numbers, that elements, machines and
 * places are those of the robots given, and that losses are no less than none. */
#include <string.h>

#include "sets_object.h"

typedef struct {
    PyObject_HEAD
    Sets sets;
    Py_buffer task;
} SetsObject;

enum { ARMS, ELEMENTS, COUNTS, MACHINES, PARTS, POSES, FAILURES, TASK, ARRAYS };

static const int width[ARRAYS] = {2, ELEMENT, 1, 1, PART, POSE, 1, 3};

static void sets_dealloc(PyObject *object) {
    SetsObject *self = (SetsObject *)object;
    PyTypeObject *type = Py_TYPE(object);
    sets_end(&self->sets);
    if (self->task.obj)
        PyBuffer_Release(&self->task);
    freefunc release = (freefunc)PyType_GetSlot(type, Py_tp_free);
    release(object);
    Py_DECREF(type);
}

/* Tell whether rows begin with numbers of robots, of `count`, in order; if not, set an exception. */
static int are_sorted(const double *row, int rows, int wide, int count) {
    double last = 0.0;
    for (int r = 0; r < rows; r++, row += wide) {
        if (!(row[0] >= last && row[0] < count && row[0] == (double)(int)row[0]))
            return is_raised(UNSORTED), 0;
        last = row[0];
    }
    return 1;
}

/* Tell whether the robots' arrays fit together; if not, set an exception. */
static int fit(const Robots *given, int rows) {
    double all = 0.0;
    const char *wrong = NULL;
    for (int i = 0; i < given->count; i++) {
        double own = given->elements[i], machine = given->machine[i];
        if (!(own >= 0.0 && own <= rows && own == (double)(int)own))
            wrong = "counts should be whole numbers of elements";
        else if (!(machine >= 0.0 && machine < given->count && machine == (double)(int)machine))
            wrong = "machines should be 0, 1, 2, ...";
        all += own;
    }
    if (!wrong && all != (double)rows)
        wrong = "counts should add up to the elements";
    for (int k = 0; k < given->poses && !wrong; k++)
        if (given->pose[(Py_ssize_t)POSE * k + 1] < 0.0)
            wrong = "limits should be 0 or more";
    if (wrong) {
        PyErr_SetString(PyExc_ValueError, wrong);
        return 0;
    }
    return are_sorted(given->part, given->parts, PART, given->count)
           && are_sorted(given->pose, given->poses, POSE, given->count);
}

static PyObject *sets_new(PyTypeObject *type, PyObject *args, PyObject *kwargs) {
    PyObject *array[ARRAYS];
    Py_buffer view[ARRAYS] = {{0}};
    Sets given = {0};
    double *s = given.scale, *w = given.load;
    if (kwargs && PyDict_Size(kwargs) > 0) {
        PyErr_SetString(PyExc_TypeError, "Sets takes no keyword arguments");
        return NULL;
    }
    if (!PyArg_ParseTuple(args, "OOOO(ddd)i(ddd)OpOOO:Sets", array + ARMS, array + ELEMENTS,
                          array + COUNTS, array + MACHINES, s, s + 1, s + 2, &given.losing, w, w + 1,
                          w + 2, array + TASK, &given.is_polytope, array + PARTS, array + POSES,
                          array + FAILURES)
        || !are_finite(s) || !are_finite(w))
        return NULL;
    if (given.losing < 0) {
        PyErr_SetString(PyExc_ValueError, "machines to lose should be 0 or more");
        return NULL;
    }
    SetsObject *self = NULL;
    int got = 0;
    while (got < ARRAYS && get_doubles(array[got], view + got, width[got]) == 0)
        got++;
    if (got < ARRAYS)
        goto done;
    Robots robots = {rows_of(view + ARMS, 2), view[ARMS].buf, view[ELEMENTS].buf, view[COUNTS].buf,
                     view[MACHINES].buf, rows_of(view + PARTS, PART), view[PARTS].buf,
                     rows_of(view + POSES, POSE), view[POSES].buf, 0, view[FAILURES].buf};
    int failing = rows_of(view + FAILURES, 1);
    robots.failures = robots.count ? failing / robots.count : 0;
    if (rows_of(view + COUNTS, 1) != robots.count || rows_of(view + MACHINES, 1) != robots.count
        || failing != robots.failures * robots.count) {
        PyErr_SetString(PyExc_ValueError, "a count, a machine and failures for each arm are wanted");
        goto done;
    }
    if (!fit(&robots, rows_of(view + ELEMENTS, ELEMENT)))
        goto done;
    allocfunc make = (allocfunc)PyType_GetSlot(type, Py_tp_alloc);
    self = (SetsObject *)make(type, 0);
    if (!self)
        goto done;
    self->sets = given;
    self->task = view[TASK];
    got = TASK; /* which the object releases */
    self->sets.task = self->task.buf;
    self->sets.tasks = rows_of(&self->task, 3);
    if (is_raised(sets_begin(&self->sets, &robots)))
        Py_CLEAR(self);
done:
    while (got-- > 0)
        PyBuffer_Release(view + got);
    return (PyObject *)self;
}

/* least(gap, below, units) -> (value, normal, bound, units left) */
static PyObject *sets_least(PyObject *object, PyObject *args) {
    const Sets *sets = &((SetsObject *)object)->sets;
    double gap, below, units = -1.0, enough = 0.0, value, bound, n[3];
    if (!PyArg_ParseTuple(args, "dd|dd:least", &gap, &below, &units, &enough))
        return NULL;
    Work work = work_of(units < 0.0 ? WORK + SETS_PER_ROBOT * sets->count : units, interrupted);
    leave(1);
    Status status = sets_search(sets, NULL, gap, below, enough, NULL, 0, &work, &value, &bound, n);
    come_back();
    if (is_raised(status))
        return NULL;
    return Py_BuildValue("d(ddd)dd", value, n[0], n[1], n[2], bound, work.left);
}

static Status find_height(void *sets, const double *normal, double *found) {
    found[2] = sets_extent(sets, normal);
    return sets_height(sets, normal, NULL, found, found + 1);
}

/* heights(normals) -> bytes: H, the H before the last loss, and D at each */
static PyObject *sets_heights(PyObject *object, PyObject *normals) {
    return each_row(normals, 3, 3, 0, find_height, &((SetsObject *)object)->sets);
}

static Status find_wrench(void *data, const double *normal, double *found) {
    const Sets *sets = data;
    double own[3];
    memcpy(found, sets->load, 3 * sizeof(double));
    for (int i = 0; i < sets->count; i++) {
        exert(sets->scale, sets->set + i, normal, own, NULL, NULL);
        for (int k = 0; k < 3; k++)
            found[k] += own[k];
    }
    return interrupted() ? INTERRUPTED : SOLVED;
}

/* wrenches(normals) -> bytes: the wrench of all robots and the load that is farthest along each */
static PyObject *sets_wrenches(PyObject *object, PyObject *normals) {
    return each_row(normals, 3, 3, 1, find_wrench, &((SetsObject *)object)->sets);
}

/* forces(normal) -> bytes: of each robot the worth of its best force, the force, and its arm */
static PyObject *sets_forces(PyObject *object, PyObject *args) {
    const Sets *sets = &((SetsObject *)object)->sets;
    double n[3];
    if (!PyArg_ParseTuple(args, "(ddd):forces", n, n + 1, n + 2) || !are_finite(n))
        return NULL;
    PyObject *result = PyBytes_FromStringAndSize(NULL, 5 * sets->count * (Py_ssize_t)sizeof(double));
    if (!result)
        return NULL;
    double *out = (double *)PyBytes_AsString(result);
    for (int i = 0; i < sets->count; i++, out += 5)
        out[0] = exert(sets->scale, sets->set + i, n, NULL, out + 1, out + 3);
    return result;
}

static PyMethodDef methods[] = {
    {"least", sets_least, METH_VARARGS, NULL},
    {"heights", sets_heights, METH_O, NULL},
    {"wrenches", sets_wrenches, METH_O, NULL},
    {"forces", sets_forces, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static PyObject *sets_weight_get(PyObject *object, void *ignored) {
    (void)ignored;
    return PyFloat_FromDouble(((SetsObject *)object)->sets.weight);
}

static PyGetSetDef getset[] = {
    {"weight", sets_weight_get, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};

static PyType_Slot type_slots[] = {
    {Py_tp_dealloc, sets_dealloc}, {Py_tp_new, sets_new}, {Py_tp_methods, methods},
    {Py_tp_getset, getset},        {0, NULL},
};

static PyType_Spec type_spec = {
    .name = "swarmgrasp.kernels.core.Sets",
    .basicsize = sizeof(SetsObject),
    .flags = Py_TPFLAGS_DEFAULT,
    .slots = type_slots,
};

PyObject *make_sets_type(PyObject *module) {
    return PyType_FromModuleAndSpec(module, &type_spec, NULL);
}

const Sets *sets_of(PyObject *type, PyObject *object) {
    if (Py_TYPE(object) == (PyTypeObject *)type)
        return &((SetsObject *)object)->sets;
    PyErr_SetString(PyExc_TypeError, "a Sets is wanted");
    return NULL;
}
