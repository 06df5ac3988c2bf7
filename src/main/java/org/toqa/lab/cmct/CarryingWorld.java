package org.toqa.lab.cmct;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.toqa.cooperation.CarryCommand;
import org.toqa.cooperation.CarryEvent;
import org.toqa.cooperation.CarryState;
import org.toqa.cooperation.KnownBox;
import org.toqa.cooperation.RightOfWay;
import org.toqa.cooperation.SupervisorCycle;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.lab.cmct.CarryingBody.Errand;
import org.toqa.planning.Path;
import org.toqa.planning.PlanResult;

/**
 * A store in which robots carry boxes, in steps of a quarter of a second: bodies, boxes, cameras
 * and batteries as they are in truth, and what {@link SupervisorCycle} makes of what it is told of
 * them. Robots keep their distance by {@link RightOfWay} also while the supervisor is away. A robot
 * that fails stands where it is, with the box in its arm, until it starts again. Boxes are no
 * obstacles.
 */
final class CarryingWorld {
  static final double STEP = 0.25;

  static final String SUPERVISOR = "R3";
  static final List<String> WORKERS = List.of("R1", "R2");

  /** Metres from the middle of a box to that of who takes it. */
  private static final double REACH = 2;

  /** Metres between middles that a path keeps from robots that stand. */
  private static final double CLEARANCE = 1.8;

  /** Seconds that a robot which made room stays there. */
  private static final double ROOM = 30;

  private static final int BORDER = 3;

  /** Seconds until somebody without a path plans again. */
  private static final double RETRY = 2;

  /** Seconds between what robots tell of themselves. */
  private static final double REPORT = 1;

  /** Seconds until a larger map is told again. */
  private static final double GROWTH = 5;

  private final CarryingScene scene;
  private final CarryingSetup setup;
  private final OccupancyGrid floorForTwo;
  private final List<CarryingBody> bodies = new ArrayList<>();
  private final Map<Integer, Vec2> lying = new TreeMap<>();
  private final Map<Integer, Integer> deliveries = new TreeMap<>();
  private final List<Integer> askedFor = new ArrayList<>();
  private final Deque<CarryEvent> pending = new ArrayDeque<>();
  private boolean isTelling;
  private CarryState state;
  private RightOfWay rightOfWay = RightOfWay.CLEAR;
  private double time;
  private final List<Delivery> log = new ArrayList<>();
  private double lastReport = -1;
  private double lastGrowth;
  private boolean hasGrown;
  private double idle;
  private double waiting;
  private double nearest = Double.POSITIVE_INFINITY;
  private int stops;

  /**
   * A box was set down at its target.
   *
   * @param time seconds
   * @param driven metres by both workers until then
   */
  record Delivery(double time, double driven) {}

  CarryingWorld(CarryingScene scene, CarryingSetup setup) {
    this.scene = scene;
    this.setup = setup;
    floorForTwo = Inflation.inflate(scene.floor(), REACH + CarryingBody.RADIUS);
    for (int i = 0; i < scene.boxes().size(); i++) {
      lying.put(i, scene.boxes().get(i).place());
    }
    if (setup.isSupervised()) {
      bodies.add(
          new CarryingBody(SUPERVISOR, scene.starts().getFirst(), new SeenMap(scene.floor())));
    }
    for (int i = 0; i < WORKERS.size(); i++) {
      SeenMap own = setup.isSupervised() ? null : new SeenMap(scene.floor());
      bodies.add(new CarryingBody(WORKERS.get(i), scene.starts().get(1 + i), own));
    }
    state = begin();
    start();
  }

  private CarryState begin() {
    return CarryState.begin(setup.isSupervised() ? SUPERVISOR : null, WORKERS, scene.stations());
  }

  /** The mind has just started: it hears who is there. */
  private void start() {
    for (CarryingBody body : bodies) {
      if (body.isAlive) {
        openEyes(body);
        tell(report(body));
      }
    }
    List<CarryingBody> workers = new ArrayList<>(bodies.stream().filter(this::isWorker).toList());
    workers.sort((a, b) -> Boolean.compare(b.leads, a.leads));
    for (CarryingBody body : workers) {
      if (body.isAlive) {
        if (body.held == null && body.errand != Errand.CHARGE) {
          body.begin(Errand.NONE);
        }
        tell(back(body));
      }
    }
  }

