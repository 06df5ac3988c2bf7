package org.toqa.app.bench;

import java.util.List;
import java.util.stream.Collectors;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.Stance;

/**
 * The text that an outside checker reads: a line a step, the robots in a fixed order, separated by
 * blanks; a robot is {@code column,row}, in turns {@code column,row,H} with H one of N E S W.
 */
record StanceLines(MotionModel model) {

  String line(List<Stance> stances) {
    return stances.stream().map(this::word).collect(Collectors.joining(" "));
  }

  private String word(Stance stance) {
    String cell = stance.cell().column() + "," + stance.cell().row();
    return model == MotionModel.CLASSIC ? cell : cell + "," + stance.heading().name().charAt(0);
  }
}
