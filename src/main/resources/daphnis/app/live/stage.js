// What is seen of a state: the picture, its axes and its colour bar. Draws when something has changed, once a frame.

import { Camera } from "./camera.js";
import { labelOf, paintOf, quantitiesOf, rgb, shiftOf, showBar, ticksOf } from "./colours.js";
import { Drawing } from "./drawing.js";
import { listen } from "./gestures.js";

const MOST_SPHERES = 200000; // more are points
const SLOW = 100; // milliseconds for a frame
const FRAMES_TO_TELL = 3; // one after the other: the first one compiles, another may have been kept waiting
const NAMES = { speed: "speed", size: "size", height: "height z", density: "surface density", material: "material" };

export class Stage {
    /** Throws an Error where there is no WebGL 2. */
    constructor(part, actions) {
        this.part = part;
        this.drawing = new Drawing(part("view"));
        this.camera = new Camera();
        this.state = null;
        this.isSlow = false;
        this.slowFrames = 0;
        this.isTimed = false;
        this.isDue = false;
        const changed = () => this.redraw();
        listen(part("view"), this.camera, changed, actions);
        new ResizeObserver(changed).observe(part("frame"));
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
        part("colour").addEventListener("change", () => this.recolour());
        part("hold").addEventListener("change", () => this.recolour());
        part("shape").addEventListener("change", changed);
        const sights = { top: "fromAbove", side: "fromSide", reset: "reset" };
        for (const [id, sight] of Object.entries(sights)) {
            part(id).addEventListener("click", () => { this.camera[sight](); this.redraw(); });
        }
        part("view").addEventListener("webglcontextlost", (event) => event.preventDefault());
        part("view").addEventListener("webglcontextrestored", () => {
            this.drawing.start();
            if (this.state) this.drawing.load(this.state);
            this.redraw();
        });
    }

    show(state) {
        const before = this.state;
        this.state = state;
        const { head } = state;
        if (!before || before.head.dimensions !== head.dimensions) {
            this.camera.fit(head.halves, head.dimensions === 2);
            this.part("sights").hidden = head.dimensions === 2;
            this.part("turning").hidden = head.dimensions === 2;
        }
        this.drawing.load(state);
        this.offer(quantitiesOf(state));
        this.part("stage").hidden = false;
        this.part("when").textContent = head.time;
        this.part("about").textContent = head.about;
        const view = this.part("view");
        view.setAttribute("aria-label", `${head.about} at ${head.time}`);
        this.recolour();
    }

    offer(quantities) {
        const select = this.part("colour");
        if ([...select.options].map((option) => option.value).join() === quantities.join()) return;
        const chosen = select.value;
        select.replaceChildren(...quantities.map((quantity) => new Option(NAMES[quantity], quantity)));
        if (quantities.includes(chosen)) select.value = chosen;
    }

    recolour() {
        if (!this.state) return;
        const quantity = this.part("colour").value;
        const isHeld = this.part("hold").checked && this.quantity === quantity;
        if (!isHeld) this.paint = paintOf(this.state, quantity);
        this.quantity = quantity;
        showBar(this.part, this.state, quantity, this.paint);
        this.redraw();
    }

    redraw() {
        if (this.isDue || !this.state) return;
        this.isDue = true;
        requestAnimationFrame(() => this.frame());
    }

    frame() {
        this.isDue = false;
        this.fitCanvas();
        this.draw();
        if (this.asPoints() || this.isTimed) return;
        this.isTimed = true;
        this.drawing.whenDone((milliseconds) => {
            this.isTimed = false;
            this.slowFrames = milliseconds > SLOW ? this.slowFrames + 1 : 0;
            if (this.slowFrames < FRAMES_TO_TELL || this.isSlow) return;
            this.isSlow = true;
            this.redraw();
        });
    }

    asPoints() {
        const shape = this.part("shape").value;
        return shape === "points" || (shape === "auto" && (this.isSlow || this.state.head.count >= MOST_SPHERES));
    }

    draw() {
        const style = getComputedStyle(document.documentElement);
        const colour = (name) => rgb(six(style.getPropertyValue(name).trim()));
        const theme = { space: colour("--space"), line: colour("--line"), body: colour("--ink") };
        this.drawing.draw(this.camera, this.paint, this.asPoints(), theme);
        this.drawAxes(style.getPropertyValue("--ink"));
    }