  // What happens from outside

  /** A robot fails where it stands; with it, what it remembers. */
  void kill(String name) {
    CarryingBody body = body(name);
    if (!body.isAlive) {
      return;
    }
    body.isAlive = false;
    CarryingBody other = body.partner;
    Integer held = body.held;
    if (other != null && held != null) {
      part(body, other);
      setDownOnTheWay(other, held);
    }
    body.begin(Errand.NONE);
    if (isWorker(body)) {
      tell(new CarryEvent.WorkerLost(name));
      if (other != null && held != null) {
        tell(new CarryEvent.BoxSetDown(held, position(held)));
      }
    }
  }

  private static void part(CarryingBody one, CarryingBody other) {
    one.partner = null;
    other.partner = null;
    one.leads = false;
    other.leads = false;
  }

  /** Who is left alone with a box that is too heavy sets it down between the two. */
  private void setDownOnTheWay(CarryingBody left, int box) {
    Vec2 middle = left.position;
    for (CarryingBody body : bodies) {
      if (Integer.valueOf(box).equals(body.held) && body != left) {
        middle = left.position.plus(body.position).times(0.5);
      }
    }
    for (CarryingBody body : bodies) {
      if (Integer.valueOf(box).equals(body.held)) {
        body.held = null;
      }
    }
    lying.put(box, scene.floor().centre(scene.floor().cellAt(middle)));
    left.begin(Errand.NONE);
    toMiddle(left);
  }

  /** It starts again, and knows no more than what is in its arm and where it is. */
  void revive(String name) {
    CarryingBody body = body(name);
    if (body.isAlive) {
      return;
    }
    body.isAlive = true;
    body.path.clear();
    if (body.seen != null) {
      body.seen.forget();
      body.lookedFrom = null;
      body.glimpsed.clear();
    }
    toMiddle(body);
    if (isWorker(body)) {
      openEyes(body);
      tell(report(body));
      tell(back(body));
    } else {
      state = begin();
      start();
    }
  }

  // What came of it

  boolean isDone() {
    return isMindAlive() && state.isDone();
  }

  /** Of each box, how often it was set down at its target. */
  Map<Integer, Integer> deliveries() {
    return Map.copyOf(deliveries);
  }

  /** Boxes that lie somewhere or are held, each once. */
  int boxes() {
    Set<Integer> all = new TreeSet<>(lying.keySet());
    bodies.stream().map(body -> body.held).filter(held -> held != null).forEach(all::add);
    return all.size();
  }

  boolean isEachAtTarget() {
    return IntStream.range(0, scene.boxes().size()).allMatch(this::isAtTarget);
  }

  private boolean isAtTarget(int box) {
    return lying.containsKey(box)
        && lying.get(box).distanceTo(scene.boxes().get(box).target()) < 1e-9;
  }

  List<Integer> askedFor() {
    return List.copyOf(askedFor);
  }

  double time() {
    return time;
  }

  /** Seconds after which the last box was at its target. */
  double lastDelivery() {
    return log.isEmpty() ? 0 : log.getLast().time();
  }

  /** All of them, in their order. */
  List<Delivery> log() {
    return List.copyOf(log);
  }

  /** Seconds that workers had no box to go for, while some were not delivered. */
  double idle() {
    return idle;
  }

  /** Seconds that workers waited beside a box for a second one. */
  double waiting() {
    return waiting;
  }

  /** Metres between the edges of two robots, the least ever. */
  double nearest() {
    return nearest - 2 * CarryingBody.RADIUS;
  }

  /** How often robots were stopped for each other. */
  int stops() {
    return stops;
  }

  double driven(boolean byWorkers) {
    return bodies.stream()
        .filter(body -> isWorker(body) == byWorkers)
        .mapToDouble(body -> body.driven)
        .sum();
  }

