package org.toqa.app.bench;

import java.util.List;
import java.util.stream.Collectors;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;

/**
 * The text that an independent checker reads: a line a step, the robots in a fixed order, separated
 * by blanks; a robot is {@code column,row}, in the model {@code turns} {@code column,row,H} with H
 * one of N E S W. Column 0 is the left of the map, row 0 its top.
 */
record StanceFormat(MotionModel model) {

  /** The robots in the order of the list. */
  String line(List<GridPose> stances) {
    return stances.stream().map(this::stanceText).collect(Collectors.joining(" "));
  }

  private String stanceText(GridPose stance) {
    String cell = stance.cell().column() + "," + stance.cell().row();
    return model == MotionModel.CLASSIC ? cell : cell + "," + stance.heading().name().charAt(0);
  }
}