    fitCanvas() {
        const view = this.part("view");
        const scale = Math.min(2, devicePixelRatio || 1);
        const width = Math.max(1, Math.round(view.clientWidth * scale));
        const height = Math.max(1, Math.round(view.clientHeight * scale));
        if (view.width !== width) view.width = width;
        if (view.height !== height) view.height = height;
    }

    /** The directions of x, y and z, at the lower left. */
    drawAxes(ink) {
        const canvas = this.part("axes");
        const size = 168;
        canvas.width = size;
        canvas.height = size;
        const pen = canvas.getContext("2d");
        const d = this.camera.directions();
        pen.font = "26px system-ui, sans-serif";
        pen.textAlign = "center";
        pen.textBaseline = "middle";
        pen.lineWidth = 3;
        pen.strokeStyle = ink;
        pen.fillStyle = ink;
        const names = this.state.head.dimensions === 2 ? "xy" : "xyz";
        [...names].forEach((name, k) => {
            const [right, up] = [d.x[k], d.y[k]];
            if (Math.hypot(right, up) < 0.08) return;
            pen.beginPath();
            pen.moveTo(size / 2, size / 2);
            pen.lineTo(size / 2 + 48 * right, size / 2 - 48 * up);
            pen.stroke();
            pen.fillText(name, size / 2 + 66 * right, size / 2 - 66 * up);
        });
    }

    /** What is seen with its time and its colour bar, as a PNG that the browser saves. */
    save(name) {
        if (!this.state) return;
        this.fitCanvas();
        this.draw();
        const view = this.part("view");
        const sheet = document.createElement("canvas");
        const unit = Math.max(11, Math.round(view.width / 60));
        sheet.width = view.width;
        sheet.height = view.height + 5 * unit;
        const pen = sheet.getContext("2d");
        const style = getComputedStyle(document.documentElement);
        pen.fillStyle = style.getPropertyValue("--page");
        pen.fillRect(0, 0, sheet.width, sheet.height);
        pen.drawImage(view, 0, 0);
        pen.drawImage(this.part("axes"), 0, view.height - 6 * unit, 6 * unit, 6 * unit);
        pen.font = `${unit}px system-ui, sans-serif`;
        pen.fillStyle = style.getPropertyValue("--ink");
        const base = view.height + 1.6 * unit;
        pen.fillText(`${name}   ${this.state.head.time}`, unit, base, sheet.width / 2 - 2 * unit);
        const [left, width] = [sheet.width / 2, sheet.width / 2 - unit];
        if (this.paint.kind === 2) {
            pen.fillText(this.state.head.materials.join(", "), left, base, width);
        } else {
            pen.fillText(labelOf(this.state, this.quantity), left, base, width);
            const ramp = pen.createLinearGradient(left, 0, left + width, 0);
            this.paint.map.forEach((c, k) => ramp.addColorStop(k / 7, `rgb(${c.map((v) => Math.round(255 * v))})`));
            const ink = pen.fillStyle;
            pen.fillStyle = ramp;
            pen.fillRect(left, base + 0.6 * unit, width, unit);
            pen.fillStyle = ink;
            const ticks = ticksOf(this.paint, shiftOf(this.state, this.quantity));
            ticks.forEach((tick, k) => {
                const part = ticks.length > 1 ? k / (ticks.length - 1) : 0.5;
                pen.textAlign = part === 0 ? "left" : part === 1 ? "right" : "center";
                pen.fillText(tick, left + part * width, base + 2.8 * unit);
            });
        }
        sheet.toBlob((blob) => {
            const link = document.createElement("a");
            link.href = URL.createObjectURL(blob);
            link.download = `${name.replace(/[^A-Za-z0-9._-]+/g, "-")}-${this.state.head.number}.png`;
            link.click();
            setTimeout(() => URL.revokeObjectURL(link.href), 10000);
        });
    }
}

/** "#abc" as "#aabbcc". */
function six(colour) {
    return colour.length === 4 ? "#" + [...colour.slice(1)].map((c) => c + c).join("") : colour;
}