  /** All that is, for who looks for a fault. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("%.0f s, ".formatted(time) + rightOfWay);
    for (CarryingBody body : bodies) {
      text.append(
          "\n%s at %s, %s %d to %s, %d cells, busy %.1f, alive %s, holds %s, battery %.2f"
              .formatted(
                  body.name,
                  body.position,
                  body.errand,
                  body.about,
                  body.goal,
                  body.path.size(),
                  body.busy,
                  body.isAlive,
                  body.held,
                  body.battery));
    }
    return text + "\n" + state;
  }

  // A step

  void step() {
    time += STEP;
    findRightOfWay();
    for (CarryingBody body : bodies) {
      if (body.isAlive) {
        live(body);
      }
    }
    measure();
    if (time - lastReport >= REPORT) {
      lastReport = time;
      for (CarryingBody body : bodies) {
        if (body.isAlive) {
          look(body);
          tell(report(body));
        }
      }
    }
  }

  private void live(CarryingBody body) {
    if (body.errand != Errand.NONE && body.errand != Errand.CHARGE) {
      body.work += STEP;
    }
    if (body.busy > 0) {
      body.busy -= STEP;
      if (body.busy <= 0) {
        finish(body);
      }
      return;
    }
    if (body.errand == Errand.CHARGE) {
      body.battery = Math.min(1, body.battery + STEP / setup.charging());
      if (body.battery >= 1) {
        body.work = 0;
        body.begin(Errand.NONE);
        tell(new CarryEvent.RobotCharged(body.name));
      }
      return;
    }
    if (body.pause > 0) {
      body.pause -= STEP;
      return;
    }
    CarryingBody other = body.partner;
    if (other != null && !body.leads) {
      return;
    }
    if (!body.path.isEmpty()) {
      double before = body.driven;
      boolean isThere = body.drive(setup.speed() * STEP, mayDrive(body));
      double share = (body.driven - before) / setup.speed() / setup.endurance();
      drain(body, share);
      if (other != null) {
        drain(other, share);
      }
      if (isThere) {
        arrive(body);
      }
    } else if (isBound(body) && time >= body.retry) {
      if (!plan(body, List.of())) {
        body.retry = time + RETRY;
      } else if (body.path.isEmpty()) { // it is there
        arrive(body);
      }
    }
  }

  private static void drain(CarryingBody body, double share) {
    body.battery = Math.max(0, body.battery - share);
  }

  /** Whether it has somewhere to go. */
  private static boolean isBound(CarryingBody body) {
    return switch (body.errand) {
      case SEARCH, TO_BOX, TO_HELP, CARRY, TO_STATION, PARK -> true;
      case NONE, LOOK, WEIGH, WAIT, SET_DOWN, CHARGE -> false;
    };
  }

  private void arrive(CarryingBody body) {
    if (body.makesRoom) {
      body.makesRoom = false;
      body.pause = ROOM;
    }
    Vec2 goal = body.goal;
    if (goal == null || body.position.distanceTo(goal) > 1e-9) {
      return; // it plans anew
    }
    switch (body.errand) {
      case SEARCH -> seeAllRound(body);
      case TO_BOX -> busy(body, Errand.WEIGH, setup.handling());
      case TO_HELP -> {
        body.errand = Errand.WAIT;
        tell(new CarryEvent.SecondArrived(body.name));
      }
      case CARRY -> busy(body, Errand.SET_DOWN, setup.handling());
      case TO_STATION -> {
        if (goal.equals(scene.stations().get(body.about))) {
          body.begin(Errand.CHARGE);
        } else {
          seeAllRound(body);
        }
      }
      case PARK -> {
        body.begin(Errand.NONE);
        tell(new CarryEvent.RobotParked(body.name));
      }
      case NONE, LOOK, WEIGH, WAIT, SET_DOWN, CHARGE -> {}
    }
  }

  private void seeAllRound(CarryingBody body) {
    SeenMap map = body.seen;
    if (map != null) {
      map.giveUpRound(body.position, BORDER);
      look(body);
    }
  }

  private static void busy(CarryingBody body, Errand errand, double seconds) {
    body.halt();
    body.errand = errand;
    body.busy = Math.max(STEP, seconds);
  }

