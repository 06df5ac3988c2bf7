package org.toqa.allocation;

import java.util.List;

/** What an allocator answers, with its reason as a sentence for people. */
public sealed interface Decision {

  String why();

  record Assigned(List<String> robots, String why) implements Decision {}

  record Waits(String why) implements Decision {}
}
