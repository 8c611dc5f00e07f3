"use strict";
const part = (id) => document.getElementById(id);
let events = null;
let isOver = false;

function show(id) {
    return (event) => {
        part(id).src = event.data;
        part(id).hidden = false;
    };
}

function open() {
    if (events || isOver) return;
    events = new EventSource("events");
    events.addEventListener("open", () => { part("note").textContent = ""; });
    events.addEventListener("run", (event) => {
        const run = JSON.parse(event.data);
        part("name").textContent = run.name + " \u2192 " + run.directory;
        document.title = run.name;
    });
    events.addEventListener("progress", (event) => {
        const progress = JSON.parse(event.data);
        part("text").textContent = progress.text;
        part("part").value = progress.part;
        document.title = Math.floor(100 * progress.part) + " % " + part("name").textContent;
    });
    events.addEventListener("picture", show("picture"));
    events.addEventListener("series", show("series"));
    events.addEventListener("problem", (event) => { part("note").textContent = event.data; });
    events.addEventListener("end", (event) => {
        isOver = true;
        close();
        part("note").textContent = event.data;
        document.title = "ended: " + part("name").textContent;
    });
    events.onerror = () => {
        part("note").textContent = "no connection: the run has ended, or was killed";
        // The browser tries again by itself unless it was refused.
        if (events.readyState === EventSource.CLOSED) close();
    };
}

function close() {
    if (events) events.close();
    events = null;
}

// A page in the background costs the run nothing.
document.addEventListener("visibilitychange", () => (document.hidden ? close() : open()));
open();