  private void finish(CarryingBody body) {
    switch (body.errand) {
      case LOOK -> {
        int box = body.about;
        body.begin(body.afterLook);
        see(body, box);
      }
      case WEIGH -> {
        body.errand = Errand.WAIT;
        if (isFound(body.about)) {
          tell(new CarryEvent.BoxWeighed(body.name, scene.boxes().get(body.about).kilograms()));
        }
      }
      case SET_DOWN -> setDown(body);
      default -> {}
    }
  }

  private void take(CarryingBody body) {
    CarryingBody other = body.partner;
    int box = body.about;
    for (CarryingBody dead : bodies) { // it lies in the arm of one that has failed
      if (Integer.valueOf(box).equals(dead.held) && !dead.isAlive) {
        dead.held = null;
      }
    }
    lying.remove(box);
    body.held = box;
    body.begin(Errand.CARRY, box);
    if (other != null) {
      other.held = box;
      other.begin(Errand.CARRY, box);
    }
  }

  private void setDown(CarryingBody body) {
    Integer box = body.held;
    CarryingBody other = body.partner;
    if (box == null) {
      return;
    }
    lying.put(box, scene.boxes().get(box).target());
    deliveries.merge(box, 1, Integer::sum);
    log.add(new Delivery(time, driven(true)));
    body.held = null;
    if (other != null) {
      other.held = null;
      part(body, other);
      other.begin(Errand.NONE);
      toMiddle(other);
    }
    body.begin(Errand.NONE);
    tell(new CarryEvent.BoxDelivered(box));
  }

  // What is told, and what is ordered

  private boolean isMindAlive() {
    return !setup.isSupervised() || body(SUPERVISOR).isAlive;
  }

  private void tell(CarryEvent event) {
    if (!isMindAlive()) {
      return;
    }
    pending.add(event);
    if (isTelling) {
      return; // it was told by what an order came to
    }
    isTelling = true;
    while (!pending.isEmpty()) {
      SupervisorCycle.Step step = SupervisorCycle.next(setup.rules(), state, pending.remove());
      state = step.state();
      step.commands().forEach(this::obey);
    }
    isTelling = false;
  }

  private CarryEvent report(CarryingBody body) {
    Integer station = null;
    for (int i = 0; i < scene.stations().size(); i++) {
      if (body.position.distanceTo(scene.stations().get(i)) < 0.1) {
        station = i;
      }
    }
    return new CarryEvent.RobotReported(body.name, body.position, body.battery, body.work, station);
  }

  private static CarryEvent back(CarryingBody body) {
    CarryingBody other = body.partner;
    return new CarryEvent.WorkerBack(body.name, body.held, other == null ? null : other.name);
  }

  private void obey(CarryCommand command) {
    switch (command) {
      case CarryCommand.Search search -> search(body(search.robot()), search.isAnew());
      case CarryCommand.Wait wait -> {
        CarryingBody body = body(wait.robot());
        body.afterLook = Errand.NONE;
        if (body.errand != Errand.LOOK) {
          body.begin(Errand.NONE);
        }
      }
      case CarryCommand.GoToBox go -> {
        CarryingBody body = body(go.worker());
        body.begin(go.isSecond() ? Errand.TO_HELP : Errand.TO_BOX, go.box());
        if (go.isSecond()) {
          learnFromOthers(body);
        }
        if (!go.isSecond() && !(plan(body, List.of()) && hasWayOn(body))) {
          body.begin(Errand.NONE);
          tell(new CarryEvent.BoxUnreachable(go.worker()));
        }
      }
      case CarryCommand.Carry carry -> carry(carry);
      case CarryCommand.Charge charge ->
          body(charge.robot()).begin(Errand.TO_STATION, charge.station());
      case CarryCommand.Park park -> body(park.worker()).begin(Errand.PARK);
      case CarryCommand.AskForWorker ask -> askedFor.add(ask.box());
    }
  }

  /** Who is called is told what the others have seen. */
  private void learnFromOthers(CarryingBody body) {
    for (CarryingBody other : bodies) {
      if (body.seen != null && other.seen != null && other.isAlive) {
        body.seen.learn(other.seen);
      }
    }
  }

  private void search(CarryingBody body, boolean isAnew) {
    if (isAnew) {
      bodies.stream().map(b -> b.seen).filter(Objects::nonNull).forEach(SeenMap::scanAnew);
    }
    body.afterLook = Errand.SEARCH;
    if (body.errand != Errand.LOOK) {
      body.begin(Errand.SEARCH);
    }
  }

