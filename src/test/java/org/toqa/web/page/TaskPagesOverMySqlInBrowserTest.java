package org.toqa.web.page;

import org.toqa.web.WebTestServer;

/** The same on MySQL, as it is in use. */
class TaskPagesOverMySqlInBrowserTest extends TaskPagesInBrowserTest {
  @Override
  WebTestServer startServer() throws Exception {
    return WebTestServer.startOnMySql();
  }
}
