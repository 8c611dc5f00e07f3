// A run in the browser: what the server tells, into the elements of the page.

import { Player } from "./player.js";
import { Stage } from "./stage.js";
import { States } from "./states.js";

const part = (id) => document.getElementById(id);
const note = (text) => { part("note").textContent = text; };
const states = new States();
let events = null;
let isOver = false;
let isLost = false;
let name = "daphnis";

const actions = {
    " ": () => player.toggle(),
    ",": () => player.step(-1),
    ".": () => player.step(1),
    p: () => stage.save(name),
};
const stage = stageOrNull();
const player = new Player(part, states, (state) => stage.show(state), note);
part("shot").addEventListener("click", () => stage.save(name));

/** Without WebGL 2 the run's own pictures from above stand in its place. */
function stageOrNull() {
    try {
        return new Stage(part, actions);
    } catch (e) {
        note(`${e.message}: pictures from above are shown instead`);
        return null;
    }
}

function picture(id) {
    return (event) => {
        part(id).src = event.data;
        part(id).hidden = false;
    };
}

let isFetching = false;

/** The newest state of a run that goes on, fetched as it comes; those that come meanwhile are passed over. */
async function follow(number) {
    follow.newest = number;
    if (isFetching) return;
    isFetching = true;
    let done = null;
    try {
        while (done !== follow.newest) {
            done = follow.newest;
            const wasAtEnd = player.isAtEnd;
            if (await states.get(done)) await player.renewed(wasAtEnd);
        }
    } catch (e) {
        note(e.message);
    } finally {
        isFetching = false;
    }
}

function open() {
    if (events || isOver) return;
    // Pictures cost the run time: they are drawn for those that ask for them.
    events = new EventSource(stage ? "changes" : "events");
    events.addEventListener("run", (event) => {
        const run = JSON.parse(event.data);
        name = run.name;
        if (isLost) note("");
        isLost = false;
        states.isRecorded = run.isRecorded === true;
        part("name").textContent = run.name + " \u2192 " + run.directory;
        part("part").hidden = states.isRecorded;
        if (states.isRecorded && !stage) note("no WebGL 2 in this browser: daphnis movie draws the states");
        document.title = run.name;
    });
    events.addEventListener("progress", (event) => {
        const progress = JSON.parse(event.data);
        part("text").textContent = progress.text;
        part("part").value = progress.part;
        document.title = Math.floor(100 * progress.part) + " % " + part("name").textContent;
    });
    events.addEventListener("states", (event) => {
        const wasAtEnd = player.isAtEnd;
        const { steps, text } = JSON.parse(event.data);
        states.numbers = steps;
        part("text").textContent = text;
        if (stage) player.renewed(wasAtEnd);
    });
    events.addEventListener("state", (event) => { if (stage) follow(JSON.parse(event.data).number); });
    events.addEventListener("picture", picture("picture"));
    events.addEventListener("series", picture("series"));
    events.addEventListener("problem", (event) => note(event.data));
    events.addEventListener("end", (event) => {
        close();
        end(JSON.parse(event.data));
    });
    events.onerror = () => {
        // The browser tries again by itself unless it was refused.
        const isRefused = events && events.readyState === EventSource.CLOSED;
        if (isRefused) close();
        lose(isRefused);
    };
}

/** The end takes the place of what is told while a run goes on; that of a viewer stands beside its states. */
function end({ kind, text }) {
    isOver = true;
    if (kind === "closed") {
        note(text);
    } else {
        part("text").textContent = text;
        part("text").dataset.end = kind;
        document.title = `${kind}: ${name}`;
        if (kind === "complete") part("part").value = 1;
    }
    // Once the state that is on its way has come, only what is here can be shown.
    Promise.allSettled([...states.fetched.values()]).then(() => {
        states.end();
        if (stage) player.renewed(false);
    });
}

/** What was told last is not what is now. */
function lose(isRefused) {
    const isKnown = part("name").textContent !== "daphnis";
    const server = !isKnown ? "program" : states.isRecorded ? "viewer" : "run";
    note(isRefused ? `no connection: eight pages are open already, or the ${server} has ended`
        : `no connection: the ${server} has ended, or was killed`);
    if (!isLost && !states.isRecorded && isKnown) {
        part("text").textContent = `last heard of: ${part("text").textContent}`;
    }
    document.title = `no connection: ${name}`;
    isLost = true;
}

function close() {
    if (events) events.close();
    events = null;
}

// A page in the background costs the run nothing.
document.addEventListener("visibilitychange", () => (document.hidden ? close() : open()));
open();