  private void carry(CarryCommand.Carry order) {
    CarryingBody first = body(order.workers().getFirst());
    int box = order.box();
    if (Integer.valueOf(box).equals(first.held)) {
      if (first.errand != Errand.CARRY && first.errand != Errand.SET_DOWN) {
        first.begin(Errand.CARRY, box);
      }
      return;
    }
    boolean isThere = isFound(box) && first.position.distanceTo(position(box)) <= REACH + 1e-9;
    if (!isThere) {
      return;
    }
    if (order.workers().size() == 2) {
      CarryingBody second = body(order.workers().get(1));
      first.partner = second;
      second.partner = first;
      first.leads = true;
      first.side = first.position.minus(position(box));
    }
    take(first);
  }

  // Eyes

  private void look(CarryingBody body) {
    SeenMap map = body.seen;
    if (map == null) {
      return;
    }
    if (!body.position.equals(body.lookedFrom)) {
      body.lookedFrom = body.position;
      hasGrown |= map.look(body.position, setup.range());
    }
    if (hasGrown && time - lastGrowth >= GROWTH) {
      hasGrown = false;
      lastGrowth = time;
      tell(new CarryEvent.MapGrown());
    }
    for (int box = 0; box < scene.boxes().size(); box++) {
      if (isFound(box)
          && isNews(body, box)
          && body.errand != Errand.LOOK
          && map.isInView(body.position, position(box), setup.range())) {
        if (body.errand == Errand.SEARCH) {
          body.afterLook = Errand.SEARCH;
          body.about = box;
          busy(body, Errand.LOOK, setup.look());
        } else if (body.glimpsed.merge(box, REPORT, Double::sum) >= setup.look()) {
          see(body, box);
        }
      }
    }
  }

  private void see(CarryingBody body, int box) {
    body.glimpsed.remove(box);
    if (isFound(box)) {
      tell(new CarryEvent.BoxSeen(body.name, box, position(box), isAtTarget(box)));
    }
  }

  private void openEyes(CarryingBody body) {
    if (body.seen != null) {
      body.seen.look(body.position, setup.range());
    }
  }

  /** Whether a box is anything new for who sees it. */
  private boolean isNews(CarryingBody body, int box) {
    KnownBox known = state.boxes().get(box);
    if (known == null || known.stage() == KnownBox.Stage.MISSING) {
      return true;
    }
    return !setup.isSupervised()
        && known.stage() == KnownBox.Stage.FOUND
        && !known.seenBy().contains(body.name);
  }

  /** Whether it lies somewhere, or is in the arm of one that has failed. */
  private boolean isFound(int box) {
    return lying.containsKey(box)
        || bodies.stream().anyMatch(b -> !b.isAlive && Integer.valueOf(box).equals(b.held));
  }

  private Vec2 position(int box) {
    Vec2 place = lying.get(box);
    if (place != null) {
      return place;
    }
    return bodies.stream()
        .filter(body -> Integer.valueOf(box).equals(body.held))
        .map(CarryingBody::next)
        .findFirst()
        .orElseThrow();
  }

  // Paths

  /** The map by which a robot drives: that of the supervisor, or its own. */
  private SeenMap mapOf(CarryingBody body) {
    SeenMap own = body.seen;
    return Objects.requireNonNull(own != null ? own : body(SUPERVISOR).seen);
  }

  /**
   * Plans for what a robot is about.
   *
   * @param avoided robots that stand
   * @return whether there is a path; where there is none, the robot stays
   */
  private boolean plan(CarryingBody body, List<CarryingBody> avoided) {
    if (body.partner != null) {
      return planTogether(body, avoided);
    }
    OccupancyGrid grid = without(body, avoided, CarryingBody.RADIUS, 0, body.next());
    Cell start = grid.cellAt(body.next());
    for (Vec2 goal : goals(body, grid)) {
      if (planner(grid, start, grid.cellAt(goal)) instanceof PlanResult.Found(Path path)) {
        drive(body, grid, path, Vec2.ZERO, goal);
        if (body.errand == Errand.TO_BOX) {
          body.side = goal.minus(position(body.about));
        }
        return true;
      }
    }
    return false;
  }

