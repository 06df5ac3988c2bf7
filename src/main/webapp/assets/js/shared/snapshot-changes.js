/** By which member the parts of each list of a snapshot are told apart. */
const KEYS = {robots: 'name', tasks: 'id', floors: 'floor'};

/** The next snapshot: the one before with what has changed since. Neither of both is altered. */
export function applyChange(snapshot, {order = {}, ...change}) {
  const next = {...snapshot, ...change};
  for (const [list, key] of Object.entries(KEYS)) {
    const parts = new Map(snapshot[list].map((part) => [part[key], part]));
    for (const part of change[list] ?? []) {
      parts.set(part[key], {...parts.get(part[key]), ...part});
    }
    next[list] = (order[list] ?? [...parts.keys()]).map((name) => parts.get(name));
  }
  return next;
}
