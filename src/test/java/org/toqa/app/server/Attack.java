package org.toqa.app.server;

/** What attackers type where a person types a word. The mark tells what came of it in a page. */
enum Attack {
  SCRIPT("<script>toqaevil()</script>"),
  ELEMENT("\"><toqaevil src=x onerror=toqaevil()>"),
  ATTRIBUTE("' toqaevil='1\" toqaevil=\"1"),
  END_OF_ELEMENT("--></script></title></textarea></option><toqaevil>"),
  SQL("'; drop table users; --"),
  SQL_CONDITION("' or '1'='1"),
  EXPRESSION("${77777777*7}#{77777777*7}{{77777777*7}}"),
  MESSAGE_PATTERN("{0}{1,number}'{'%s%n"),
  PATH("../../../../etc/passwd"),
  HEADER("x\r\nSet-Cookie: toqaevil=1\r\n\r\n<toqaevil>"),
  ZERO("toqa\u0000evil"),
  ESCAPE("\u001b[31mtoqaevil\u0007"),
  VERY_LONG("toqaevil".repeat(1000)),
  DIRECTIONS("toqa\u202elive\u2066\u200f"),
  FORMULA("=HYPERLINK(\"//toqaevil.example\")"),
  FORMULA_OF_A_PROGRAM("+1+cmd|' /C calc'!A0"),
  JSON("\",\"role\":\"MANAGER\",\"x\":{\""),
  SCRIPT_ADDRESS("javascript:toqaevil()"),
  OTHER_SITE("//toqaevil.example/");

  /** What no element, attribute or address of a page may be called. */
  static final String MARK = "toqaevil";

  /** What {@link #EXPRESSION} would be if somebody evaluated it; no key has that by chance. */
  static final String EVALUATED = "544444439";

  private final String text;

  Attack(String text) {
    this.text = text;
  }

  String text() {
    return text;
  }

  /** Whether it is a name of up to so many characters, all of which are shown as they stand. */
  boolean isNameWithin(int characters) {
    return text.length() <= characters
        && this != DIRECTIONS
        && text.chars().noneMatch(Character::isISOControl);
  }

  /** Whether it can be one segment of an address. */
  boolean isOneSegment() {
    return text.indexOf('/') < 0 && text.indexOf('\\') < 0;
  }

  /** Whether it is as long as a password must be and may be. */
  boolean isPassword() {
    return text.length() >= 10 && text.length() <= 200;
  }
}
