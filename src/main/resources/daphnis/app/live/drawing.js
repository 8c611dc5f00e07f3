// Draws a state into a canvas with WebGL 2.

import { columnOf } from "./density.js";
import * as shaders from "./shaders.js";

const PLACES = ["x", "y", "z", "radius"]; // attributes 0 to 3; 4 is the number that the colour stands for
const VALUE = 4;
const FEW_SPHERES = 5000; // so many are drawn as squares, whatever their size
const LARGEST_DOT = 20; // radius in pixels

export class Drawing {
    /** Throws an Error where there is no WebGL 2. */
    constructor(canvas) {
        this.canvas = canvas;
        // Software counts: better a slow picture in space than a fast one from above.
        this.gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
        if (!this.gl) throw new Error("no WebGL 2");
        this.start();
    }

    /** Also after the device was lost, with everything that was on it. */
    start() {
        const gl = this.gl;
        this.spheres = program(gl, shaders.SPHERE_VERTEX, shaders.SPHERE_FRAGMENT);
        this.dots = program(gl, shaders.DOT_VERTEX, shaders.DOT_FRAGMENT);
        this.points = program(gl, shaders.POINT_VERTEX, shaders.POINT_FRAGMENT);
        this.lines = program(gl, shaders.LINE_VERTEX, shaders.LINE_FRAGMENT);
        this.columns = {};
        this.array = gl.createVertexArray();
        this.edgeArray = gl.createVertexArray();
        this.edges = gl.createBuffer();
        this.edgeCount = 0;
        gl.enable(gl.DEPTH_TEST);
    }

    /** Copies a state to the device; the one before is given up. */
    load(state) {
        const gl = this.gl;
        for (const buffer of Object.values(this.columns)) gl.deleteBuffer(buffer);
        this.columns = {};
        this.state = state;
        this.count = state.head.count;
        this.bodies = state.head.bodies;
        this.largest = largestOf(state);
        this.isFlat = state.head.dimensions === 2;
        const { lines } = state.head;
        this.edgeCount = lines.length / 3;
        gl.bindVertexArray(this.edgeArray);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.edges);
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(lines), gl.STATIC_DRAW);
        gl.enableVertexAttribArray(0);
        gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
        gl.bindVertexArray(null);
    }

    /** A column of the state on the device, to which it goes when it is first drawn. */
    copied(name) {
        const gl = this.gl;
        this.columns[name] = gl.createBuffer();
        gl.bindBuffer(gl.ARRAY_BUFFER, this.columns[name]);
        gl.bufferData(gl.ARRAY_BUFFER, columnOf(this.state, name), gl.STATIC_DRAW);
        return this.columns[name];
    }

    /** Bodies are always spheres, and are never made small. */
    draw(camera, paint, asPoints, theme) {
        const gl = this.gl;
        const { width, height } = this.canvas;
        camera.aspect = width / height;
        const seen = camera.matrices();
        gl.viewport(0, 0, width, height);
        gl.clearColor(...theme.space, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.useProgram(this.lines.program);
        gl.uniform1f(this.lines.uScale, seen.scale);
        gl.uniformMatrix4fv(this.lines.uView, false, seen.view);
        gl.uniformMatrix4fv(this.lines.uProjection, false, seen.projection);
        gl.uniform3fv(this.lines.uInk, theme.line);
        gl.bindVertexArray(this.edgeArray);
        gl.drawArrays(gl.LINES, 0, this.edgeCount);
        gl.bindVertexArray(this.array);
        const focus = (seen.focus * height) / 2;
        this.some(this.spheres, seen, focus, paint, theme, 0, this.bodies, true);
        const rest = this.count - this.bodies;
        // The largest of the particles, where the middle of the picture is.
        const pixels = (this.largest * seen.scale * focus) / camera.distance();
        const balls = rest > FEW_SPHERES && pixels < LARGEST_DOT ? this.dots : this.spheres;
        this.some(asPoints ? this.points : balls, seen, focus, paint, theme, this.bodies, rest, false);
        gl.bindVertexArray(null);
    }

    /** Calls told with the milliseconds until what was drawn last is there. */
    whenDone(told) {
        const gl = this.gl;
        const begun = performance.now();
        const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        gl.flush();
        const look = () => {
            if (fence && !gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
                setTimeout(look, 5);
                return;
            }
            gl.deleteSync(fence);
            told(performance.now() - begun);
        };
        setTimeout(look, 5);
    }

    some(of, seen, focus, paint, theme, from, count, isBody) {
        if (count === 0) return;
        const gl = this.gl;
        gl.useProgram(of.program);
        gl.uniform1f(of.uScale, seen.scale);
        gl.uniformMatrix4fv(of.uView, false, seen.view);
        gl.uniformMatrix4fv(of.uProjection, false, seen.projection);
        gl.uniform1f(of.uFocus, focus);
        gl.uniform1i(of.uIsFlat, this.isFlat ? 1 : 0);
        gl.uniform1i(of.uIsBody, isBody ? 1 : 0);
        gl.uniform2f(of.uPixels ?? null, this.canvas.width, this.canvas.height);
        gl.uniform3fv(of.uBody, theme.body);
        gl.uniform3fv(of.uMap, paint.map.flat());
        gl.uniform2f(of.uRange, paint.low, paint.high);
        gl.uniform1i(of.uKind, paint.kind);
        // A square has four corners of the same sphere; a point is one.
        const divisor = of === this.spheres ? 1 : 0;
        [...PLACES, paint.column].forEach((name, k) => {
            const isByte = name === "material";
            gl.bindBuffer(gl.ARRAY_BUFFER, this.columns[name] ?? this.copied(name));
            gl.enableVertexAttribArray(k);
            gl.vertexAttribPointer(k, 1, isByte ? gl.UNSIGNED_BYTE : gl.FLOAT, false, 0, from * (isByte ? 1 : 4));
            gl.vertexAttribDivisor(k, divisor);
        });
        if (divisor === 0) gl.drawArrays(gl.POINTS, 0, count);
        else gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
        gl.disableVertexAttribArray(VALUE);
    }
}

function largestOf(state) {
    let largest = 0;
    for (let k = state.head.bodies; k < state.head.count; k++) largest = Math.max(largest, state.radius[k]);
    return largest;
}

function program(gl, vertex, fragment) {
    const made = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        gl.attachShader(made, shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
            throw new Error(gl.getShaderInfoLog(shader));
        }
    }
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS) && !gl.isContextLost()) {
        throw new Error(gl.getProgramInfoLog(made));
    }
    const places = { program: made };
    const count = gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS) ?? 0;
    for (let k = 0; k < count; k++) {
        const name = gl.getActiveUniform(made, k).name.replace("[0]", "");
        places[name] = gl.getUniformLocation(made, name);
    }
    return places;
}
