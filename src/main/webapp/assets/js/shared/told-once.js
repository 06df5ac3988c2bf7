/** What was done is told once: neither a reload nor a bookmark of the page tells it again. */
const url = new URL(location.href);
url.searchParams.delete('done');
history.replaceState(history.state, '', url);
