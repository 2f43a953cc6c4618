/* Criteria as Python objects. Checked are widths, finite numbers, and that losses are no more than
 * robots; the arrays are kept for as long as the object is. */
#include "criterion_object.h"

typedef struct {
    PyObject_HEAD
    Criterion criterion;
    Py_buffer points, rows, task;
} CriterionObject;

static void criterion_dealloc(PyObject *object) {
    CriterionObject *self = (CriterionObject *)object;
    PyTypeObject *type = Py_TYPE(object);
    Py_buffer *views[] = {&self->points, &self->rows, &self->task};
    criterion_end(&self->criterion);
    for (int k = 0; k < 3; k++)
        if (views[k]->obj)
            PyBuffer_Release(views[k]);
    freefunc release = (freefunc)PyType_GetSlot(type, Py_tp_free);
    release(object);
    Py_DECREF(type);
}

static PyObject *criterion_new(PyTypeObject *type, PyObject *args, PyObject *kwargs) {
    PyObject *points, *rows, *task;
    Criterion given = {0};
    double *s = given.scale, *w = given.load;
    if (kwargs && PyDict_Size(kwargs) > 0) {
        PyErr_SetString(PyExc_TypeError, "Criterion takes no keyword arguments");
        return NULL;
    }
    if (!PyArg_ParseTuple(args, "O(ddd)Oi(ddd)Op:Criterion", &points, s, s + 1, s + 2, &rows,
                          &given.losing, w, w + 1, w + 2, &task, &given.is_polytope)
        || !are_finite(s) || !are_finite(w))
        return NULL;
    if (given.losing < 0) {
        PyErr_SetString(PyExc_ValueError, "robots to lose should be 0 or more");
        return NULL;
    }
    allocfunc make = (allocfunc)PyType_GetSlot(type, Py_tp_alloc);
    CriterionObject *self = (CriterionObject *)make(type, 0);
    if (!self)
        return NULL;
    self->criterion = given;
    if (get_doubles(points, &self->points, 3) || get_doubles(rows, &self->rows, SPREAD_ROW)
        || get_doubles(task, &self->task, 3)) {
        Py_DECREF(self);
        return NULL;
    }
    Criterion *criterion = &self->criterion;
    criterion->point = self->points.buf;
    criterion->points = rows_of(&self->points, 3);
    criterion->rows = self->rows.buf;
    criterion->task = self->task.buf;
    criterion->tasks = rows_of(&self->task, 3);
    Status status = criterion_begin(criterion, rows_of(&self->rows, SPREAD_ROW));
    /* more than all are as good as all */
    int robots = criterion->points + criterion->spread;
    if (criterion->losing > robots + 1)
        criterion->losing = robots + 1;
    if (!is_raised(status))
        return (PyObject *)self;
    Py_DECREF(self);
    return NULL;
}

/* least(gap, below, units) -> (value, normal, whether no direction has less, units left) */
static PyObject *criterion_least(PyObject *object, PyObject *args) {
    const Criterion *criterion = &((CriterionObject *)object)->criterion;
    double gap, below, units = WORK, value, n[3];
    if (!PyArg_ParseTuple(args, "dd|d:least", &gap, &below, &units))
        return NULL;
    Work work = work_of(units, interrupted);
    leave(1);
    Status status = criterion_search(criterion, NULL, gap, below, UNASKED * criterion->weight,
                                     &work, &value, n);
    come_back();
    if (is_raised(status))
        return NULL;
    return Py_BuildValue("d(ddd)Od", value, n[0], n[1], n[2],
                         status == SOLVED ? Py_True : Py_False, work.left);
}

static Status find_height(void *criterion, const double *normal, double *found) {
    found[2] = criterion_extent(criterion, normal);
    return criterion_height(criterion, normal, NULL, found, found + 1);
}

/* heights(normals) -> bytes: H, the H before the last loss, and D at each */
static PyObject *criterion_heights(PyObject *object, PyObject *normals) {
    return each_row(normals, 3, 3, 0, find_height, &((CriterionObject *)object)->criterion);
}

static PyMethodDef methods[] = {
    {"least", criterion_least, METH_VARARGS, NULL},
    {"heights", criterion_heights, METH_O, NULL},
    {NULL, NULL, 0, NULL},
};

static PyType_Slot type_slots[] = {
    {Py_tp_dealloc, criterion_dealloc},
    {Py_tp_new, criterion_new},
    {Py_tp_methods, methods},
    {0, NULL},
};

static PyType_Spec type_spec = {
    .name = "swarmgrasp.kernels.core.Criterion",
    .basicsize = sizeof(CriterionObject),
    .flags = Py_TPFLAGS_DEFAULT,
    .slots = type_slots,
};

PyObject *make_criterion_type(PyObject *module) {
    return PyType_FromModuleAndSpec(module, &type_spec, NULL);
}

const Criterion *criterion_of(PyObject *type, PyObject *object) {
    if (Py_TYPE(object) == (PyTypeObject *)type)
        return &((CriterionObject *)object)->criterion;
    PyErr_SetString(PyExc_TypeError, "a Criterion or None is wanted");
    return NULL;
}
