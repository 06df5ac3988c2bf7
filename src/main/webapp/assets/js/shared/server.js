/** The server's address, however deep in a site it lies: this file is three folders below it. */
const root = new URL('../../../', import.meta.url);

/** The full address of a path of the application, such as 'api/v1/map'. */
export function address(path) {
  return new URL(path, root);
}

/**
 * Fetches JSON; throws an error with the answer's status when there is none. It is no use of the session, since pages
 * fetch by themselves while nobody sits before them.
 */
export async function fetchJson(path) {
  const answer = await fetch(address(path), {headers: {accept: 'application/json', 'x-toqa-background': 'yes'}});
  if (!answer.ok) {
    throw Object.assign(new Error(`${path} answered ${answer.status}`), {status: answer.status});
  }
  return answer.json();
}
