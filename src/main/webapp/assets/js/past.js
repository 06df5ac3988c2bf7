import {Course} from './course.js';
import {fetchJson} from './server.js';

const CHUNK = 600_000; // milliseconds that are fetched at once
const KEPT = 12; // chunks
const MOST_EVENTS = 1000; // of a chunk and the one before it

const chunkOf = (time) => Math.floor(time / CHUNK) * CHUNK;

/** What is stored of a floor, fetched bit by bit as it is wanted. Times are milliseconds since 1970. */
export class Past {
  #floor;
  #end;
  #onCome;
  #chunks = new Map(); // by the time at which each begins
  #wanted = 0;
  #busy = false;

  /**
   * @param end where the past ends
   * @param onCome called when a bit of it has come
   */
  constructor(floor, end, onCome) {
    this.#floor = floor;
    this.#end = end;
    this.#onCome = onCome;
  }

  /** Whether what was at that time is here. */
  has(time) {
    return this.#chunks.has(chunkOf(time));
  }

  /** Fetches what was at that time, and what comes next. */
  async want(time) {
    this.#wanted = time;
    if (this.#busy) {
      return;
    }
    this.#busy = true;
    try {
      for (let begin = this.#missing(); begin !== undefined; begin = this.#missing()) {
        this.#keep(begin, await this.#fetch(begin));
      }
    } finally {
      this.#busy = false;
    }
  }

  /** Where that robot was; undefined where nothing is known of it. */
  poseOf(robot, time) {
    return this.#chunks.get(chunkOf(time))?.courses.get(robot)?.at(time);
  }

  /** What had happened lately, newest first. */
  events(time) {
    const events = this.#chunks.get(chunkOf(time))?.events ?? [];
    return events.filter(({at}) => Date.parse(at) <= time);
  }

  #missing() {
    const begin = chunkOf(this.#wanted);
    return [begin, begin + CHUNK].find((time) => time < this.#end && !this.#chunks.has(time));
  }

  #keep(begin, chunk) {
    this.#chunks.set(begin, chunk);
    if (this.#chunks.size > KEPT) {
      this.#chunks.delete(this.#chunks.keys().next().value);
    }
    this.#onCome();
  }

  async #fetch(begin) {
    const until = new Date(begin + CHUNK).toISOString();
    const before = new Date(begin - CHUNK).toISOString();
    const [points, {events}] = await Promise.all([
      this.#tracks(begin, until),
      fetchJson(`api/v1/history?from=${before}&until=${until}&limit=${MOST_EVENTS}`),
    ]);
    return {
      courses: new Map([...points].map(([robot, track]) => [robot, new Course(track)])),
      events: events.filter(({kind}) => !kind.startsWith('user.')),
    };
  }

  /** The points of each robot; the server tells of a shorter time where there are very many. */
  async #tracks(begin, until) {
    const all = new Map();
    for (let from = begin; from < Date.parse(until); ) {
      const query = new URLSearchParams({floor: this.#floor, from: new Date(from).toISOString(), until});
      const answer = await fetchJson(`api/v1/tracks?${query}`);
      for (const {robot, points} of answer.robots) {
        const track = all.get(robot) ?? [];
        const last = track.at(-1)?.[0] ?? -Infinity;
        const here = points.map(([after, x, y]) => [from + after, x, y]);
        all.set(robot, [...track, ...here.filter(([at]) => at > last)]);
      }
      from = Date.parse(answer.until);
    }
    return all;
  }
}
