// Where the eye is: on a sphere around a target; z points up. Lengths are those of the run times scale, so that what
// there is to see is about 1 long. At an azimuth of 0 x is to the right; at an elevation of 90 degrees y is up then.

const FIELD = (30 * Math.PI) / 180; // of view, along the shorter side of the picture
const RIGHT_ANGLE = Math.PI / 2;

export class Camera {
    constructor() {
        this.extent = [1, 1, 1];
        this.scale = 1;
        this.isFlat = false;
        this.facing = 0;
        this.aspect = 1;
        this.reset();
    }

    /** Sees a box of these half edges around the origin; discs are always seen from above. */
    fit(halves, isFlat) {
        this.scale = 1 / (Math.hypot(...halves) || 1);
        this.extent = halves.map((half) => half * this.scale);
        this.isFlat = isFlat;
        // The azimuth from which the broad side of a box is seen: what is thin along x, as a drum, is seen along x.
        this.facing = halves[0] < halves[1] / 2 ? RIGHT_ANGLE : 0;
        this.reset();
    }

    reset() {
        this.azimuth = this.facing + (this.facing > 0 ? -0.35 : 0.35);
        this.elevation = 0.6;
        this.target = [0, 0, 0];
        this.zoom = 1;
        if (this.isFlat) this.fromAbove();
    }

    fromAbove() {
        this.azimuth = this.facing;
        this.elevation = RIGHT_ANGLE;
    }

    fromSide() {
        if (this.isFlat) return;
        this.azimuth = this.facing;
        this.elevation = 0;
    }

    rotate(right, up) {
        if (this.isFlat) return;
        this.azimuth -= right;
        this.elevation = Math.min(RIGHT_ANGLE, Math.max(-RIGHT_ANGLE, this.elevation + up));
    }

    /** Comes nearer by a factor. */
    approach(factor) {
        this.zoom = Math.min(1e4, Math.max(0.2, this.zoom * factor));
    }

    /** Moves what is seen by parts of the picture's height. */
    move(right, up) {
        const { x, y } = this.directions();
        const height = 2 * this.distance() * Math.tan(this.halfHeight());
        for (let k = 0; k < 3; k++) this.target[k] -= (x[k] * right + y[k] * up) * height;
    }

    /** Unit vectors: x to the right of the picture, y up in it, z from the target to the eye. */
    directions() {
        const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
        const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
        return { x: [ca, sa, 0], y: [-sa * se, ca * se, ce], z: [sa * ce, -ca * ce, se] };
    }

    halfHeight() {
        return this.aspect >= 1 ? FIELD / 2 : Math.atan(Math.tan(FIELD / 2) / this.aspect);
    }

    /** From the eye to the target: all corners of the box are in the picture at a zoom of 1. */
    distance() {
        const d = this.directions();
        const tangent = Math.tan(this.halfHeight());
        let most = 0;
        for (let corner = 0; corner < 8; corner++) {
            const p = this.extent.map((half, k) => (corner & (1 << k) ? half : -half));
            const [x, y, z] = [dot(p, d.x), dot(p, d.y), dot(p, d.z)];
            most = Math.max(most, z + Math.abs(x) / (tangent * this.aspect), z + Math.abs(y) / tangent);
        }
        return (1.08 * most) / this.zoom;
    }

    /** Matrices by columns, as WebGL wants them; near and far enclose the box, wherever the target is. */
    matrices() {
        const d = this.directions();
        const distance = this.distance();
        const eye = this.target.map((t, k) => t + d.z[k] * distance);
        const view = new Float32Array([
            d.x[0], d.y[0], d.z[0], 0, d.x[1], d.y[1], d.z[1], 0, d.x[2], d.y[2], d.z[2], 0,
            -dot(eye, d.x), -dot(eye, d.y), -dot(eye, d.z), 1,
        ]);
        const reach = Math.hypot(...this.extent);
        const far = Math.hypot(...eye) + 1.5 * reach;
        const near = Math.max(far * 2e-5, dot(eye, d.z) - 1.5 * reach);
        const f = 1 / Math.tan(this.halfHeight());
        const projection = new Float32Array([
            f / this.aspect, 0, 0, 0, 0, f, 0, 0,
            0, 0, (far + near) / (near - far), -1, 0, 0, (2 * far * near) / (near - far), 0,
        ]);
        return { view, projection, focus: f, scale: this.scale };
    }
}

function dot(a, b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
