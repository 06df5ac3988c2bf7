package org.toqa.yaml;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Says what is wrong with a text that is not YAML in the words of who wrote it. */
final class SyntaxAdvice {
  private record Rule(Pattern problem, String advice) {}

  /** The first whose pattern is found counts; {@code $1} is what the pattern's group holds. */
  private static final List<Rule> RULES =
      List.of(
          rule("mapping values are not allowed", "a text with a colon in it stands in quotes"),
          rule("found duplicate key (.+)", "$1 is there twice; leave one of them"),
          rule("\\\\t\\(TAB\\)", "lines are indented by spaces, not by tabs"),
          rule(
              "found character '(.+?)' that cannot start",
              "a text that begins with $1 stands in quotes"),
          rule("could not find expected ':'", "after a key comes a colon and a space"),
          rule(
              "expected <block end>",
              "this line is indented otherwise than those before it, or a bracket or quote is open"),
          rule("unexpected end of stream", "a quote is opened and not closed"),
          rule("expected ',' or '([]}])'", "a list in brackets is not closed with $1"),
          rule("Global tag is not allowed|^tag$", "there are only texts, numbers, lists and keys"),
          rule("special characters are not allowed", "there is a character that is no text"),
          rule("undefined alias", "a text that begins with * stands in quotes"),
          rule("expected alphabetic or numeric", "a text that begins with * or & stands in quotes"),
          rule("Nesting Depth exceeded", "it is nested too deeply"),
          rule("code points exceeds the limit", "it is too long"),
          rule(
              "aliases for non-scalar",
              "what was written once is written again where it is needed"));

  private SyntaxAdvice() {}

  private static Rule rule(String problem, String advice) {
    return new Rule(Pattern.compile(problem), advice);
  }

  /**
   * A clause: what is wrong, or what to do.
   *
   * @param problem what the parser says; what is not known is returned as it is, its first line
   */
  static String of(String problem) {
    for (Rule rule : RULES) {
      Matcher found = rule.problem().matcher(problem);
      if (found.find()) {
        String part = found.groupCount() == 0 ? "" : found.group(1);
        return rule.advice().replace("$1", part);
      }
    }
    return problem.lines().findFirst().orElse("");
  }
}
