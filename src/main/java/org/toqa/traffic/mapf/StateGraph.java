package org.toqa.traffic.mapf;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;

import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;

/**
 * The states of a robot and what each action makes of them. In {@link MotionModel#CLASSIC} a state
 * is a vertex and an action a direction to go in; in {@link MotionModel#TURNS} a state is a vertex
 * and a direction to face, and the actions are forward, left and right. Action 0 is to wait.
 * Immutable.
 */
public final class StateGraph {
  public static final int WAIT = 0;

  private static final int FORWARD = 1;
  private static final int LEFT = 2;
  private static final int RIGHT = 3;

  private final RoadGraph roads;
  private final MotionModel model;
  private final int headings;
  private final int actions;
  private final int[] after;
  private final int[] before;
  private final int[] vertices;

  public StateGraph(RoadGraph roads, MotionModel model) {
    this.roads = roads;
    this.model = model;
    this.headings = model == MotionModel.TURNS ? DIRECTIONS : 1;
    this.actions = model == MotionModel.TURNS ? RIGHT + 1 : DIRECTIONS + 1;
    int states = roads.vertexCount() * headings;
    vertices = new int[states];
    after = new int[states * actions];
    before = new int[states * actions];
    for (int state = 0; state < states; state++) {
      vertices[state] = state / headings;
      for (int action = 0; action < actions; action++) {
        after[state * actions + action] = findSuccessor(state, action);
        before[state * actions + action] = findPredecessor(state, action);
      }
    }
  }

  private int findSuccessor(int state, int action) {
    if (action == WAIT) {
      return state;
    }
    int vertex = state / headings;
    int heading = state % headings;
    return switch (model) {
      case CLASSIC -> roads.neighbour(vertex, action - 1);
      case TURNS ->
          switch (action) {
            case FORWARD -> facing(roads.neighbour(vertex, heading), heading);
            case LEFT -> state(vertex, heading + 1);
            default -> state(vertex, heading + DIRECTIONS - 1);
          };
    };
  }

  private int findPredecessor(int state, int action) {
    if (action == WAIT) {
      return state;
    }
    int vertex = state / headings;
    int heading = state % headings;
    return switch (model) {
      case CLASSIC -> roads.predecessor(vertex, RoadGraph.opposite(action - 1));
      case TURNS ->
          switch (action) {
            case FORWARD -> facing(roads.predecessor(vertex, RoadGraph.opposite(heading)), heading);
            case LEFT -> state(vertex, heading + DIRECTIONS - 1);
            default -> state(vertex, heading + 1);
          };
    };
  }

  private int facing(int vertex, int heading) {
    return vertex == NONE ? NONE : state(vertex, heading);
  }

  public RoadGraph roads() {
    return roads;
  }

  public MotionModel model() {
    return model;
  }

  /** How many there are. */
  public int stateCount() {
    return vertices.length;
  }

  /** How many there are, waiting among them. */
  public int actionCount() {
    return actions;
  }

  /** How many states a vertex has. */
  public int headingCount() {
    return headings;
  }

  /**
   * @param heading a direction of {@link RoadGraph}, counted on past the last; without meaning
   *     where the model knows no headings
   */
  public int state(int vertex, int heading) {
    return vertex * headings + heading % headings;
  }

  public int vertex(int state) {
    return vertices[state];
  }

  public int heading(int state) {
    return state % headings;
  }

  /** The state that an action leads to, or {@link RoadGraph#NONE} where it cannot be done. */
  public int successor(int state, int action) {
    return after[state * actions + action];
  }

  /** The state that an action leads here from, or {@link RoadGraph#NONE}. */
  public int predecessor(int state, int action) {
    return before[state * actions + action];
  }

  /** The direction that an action leads in, or {@link RoadGraph#NONE} where it keeps the vertex. */
  public int direction(int state, int action) {
    if (action == WAIT) {
      return NONE;
    }
    return switch (model) {
      case CLASSIC -> action - 1;
      case TURNS -> action == FORWARD ? heading(state) : NONE;
    };
  }

  /**
   * Whether doing the two one after the other gains nothing over another pair that takes the same
   * time: to turn and back, right about instead of left about, to wait before a turn instead of
   * after it.
   */
  public boolean isRedundantPair(int action, int next) {
    boolean turns = model == MotionModel.TURNS && (next == LEFT || next == RIGHT);
    return turns && action != FORWARD && !(action == LEFT && next == LEFT);
  }
}