  private boolean planTogether(CarryingBody body, List<CarryingBody> avoided) {
    Vec2 middle = body.next().minus(body.side);
    double radius = REACH + CarryingBody.RADIUS;
    OccupancyGrid grid = without(body, avoided, radius, REACH, middle);
    Vec2 target = scene.boxes().get(body.about).target();
    if (planner(grid, grid.cellAt(middle), grid.cellAt(target))
        instanceof PlanResult.Found(Path path)) {
      drive(body, grid, path, body.side, target.plus(body.side));
      return true;
    }
    return false;
  }

  private PlanResult planner(OccupancyGrid grid, Cell start, Cell goal) {
    return setup.planner().plan(grid, start, goal);
  }

  private static void drive(
      CarryingBody body, OccupancyGrid grid, Path path, Vec2 offset, Vec2 goal) {
    Vec2 next = body.next();
    boolean isOnItsWay = !next.equals(body.position);
    body.path.clear();
    if (isOnItsWay) {
      body.path.add(next);
    }
    List<Cell> cells = path.cells();
    for (Cell cell : cells.subList(1, cells.size())) {
      body.path.add(grid.centre(cell).plus(offset));
    }
    body.goal = goal;
    body.makesRoom = false;
  }

  /**
   * Where the middle of a robot, or of two that carry, may be.
   *
   * @param extra metres from that middle to those of the robots
   */
  private OccupancyGrid without(
      CarryingBody body, List<CarryingBody> avoided, double radius, double extra, Vec2 from) {
    OccupancyGrid grid = mapOf(body).passable(radius);
    if (avoided.isEmpty()) {
      return grid;
    }
    BitSet occupied = grid.occupied();
    for (CarryingBody other : avoided) {
      for (Vec2 there : List.of(other.position, other.next())) {
        double keep = Math.min(CLEARANCE + extra, from.distanceTo(there) - 0.01);
        int reach = (int) Math.ceil(keep) + 1;
        for (Cell cell : grid.cellsAround(there, reach)) {
          if (grid.centre(cell).distanceTo(there) <= keep) {
            occupied.set(grid.index(cell));
          }
        }
      }
    }
    return grid.withOccupied(occupied);
  }

  /** Where it may go for what it is about, the best place first. */
  private List<Vec2> goals(CarryingBody body, OccupancyGrid grid) {
    return switch (body.errand) {
      case SEARCH -> searchGoals(body, grid);
      case TO_BOX -> isFound(body.about) ? sides(body, grid, position(body.about)) : List.of();
      case TO_HELP -> helpGoals(body);
      case CARRY -> sides(body, grid, scene.boxes().get(body.about).target());
      case TO_STATION -> {
        List<Vec2> goals = new ArrayList<>(List.of(scene.stations().get(body.about)));
        if (body.seen != null) {
          goals.addAll(border(body.seen, grid, body.next()));
        }
        yield goals;
      }
      case PARK -> List.of(body.parking);
      case NONE, LOOK, WEIGH, WAIT, SET_DOWN, CHARGE -> List.of();
    };
  }

  private List<Vec2> searchGoals(CarryingBody body, OccupancyGrid grid) {
    SeenMap map = mapOf(body);
    body.glimpsed.keySet().removeIf(box -> !isFound(box) || !isNews(body, box));
    for (int box : body.glimpsed.keySet()) {
      for (Cell cell : Flood.from(grid, grid.cellAt(body.next()))) {
        if (map.isInView(grid.centre(cell), position(box), setup.range())) {
          return List.of(grid.centre(cell));
        }
      }
    }
    List<Vec2> goals = border(map, grid, body.next());
    OccupancyGrid all = map.passable(CarryingBody.RADIUS);
    boolean isAll =
        goals.isEmpty()
            && body.glimpsed.isEmpty()
            && all.isFree(body.next())
            && (grid.equals(all) || border(map, all, body.next()).isEmpty());
    if (isAll) {
      body.begin(Errand.NONE);
      tell(new CarryEvent.StoreSeen(body.name));
    }
    return goals;
  }

