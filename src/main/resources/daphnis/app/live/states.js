// States as the server sends them, and those that are kept.

const COLUMNS = ["x", "y", "z", "radius", "speed", "mass"];
const MOST_TRIES = 20;
const MOST_BYTES = 256 * 1024 * 1024;

/**
 * A state from its bytes: the length of the head (four bytes, the lowest first), the head as JSON, then a column of
 * Float32, the lowest byte first, for each of COLUMNS, then a column of bytes with the numbers of materials.
 */
export function decode(buffer) {
    const length = new DataView(buffer).getUint32(0, true);
    const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
    // With the densities that may be computed of it.
    const state = { head, bytes: buffer.byteLength + 4 * head.count };
    let place = 4 + length;
    for (const name of COLUMNS) {
        state[name] = floats(buffer, place, head.count);
        place += 4 * head.count;
    }
    state.material = new Uint8Array(buffer, place, head.count);
    return state;
}

const IS_LITTLE = new Uint8Array(new Uint32Array([1]).buffer)[0] === 1;

function floats(buffer, place, count) {
    if (IS_LITTLE) return new Float32Array(buffer, place, count);
    const view = new DataView(buffer, place, 4 * count);
    return Float32Array.from({ length: count }, (_, k) => view.getFloat32(4 * k, true));
}

/**
 * The states that can be gone through, by number. Of a recorded run all can be fetched at any time; of a run that goes
 * on only the newest, so that one that is dropped is gone.
 */
export class States {
    constructor() {
        this.numbers = [];
        this.kept = new Map(); // by number, the one longest unused first
        this.bytes = 0;
        this.isRecorded = true;
        this.isOver = false;
        this.fetched = new Map();
    }

    /** The state, or null where there is none any more. */
    async get(number) {
        const state = this.kept.get(number);
        if (state) {
            this.kept.delete(number);
            this.kept.set(number, state);
            return state;
        }
        // Who asks twice waits for the same answer.
        if (!this.fetched.has(number)) {
            this.fetched.set(number, this.fetch(number).finally(() => this.fetched.delete(number)));
        }
        return this.fetched.get(number);
    }

    /** No more can be had: those that are kept are all. */
    end() {
        this.isOver = true;
        this.numbers = this.numbers.filter((number) => this.kept.has(number));
    }

    async fetch(number) {
        if (this.isOver) return null;
        let answer = await fetch(`state/${number}`);
        // The server sends to so many at a time.
        for (let k = 0; k < MOST_TRIES && answer.status === 503; k++) {
            await new Promise((done) => setTimeout(done, 250));
            answer = await fetch(`state/${number}`);
        }
        if (answer.status === 204) return null;
        if (!answer.ok) throw new Error((await answer.text()) || `state ${number}: ${answer.status}`);
        const state = decode(await answer.arrayBuffer());
        this.keep(number, state);
        return state;
    }

    keep(number, state) {
        this.kept.set(number, state);
        this.bytes += state.bytes;
        for (const [oldest, dropped] of this.kept) {
            if (this.bytes <= MOST_BYTES || oldest === number) break;
            this.kept.delete(oldest);
            this.bytes -= dropped.bytes;
            if (!this.isRecorded) this.numbers = this.numbers.filter((other) => other !== oldest);
        }
        if (!this.isRecorded && !this.numbers.includes(number)) this.numbers.push(number);
    }
}
