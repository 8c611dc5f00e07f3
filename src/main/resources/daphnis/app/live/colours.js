// What colours mean: quantities of a state, their ranges, the map and its bar.

import { columnOf } from "./density.js";

/** The map viridis of Smith and van der Walt (in the public domain) without its dark end, as in movies. */
const QUANTITY = ["#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725"];

/** Okabe and Ito's colours for kinds, told apart by colour-blind eyes. */
const KINDS = ["#0072b2", "#e69f00", "#009e73", "#d55e00", "#56b4e9", "#cc79a7", "#f0e442", "#8a93a0"];

const RARE = 1e-3; // the part of spheres at each end whose numbers a range leaves out
const MOST_LOOKED_AT = 20000;
const FAR_APART = 10; // sizes by logarithm from here on

/** Quantities of a state that can be shown, by name. */
export function quantitiesOf(state) {
    const list = ["speed", "size"];
    if (state.head.dimensions === 3) list.push("height");
    list.push("density");
    // The first is what one sees at first: of several materials who is who.
    if (state.head.materials.length > 1) list.unshift("material");
    else if (state.head.materials.length > 0) list.push("material");
    return list;
}

/** How a quantity of a state is painted: its column, range, kind and colours. */
export function paintOf(state, quantity) {
    if (quantity === "material") return { column: "material", kind: 2, low: 0, high: 7, map: KINDS.map(rgb) };
    const column = { speed: "speed", size: "radius", height: "z", density: "density" }[quantity];
    const map = QUANTITY.map(rgb);
    if (quantity === "size") {
        const [low, high] = endsOf(state, column);
        return { column, kind: high / low >= FAR_APART ? 1 : 0, low, high, map };
    }
    const numbers = sampled(state, column);
    if (numbers.length === 0) return { column, kind: 0, low: 0, high: 0, map };
    const at = (part) => numbers[Math.floor(part * (numbers.length - 1))];
    return { column, kind: 0, low: quantity === "height" ? at(RARE) : 0, high: at(1 - RARE), map };
}

/** The least and the largest number of a column, without bodies; 0 of none. */
function endsOf(state, column) {
    const { bodies, count } = state.head;
    const all = state[column];
    let [low, high] = bodies < count ? [all[bodies], all[bodies]] : [0, 0];
    for (let k = bodies + 1; k < count; k++) {
        if (all[k] < low) low = all[k];
        else if (all[k] > high) high = all[k];
    }
    return [low, high];
}

/** Numbers of a column in order, without bodies; of many spheres an even part. */
function sampled(state, column) {
    const all = columnOf(state, column).subarray(state.head.bodies);
    const stride = Math.ceil(all.length / MOST_LOOKED_AT);
    if (stride <= 1) return all.slice().sort();
    const some = new Float32Array(Math.floor(all.length / stride));
    for (let k = 0; k < some.length; k++) some[k] = all[k * stride];
    return some.sort();
}

/** A colour "#rrggbb" as three numbers in 0..1. */
export function rgb(text) {
    const number = parseInt(text.slice(1), 16);
    return [(number >> 16) / 255, ((number >> 8) & 255) / 255, (number & 255) / 255];
}

/** What stands at the colour bar: the quantity with its unit. */
export function labelOf(state, quantity) {
    const units = state.head.units;
    const { speed, length, surfaceDensity } = units;
    const unit = { speed, size: length, height: length, density: surfaceDensity }[quantity];
    const name = {
        speed: state.head.flow ? "speed against the mean flow" : "speed",
        size: "radius", height: "height z", material: "material", density: "surface density",
    }[quantity];
    return unit ? `${name} [${unit}]` : name;
}

/** Numbers at even places of the bar, in words. */
export function ticksOf(paint, shift) {
    const parts = paint.low < paint.high ? [0, 0.25, 0.5, 0.75, 1] : [0.5];
    return parts.map((t) => {
        const value = paint.kind === 1 ? paint.low * (paint.high / paint.low) ** t
            : paint.low + t * (paint.high - paint.low);
        return short(value + shift);
    });
}

/** Three digits, by powers of ten where these are many. */
export function short(value) {
    if (value === 0) return "0";
    const size = Math.abs(value);
    if (size >= 1e5 || size < 1e-3) return value.toExponential(2).replace("e+", "e").replace("-", "\u2212");
    return String(Number(value.toPrecision(3))).replace("-", "\u2212");
}

/** Fills the elements of the bar. Names stay text, whatever is in them. */
export function showBar(part, state, quantity, paint) {
    const isKinds = paint.kind === 2;
    part("quantity").textContent = labelOf(state, quantity) + (paint.kind === 1 ? " (log scale)" : "");
    part("scale").hidden = isKinds;
    part("ticks").hidden = isKinds;
    part("materials").hidden = !isKinds;
    if (isKinds) {
        part("materials").replaceChildren(...state.head.materials.map((name, k) => {
            const item = document.createElement("li");
            const dot = document.createElement("span");
            dot.style.background = KINDS[k % KINDS.length];
            item.append(dot, name);
            return item;
        }));
        return;
    }
    part("ticks").replaceChildren(...ticksOf(paint, shiftOf(state, quantity)).map((text) => {
        const tick = document.createElement("span");
        tick.textContent = text;
        return tick;
    }));
}

/** What numbers of a column lack: heights are sent around the middle of what is seen. */
export function shiftOf(state, quantity) {
    return quantity === "height" ? state.head.origin[2] : 0;
}