  /** The nearest place, by the floor, from which something unseen is near; empty if none is. */
  private List<Vec2> border(SeenMap map, OccupancyGrid grid, Vec2 from) {
    for (Cell cell : Flood.from(grid, grid.cellAt(from))) {
      for (int row = -BORDER; row <= BORDER; row++) {
        for (int column = -BORDER; column <= BORDER; column++) {
          if (map.isBorder(new Cell(cell.column() + column, cell.row() + row))) {
            return List.of(grid.centre(cell));
          }
        }
      }
    }
    return List.of();
  }

  /**
   * The sides of a box from which it is taken or set down, the nearest first; those first to which
   * there is a free one opposite, since it may take two.
   */
  private static List<Vec2> sides(CarryingBody body, OccupancyGrid grid, Vec2 box) {
    Vec2[] ways = {
      new Vec2(-REACH, 0), new Vec2(REACH, 0), new Vec2(0, -REACH), new Vec2(0, REACH)
    };
    List<Vec2> sides = new ArrayList<>();
    for (Vec2 way : ways) {
      if (grid.isFree(box.plus(way))) {
        sides.add(box.plus(way));
      }
    }
    sides.sort(
        Comparator.comparing((Vec2 side) -> !grid.isFree(box.times(2).minus(side)))
            .thenComparingDouble(side -> side.distanceTo(body.position)));
    return sides;
  }

  private List<Vec2> helpGoals(CarryingBody body) {
    for (CarryingBody first : bodies) {
      boolean waits = first.errand == Errand.WAIT && first.about == body.about;
      if (first != body && first.isAlive && waits && isFound(body.about)) {
        return List.of(position(body.about).times(2).minus(first.position));
      }
    }
    return List.of();
  }

  /** Whether a box can be brought to its target over what has been seen, by two if need be. */
  private boolean hasWayOn(CarryingBody body) {
    Vec2 box = position(body.about);
    Vec2 target = scene.boxes().get(body.about).target();
    double both = REACH + CarryingBody.RADIUS;
    boolean isForTwo = floorForTwo.isFree(box);
    OccupancyGrid alone = mapOf(body).passable(CarryingBody.RADIUS);
    Vec2 from = box.plus(body.side);
    return sides(body, alone, target).stream().anyMatch(side -> isJoined(alone, from, side))
        && (!isForTwo || isJoined(mapOf(body).passable(both), box, target));
  }

  private boolean isJoined(OccupancyGrid grid, Vec2 from, Vec2 to) {
    return planner(grid, grid.cellAt(from), grid.cellAt(to)) instanceof PlanResult.Found;
  }

  // Who drives where they come close

  private void findRightOfWay() {
    List<RightOfWay.Place> places = bodies.stream().map(CarryingWorld::place).toList();
    RightOfWay before = rightOfWay;
    rightOfWay = rightOfWay.next(places, setup.nearest());
    if (!before.standing().containsAll(rightOfWay.standing())) {
      stops++;
    }
    boolean isNew =
        !Objects.equals(before.passing(), rightOfWay.passing())
            || !before.standing().containsAll(rightOfWay.standing());
    while (isNew && rightOfWay.passing() != null && !planPast(rightOfWay.passing())) {
      rightOfWay = rightOfWay.blocked().next(places, setup.nearest());
    }
    if (rightOfWay.passing() == null && !rightOfWay.tried().isEmpty()) {
      makeRoom();
    }
  }

  private static RightOfWay.Place place(CarryingBody body) {
    CarryingBody other = body.partner;
    return new RightOfWay.Place(
        body.name,
        body.position,
        body.isDriving(),
        body.held != null,
        other == null ? null : other.name);
  }

  private boolean mayDrive(CarryingBody body) {
    CarryingBody other = body.partner;
    if (body.name.equals(rightOfWay.passing())) {
      return true;
    }
    if (other == null) {
      return rightOfWay.mayDrive(body.name);
    }
    return other.name.equals(rightOfWay.passing())
        || (rightOfWay.mayDrive(body.name) && rightOfWay.mayDrive(other.name));
  }

