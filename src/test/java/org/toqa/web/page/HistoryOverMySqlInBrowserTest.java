package org.toqa.web.page;

import org.toqa.web.WebTestServer;

/** The same on MySQL, as it is in use. */
class HistoryOverMySqlInBrowserTest extends HistoryInBrowserTest {
  @Override
  WebTestServer startServer() throws Exception {
    return WebTestServer.startOnMySql();
  }
}
