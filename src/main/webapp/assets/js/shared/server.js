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

/** Of the page's forms; another one after the user has logged in again elsewhere. */
let csrfToken = document.querySelector('input[name="_csrf"]')?.value;

/**
 * Sends something to the API; answers {status, body}, with the status 0 where the server does not answer.
 *
 * @param body sent as it is with that media type, else as JSON; undefined: none
 */
export async function send(method, path, body, mediaType = undefined) {
  try {
    let answer = await sendOnce(method, path, body, mediaType);
    if (answer.status === 403) {
      const page = await (await fetch(location.href)).text();
      csrfToken = new DOMParser().parseFromString(page, 'text/html').querySelector('input[name="_csrf"]')?.value;
      answer = await sendOnce(method, path, body, mediaType);
    }
    const content = await answer.text();
    return {status: answer.status, body: content === '' ? undefined : JSON.parse(content)};
  } catch {
    return {status: 0, body: undefined};
  }
}

function sendOnce(method, path, body, mediaType) {
  return fetch(address(path), {
    method,
    headers: {accept: 'application/json', 'content-type': mediaType ?? 'application/json', 'X-CSRF-Token': csrfToken ?? ''},
    body: mediaType || body === undefined ? body : JSON.stringify(body),
    keepalive: method === 'DELETE', // what is ended is ended though the page is left at once
  });
}