  private boolean planPast(String name) {
    CarryingBody body = body(name);
    CarryingBody other = body.partner;
    CarryingBody driver = other != null && other.leads ? other : body;
    if (driver.makesRoom || !isBound(driver)) {
      return true; // a few steps that it has begun
    }
    Vec2 goal = driver.goal;
    List<Vec2> path = List.copyOf(driver.path);
    if (goal != null && keepsClear(driver)) {
      return true; // a new path each time might lead to and fro
    }
    if (plan(driver, standing(driver))) {
      return true;
    }
    driver.goal = goal;
    driver.path.clear();
    driver.path.addAll(path);
    return false;
  }

  /** Whether the path that a robot has keeps away from all that stand. */
  private boolean keepsClear(CarryingBody driver) {
    for (CarryingBody other : standing(driver)) {
      for (Vec2 there : List.of(other.position, other.next())) {
        for (Vec2 point : driver.path) {
          Vec2 second = driver.partner == null ? point : point.minus(driver.side.times(2));
          if (Math.min(point.distanceTo(there), second.distanceTo(there)) < CLEARANCE) {
            return false;
          }
        }
      }
    }
    return true;
  }

  private List<CarryingBody> standing(CarryingBody body) {
    return bodies.stream()
        .filter(other -> other != body && other != body.partner)
        .filter(other -> !mayDrive(other) || !other.isDriving())
        .toList();
  }

  /** Of those that are in each other's way, the one that does least drives aside. */
  private void makeRoom() {
    List<CarryingBody> candidates =
        bodies.stream()
            .filter(body -> rightOfWay.standing().contains(body.name))
            .filter(body -> body.isAlive && body.partner == null && body.busy <= 0)
            .filter(body -> body.errand == Errand.NONE || isBound(body))
            .sorted(
                Comparator.comparing((CarryingBody body) -> body.held != null)
                    .thenComparing(body -> body.errand != Errand.NONE)
                    .thenComparing(body -> body.name, Comparator.reverseOrder()))
            .toList();
    for (CarryingBody body : candidates) {
      OccupancyGrid grid = without(body, standing(body), CarryingBody.RADIUS, 0, body.next());
      for (Cell cell : Flood.from(grid, grid.cellAt(body.next()))) {
        Vec2 there = grid.centre(cell);
        if (isRoomy(body, there)
            && planner(grid, grid.cellAt(body.next()), cell)
                instanceof PlanResult.Found(Path path)) {
          drive(body, grid, path, Vec2.ZERO, there);
          body.goal = null;
          body.makesRoom = true;
          rightOfWay = rightOfWay.makesRoom(body.name);
          return;
        }
      }
    }
  }

  private boolean isRoomy(CarryingBody body, Vec2 there) {
    for (CarryingBody other : bodies) {
      Vec2 goal = other.goal;
      if (other != body
          && (other.position.distanceTo(there) < setup.nearest() + 1
              || (goal != null && goal.distanceTo(there) < setup.nearest() + 1))) {
        return false;
      }
    }
    return true;
  }

  // What is measured

  private void measure() {
    for (int i = 0; i < bodies.size(); i++) {
      for (int j = 0; j < i; j++) {
        nearest = Math.min(nearest, bodies.get(i).position.distanceTo(bodies.get(j).position));
      }
    }
    if (!isEachAtTarget()) {
      for (CarryingBody body : bodies) {
        if (body.isAlive && isWorker(body)) {
          switch (body.errand) {
            case NONE, SEARCH, LOOK, PARK -> idle += STEP;
            case WAIT -> waiting += STEP;
            case TO_BOX, WEIGH, TO_HELP, CARRY, SET_DOWN, TO_STATION, CHARGE -> {}
          }
        }
      }
    }
  }

  private boolean isWorker(CarryingBody body) {
    return !body.name.equals(SUPERVISOR);
  }

  private CarryingBody body(String name) {
    return bodies.stream().filter(body -> body.name.equals(name)).findFirst().orElseThrow();
  }

  /** To the middle of the cell that it is in. */
  private void toMiddle(CarryingBody body) {
    if (!body.isInMiddle() && body.path.isEmpty()) {
      body.path.add(scene.floor().centre(scene.floor().cellAt(body.position)));
    }
  }
}
