package org.toqa.app.server;

import java.util.Map;

/**
 * A form that is filled in as it should be, and what becomes of an attack in each of its fields.
 *
 * @param page where the form is; what is in braces is put in
 * @param route where it is sent, as in the table of routes
 * @param filled what the page does not fill in itself
 * @param attacked what becomes of an attack, by field
 * @param good the status when nothing is wrong
 */
record FormCase(
    String page,
    String route,
    Map<String, String> filled,
    Map<String, Verdict> attacked,
    int good) {

  static FormCase of(
      String page, String route, Map<String, String> filled, Map<String, Verdict> attacked) {
    return new FormCase(page, route, filled, attacked, 303);
  }

  FormCase answeredWith(int status) {
    return new FormCase(page, route, filled, attacked, status);
  }

  int expected(String field, Attack attack) {
    return attacked.getOrDefault(field, Verdict.REFUSED).status(attack, good);
  }
}
