package org.toqa.web.input;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** What is wrong with the lines of a table. */
public final class LineFaults {
  /** More would not be read. */
  private static final int MAX_SHOWN = 50;

  private final List<LineFault> all = new ArrayList<>();

  void add(LineFault fault) {
    all.add(fault);
  }

  /** What is wrong with the cells of one line. */
  void addAll(long line, FieldErrors errors) {
    errors.sentences().forEach((column, sentence) -> add(new LineFault(line, column, sentence)));
  }

  public boolean isEmpty() {
    return all.isEmpty();
  }

  /** The first ones, from the top of the table. */
  public List<LineFault> first() {
    return all.stream().sorted(Comparator.comparingLong(LineFault::line)).limit(MAX_SHOWN).toList();
  }

  /** How many there are besides. */
  public int more() {
    return Math.max(0, all.size() - MAX_SHOWN);
  }
}
