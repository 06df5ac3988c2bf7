import '../shared/live.js';
import {address} from '../shared/server.js';

const place = document.getElementById('api');

/** What is tried out on this page is sent as this page's own user. */
function withToken(request) {
  if (new URL(request.url, location).origin === location.origin) {
    request.headers['X-CSRF-Token'] = place.dataset.csrf;
  }
  return request;
}

const isDark = matchMedia('(prefers-color-scheme: dark)');
const showDark = () => document.documentElement.classList.toggle('dark-mode', isDark.matches);
isDark.addEventListener('change', showDark);
showDark();

addEventListener('DOMContentLoaded', () =>
  globalThis.SwaggerUIBundle({
    url: address('api/v1/openapi.json').href,
    domNode: place,
    docExpansion: 'none', // of more than 140 in a list only those on the screen would be drawn
    defaultModelsExpandDepth: -1, // each is shown where it is used
    validatorUrl: null,
    requestInterceptor: withToken,
  }));
