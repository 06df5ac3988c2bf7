package org.toqa.app.bench;

import java.util.List;
import java.util.stream.Collectors;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;

/**
 * The text that an outside checker reads: a line a step, the robots in a fixed order, separated by
 * blanks; a robot is {@code column,row}, in turns {@code column,row,H} with H one of N E S W.
 */
record StanceFormat(MotionModel model) {

  String line(List<GridPose> stances) {
    return stances.stream().map(this::stanceText).collect(Collectors.joining(" "));
  }

  private String stanceText(GridPose stance) {
    String cell = stance.cell().column() + "," + stance.cell().row();
    return model == MotionModel.CLASSIC ? cell : cell + "," + stance.heading().name().charAt(0);
  }
}
