// Going through states: slider, steps, play. At the newest state those that come are followed.

export class Player {
    /** show is called with each state that is to be seen; problem with what went wrong, in words. */
    constructor(part, states, show, problem) {
        this.part = part;
        this.states = states;
        this.show = show;
        this.problem = problem;
        this.number = null; // of the state that is seen, or that has been asked for last
        this.isPlaying = false;
        part("play").addEventListener("click", () => this.toggle());
        part("back").addEventListener("click", () => this.step(-1));
        part("next").addEventListener("click", () => this.step(1));
        part("slider").addEventListener("input", () => {
            // Pausing puts the slider where the player is.
            const place = Number(part("slider").value);
            this.pause();
            this.goTo(place);
        });
    }

    get place() {
        return this.states.numbers.indexOf(this.number);
    }

    get isAtEnd() {
        return this.number === null || this.place === this.states.numbers.length - 1;
    }

    /** The numbers have changed; wasAtEnd is what isAtEnd was before. */
    async renewed(wasAtEnd) {
        const last = this.states.numbers.length - 1;
        const isGone = this.place < 0;
        if ((wasAtEnd || isGone) && !this.isPlaying && last >= 0) await this.goTo(last);
        this.tell();
    }

    tell() {
        const last = this.states.numbers.length - 1;
        const slider = this.part("slider");
        slider.max = Math.max(0, last);
        slider.value = Math.max(0, this.place);
        slider.disabled = last < 1;
        slider.setAttribute("aria-valuetext", this.part("when").textContent);
        this.part("back").disabled = this.place <= 0;
        this.part("next").disabled = this.place >= last;
        this.part("play").disabled = last < 1;
        this.part("play").textContent = this.isPlaying ? "pause" : "play";
    }

    /** Shows the state at a place; false if there is none there any more. */
    async goTo(place) {
        const number = this.states.numbers[place];
        if (number === undefined) return false;
        this.number = number;
        this.tell();
        try {
            const state = await this.states.get(number);
            // Another one was asked for in between.
            if (this.number !== number) return true;
            if (state === null) return false;
            this.show(state);
            this.tell();
            return true;
        } catch (e) {
            this.problem(e.message);
            return false;
        }
    }

    step(by) {
        this.pause();
        return this.goTo(this.place + by);
    }

    pause() {
        this.isPlaying = false;
        this.tell();
    }

    toggle() {
        if (this.isPlaying) this.pause();
        else this.play();
    }

    async play() {
        if (this.states.numbers.length < 2 || this.isPlaying) return;
        this.isPlaying = true;
        const turn = (this.turn = {}); // an earlier one that still waits sees that it is over
        let place = this.isAtEnd ? 0 : this.place;
        while (this.isPlaying && this.turn === turn && place < this.states.numbers.length) {
            const due = performance.now() + 1000 / Number(this.part("rate").value);
            const isShown = await this.goTo(place);
            if (!isShown || !this.isPlaying || this.turn !== turn) break;
            const following = this.states.numbers[this.place + 1];
            if (following !== undefined) this.states.get(following).catch(() => null);
            await new Promise((done) => setTimeout(done, Math.max(0, due - performance.now())));
            // Those that have been dropped meanwhile have moved the rest.
            place = this.place + 1;
        }
        if (this.turn === turn) this.pause();
    }
}
