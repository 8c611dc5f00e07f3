// Mouse, touch and keys on the picture.

/**
 * Hands what is done to the canvas to the camera, and calls changed after it. `actions` has what other keys do, by
 * key; in fields and on buttons keys mean what they always do.
 */
export function listen(canvas, camera, changed, actions) {
    const pointers = new Map();

    const spread = () => {
        const [a, b] = [...pointers.values()];
        return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, length: Math.hypot(a.x - b.x, a.y - b.y) };
    };

    canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    canvas.addEventListener("pointermove", (event) => {
        const before = pointers.get(event.pointerId);
        if (!before) return;
        const height = canvas.clientHeight;
        const now = { x: event.clientX, y: event.clientY };
        if (pointers.size === 1) {
            const [right, down] = [(now.x - before.x) / height, (now.y - before.y) / height];
            const isMove = event.shiftKey || event.buttons & 2 || camera.isFlat;
            pointers.set(event.pointerId, now);
            if (isMove) camera.move(right, -down);
            else camera.rotate(right * Math.PI, down * Math.PI);
        } else if (pointers.size === 2) {
            const from = spread();
            pointers.set(event.pointerId, now);
            const to = spread();
            camera.move((to.x - from.x) / height, (from.y - to.y) / height);
            if (from.length > 0 && to.length > 0) camera.approach(to.length / from.length);
        }
        changed();
    });
    for (const kind of ["pointerup", "pointercancel", "lostpointercapture"]) {
        canvas.addEventListener(kind, (event) => pointers.delete(event.pointerId));
    }
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => {
        event.preventDefault();
        // A wheel counts in pixels, lines or pages.
        const pixels = event.deltaY * [1, 16, 400][event.deltaMode];
        camera.approach(Math.exp(-Math.max(-400, Math.min(400, pixels)) / 500));
        changed();
    }, { passive: false });

    const turn = Math.PI / 36;
    const keys = {
        ArrowLeft: () => (camera.isFlat ? camera.move(0.05, 0) : camera.rotate(-turn, 0)),
        ArrowRight: () => (camera.isFlat ? camera.move(-0.05, 0) : camera.rotate(turn, 0)),
        ArrowUp: () => (camera.isFlat ? camera.move(0, -0.05) : camera.rotate(0, turn)),
        ArrowDown: () => (camera.isFlat ? camera.move(0, 0.05) : camera.rotate(0, -turn)),
        "+": () => camera.approach(1.15),
        "=": () => camera.approach(1.15),
        "-": () => camera.approach(1 / 1.15),
        t: () => camera.fromAbove(),
        f: () => camera.fromSide(),
        0: () => camera.reset(),
    };
    document.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.target.closest?.("input, select, button, a")) return;
        const act = keys[event.key] ?? actions[event.key];
        if (!act) return;
        event.preventDefault();
        act();
        changed();
    });
}
