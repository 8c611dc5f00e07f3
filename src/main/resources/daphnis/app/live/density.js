// The surface density around each sphere: mass per area of the x-y plane, smoothed over some spheres.

const SPHERES_A_CELL = 2; // as many as give a sum of masses its scatter
const MOST_CELLS = 4e6;
const REACH = 3; // cells: a sphere's share, a smoothing and the reading of a place take one each

/** A column of a state by name; that of densities is computed when it is first asked for. */
export function columnOf(state, name) {
    if (name === "density") state.density ??= densityOf(state);
    return state[name];
}

/**
 * Spheres are shared out among the four cells around them, cells are smoothed with 1-2-1 along both axes, and the
 * density at a sphere is between those of the four cells around it: a kernel with a deviation of 0.91 cells. What is
 * near a face that repeats is there beyond the other face too, where that has slid to; at other faces nothing is lost.
 * Bodies are left out, and a sphere counts for itself too. Takes a time in proportion to the number of spheres.
 */
export function densityOf(state) {
    const { head, mass } = state;
    const found = new Float32Array(head.count);
    const grid = gridOf(state);
    if (!grid) return found;
    const [a, b] = grid.axes;
    for (let k = head.bodies; k < head.count; k++) add(grid, state[a.name][k], state[b.name][k], mass[k]);
    for (let j = 0; j < b.count; j++) smooth(grid.cells, j, b.count, a.count);
    for (let i = 0; i < a.count; i++) smooth(grid.cells, i * b.count, 1, b.count);
    const scale = head.every / (a.cell * b.cell);
    for (let k = head.bodies; k < head.count; k++) found[k] = scale * read(grid, state[a.name][k], state[b.name][k]);
    return found;
}

/** Cells over what is seen of the plane, with some beyond faces that repeat; null of nothing. */
function gridOf({ head, mass }) {
    let [sum, squares] = [0, 0];
    for (let k = head.bodies; k < head.count; k++) {
        sum += mass[k];
        squares += mass[k] ** 2;
    }
    if (!(sum > 0)) return null;
    const lengths = head.halves.map((half) => 2 * half);
    const wanted = Math.min(MOST_CELLS, Math.max(1, sum ** 2 / squares / SPHERES_A_CELL));
    const edge = Math.sqrt((lengths[0] * lengths[1]) / wanted);
    if (!(edge > 0)) return null;
    const normal = head.shear ? head.shear.normal : 0;
    const axes = [normal, 1 - normal].map((k) => {
        const inside = Math.max(1, Math.round(lengths[k] / edge));
        const margin = head.repeats[k] ? REACH : 0;
        const cell = lengths[k] / inside;
        return { name: "xy"[k], length: lengths[k], repeats: head.repeats[k], cell, margin, count: inside + 2 * margin };
    });
    return { axes, slid: head.shear ? head.shear.offset : 0, cells: new Float32Array(axes[0].count * axes[1].count) };
}

/** Adds a sphere and its images within the grid. */
function add(grid, x, y, mass) {
    const [a, b] = grid.axes;
    images(a, x, (u, boxes) => images(b, y + boxes * grid.slid, (v) => share(grid, u, v, mass)));
}

/** Tells of each image of a place along an axis how many cells it is from the first one of the grid. */
function images(axis, place, told) {
    const first = place / axis.cell + (axis.count - 1) / 2;
    if (!axis.repeats) {
        told(first, 0);
        return;
    }
    const box = axis.length / axis.cell;
    for (let m = Math.ceil((-1 - first) / box); first + m * box < axis.count; m++) told(first + m * box, m);
}

function share(grid, u, v, mass) {
    const [a, b] = grid.axes;
    const [i, j] = [Math.floor(u), Math.floor(v)];
    const [x, y] = [u - i, v - j];
    put(grid, index(a, i), index(b, j), mass * (1 - x) * (1 - y));
    put(grid, index(a, i + 1), index(b, j), mass * x * (1 - y));
    put(grid, index(a, i), index(b, j + 1), mass * (1 - x) * y);
    put(grid, index(a, i + 1), index(b, j + 1), mass * x * y);
}

function put(grid, i, j, part) {
    if (i >= 0 && j >= 0) grid.cells[i * grid.axes[1].count + j] += part;
}

/** The number of a cell along an axis: beyond the last one it is the last, or none where others are images. */
function index(axis, k) {
    if (k >= 0 && k < axis.count) return k;
    return axis.repeats ? -1 : within(axis, k);
}

function within(axis, k) {
    return Math.min(Math.max(k, 0), axis.count - 1);
}

/** Spreads what cells in a line have over their neighbours, one part in four each way. */
function smooth(cells, first, stride, count) {
    let before = cells[first];
    for (let n = 0; n < count; n++) {
        const k = first + n * stride;
        const own = cells[k];
        const after = n + 1 < count ? cells[k + stride] : own;
        cells[k] = (before + 2 * own + after) / 4;
        before = own;
    }
}

/** The mass of a cell at a place, between those of the four around it. */
function read({ axes: [a, b], cells }, x, y) {
    const u = x / a.cell + (a.count - 1) / 2;
    const v = y / b.cell + (b.count - 1) / 2;
    const [i, j] = [Math.floor(u), Math.floor(v)];
    const [one, other] = [within(a, i) * b.count, within(a, i + 1) * b.count];
    const [low, high] = [within(b, j), within(b, j + 1)];
    const [s, t] = [u - i, v - j];
    return (1 - s) * ((1 - t) * cells[one + low] + t * cells[one + high]) +
        s * ((1 - t) * cells[other + low] + t * cells[other + high]);
}
