package org.toqa.cooperation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.IntStream;
import org.toqa.cooperation.CarryCommand.AskForWorker;
import org.toqa.cooperation.CarryCommand.Carry;
import org.toqa.cooperation.CarryCommand.Charge;
import org.toqa.cooperation.CarryCommand.GoToBox;
import org.toqa.cooperation.CarryCommand.Park;
import org.toqa.cooperation.CarryCommand.Search;
import org.toqa.cooperation.CarryCommand.Wait;
import org.toqa.cooperation.CarryEvent.BoxDelivered;
import org.toqa.cooperation.CarryEvent.BoxSeen;
import org.toqa.cooperation.CarryEvent.BoxSetDown;
import org.toqa.cooperation.CarryEvent.BoxUnreachable;
import org.toqa.cooperation.CarryEvent.BoxWeighed;
import org.toqa.cooperation.CarryEvent.MapGrown;
import org.toqa.cooperation.CarryEvent.RobotCharged;
import org.toqa.cooperation.CarryEvent.RobotParked;
import org.toqa.cooperation.CarryEvent.RobotReported;
import org.toqa.cooperation.CarryEvent.SecondArrived;
import org.toqa.cooperation.CarryEvent.StoreSeen;
import org.toqa.cooperation.CarryEvent.WorkerBack;
import org.toqa.cooperation.CarryEvent.WorkerLost;
import org.toqa.cooperation.KnownBox.Stage;
import org.toqa.cooperation.KnownRobot.Activity;

/**
 * The cycle of CMCT: after each event the supervisor looks at its own battery first, then at those
 * of its workers, then gives out boxes that it has found, and searches on.
 *
 * <ol>
 *   <li>A supervisor whose battery is low goes to charge and orders nothing new until it is
 *       charged; what was ordered goes on.
 *   <li>A worker that is low charges before it takes another box, also one that waits beside a box.
 *       A station takes one robot; who finds none free waits where it is.
 *   <li>A worker that is free helps the one that waits beside a heavy box; else it goes to the
 *       nearest box that is found. Where two wait for each other, the later one helps.
 *   <li>Meanwhile the supervisor searches on, unless the rules have it wait for its workers.
 * </ol>
 *
 * <p>Without a supervisor the same holds but for step 1, each worker goes to the nearest box that
 * it has seen itself and that no other goes for, and searches while it has none (as in CMOMMT:
 * Parker, 2002).
 *
 * <p>Nothing depends on what the supervisor remembers: one that starts anew hears from its workers
 * what they hold, and sees boxes, delivered ones too, again.
 */
public final class SupervisorCycle {
  private final CarryRules rules;
  private final List<CarryCommand> commands = new ArrayList<>();
  private CarryState state;

  /** What comes of an event. */
  public record Step(CarryState state, List<CarryCommand> commands) {
    public Step {
      commands = List.copyOf(commands);
    }
  }

  private SupervisorCycle(CarryRules rules, CarryState state) {
    this.rules = rules;
    this.state = state;
  }

  /** The state and the commands that follow from an event. */
  public static Step next(CarryRules rules, CarryState state, CarryEvent event) {
    SupervisorCycle cycle = new SupervisorCycle(rules, state);
    cycle.accept(event);
    cycle.order();
    return new Step(cycle.state, cycle.commands);
  }

  private void accept(CarryEvent event) {
    switch (event) {
      case BoxSeen seen -> see(seen);
      case MapGrown _ -> tryUnreachable();
      case StoreSeen seen -> {
        state = state.seenAll(seen.by());
        tryUnreachable();
        if (state.robot(seen.by()).activity() == Activity.SEARCHING) {
          doing(seen.by(), Activity.IDLE);
        }
      }
      case RobotReported report -> {
        KnownRobot robot = state.robot(report.robot());
        set(
            report.robot(),
            new KnownRobot(
                robot.activity(),
                robot.box(),
                report.position(),
                report.battery(),
                report.workSeconds()));
        if (report.station() != null && !state.occupied().containsKey(report.station())) {
          state = state.leaving(report.robot()).occupying(report.station(), report.robot());
        }
      }
      case BoxWeighed weighed -> weigh(weighed);
      case SecondArrived arrived -> carryTogether(arrived.worker());
      case BoxDelivered delivered -> {
        free(delivered.box());
        set(delivered.box(), state.box(delivered.box()).at(Stage.DELIVERED));
      }
      case BoxSetDown down -> {
        free(down.box());
        set(down.box(), state.box(down.box()).at(Stage.FOUND, down.place()));
      }
      case BoxUnreachable unreachable -> {
        KnownRobot worker = state.robot(unreachable.worker());
        if (worker.activity() == Activity.TO_BOX && worker.box() != null) {
          set(worker.box(), state.box(worker.box()).at(Stage.UNREACHABLE));
          doing(unreachable.worker(), Activity.IDLE);
        }
      }
      case RobotCharged charged -> doing(charged.robot(), Activity.IDLE);
      case RobotParked parked -> {
        if (state.robot(parked.robot()).activity() == Activity.PARKING) {
          doing(parked.robot(), Activity.IDLE);
        }
      }
      case WorkerLost lost -> lose(lost.worker());
      case WorkerBack back -> welcome(back);
    }
  }

  private void see(BoxSeen seen) {
    KnownBox known = state.boxes().get(seen.box());
    if (known == null || known.stage() == Stage.MISSING) {
      Stage stage = seen.isAtTarget() ? Stage.DELIVERED : Stage.FOUND;
      boolean isHeavy = known != null && known.isHeavy();
      set(seen.box(), new KnownBox(stage, Set.of(seen.by()), seen.place(), isHeavy));
    } else {
      set(seen.box(), known.alsoSeenBy(seen.by()));
    }
  }

  private void tryUnreachable() {
    for (Map.Entry<Integer, KnownBox> box : state.boxes().entrySet()) {
      if (box.getValue().stage() == Stage.UNREACHABLE) {
        set(box.getKey(), box.getValue().at(Stage.FOUND));
      }
    }
  }

  private void weigh(BoxWeighed weighed) {
    KnownRobot worker = state.robot(weighed.worker());
    Integer box = worker.box();
    if (worker.activity() != Activity.TO_BOX || box == null) {
      return;
    }
    if (weighed.kilograms() <= rules.loadThreshold()) {
      carry(List.of(weighed.worker()), box);
    } else {
      boolean othersWait =
          state.boxes().values().stream().anyMatch(b -> b.stage() == Stage.NEEDS_SECOND);
      set(box, state.box(box).weighedHeavy());
      if (othersWait) { // they would wait for each other
        set(box, state.box(box).at(Stage.FOUND));
        doing(weighed.worker(), Activity.IDLE);
      } else {
        set(weighed.worker(), worker.doing(Activity.WAITING, box));
      }
    }
  }

  private void carryTogether(String second) {
    KnownRobot helper = state.robot(second);
    Integer box = helper.box();
    if (helper.activity() != Activity.TO_HELP || box == null) {
      return;
    }
    Optional<String> first =
        state.workers().stream()
            .filter(w -> state.robot(w).isAbout(box))
            .filter(w -> state.robot(w).activity() == Activity.WAITING)
            .findFirst();
    if (first.isPresent()) {
      carry(List.of(first.get(), second), box);
    }
  }

  private void carry(List<String> workers, int box) {
    set(box, state.box(box).at(Stage.CARRIED));
    workers.forEach(w -> set(w, state.robot(w).doing(Activity.CARRYING, box)));
    commands.add(new Carry(workers, box));
  }

  /** All that are about a box are about it no longer. */
  private void free(int box) {
    for (String worker : state.workers()) {
      if (state.robot(worker).isAbout(box)) {
        doing(worker, Activity.IDLE);
      }
    }
  }

  private void lose(String name) {
    KnownRobot worker = state.robot(name);
    state = state.leaving(name);
    set(name, worker.doing(Activity.LOST));
    Integer box = worker.box();
    if (box == null) {
      return;
    }
    switch (worker.activity()) {
      case TO_BOX -> set(box, state.box(box).at(Stage.FOUND));
      case WAITING -> leave(box);
      case CARRYING -> set(box, state.box(box).at(Stage.MISSING));
      default -> {} // who is helped goes on waiting
    }
  }

  /** Nobody waits beside a box any more; who came to help is the first one now. */
  private void leave(int box) {
    set(box, state.box(box).at(Stage.FOUND));
    for (String worker : state.workers()) {
      KnownRobot helper = state.robot(worker);
      if (helper.isAbout(box) && helper.activity() == Activity.TO_HELP) {
        set(box, state.box(box).at(Stage.ALLOCATED));
        set(worker, helper.doing(Activity.TO_BOX, box));
        commands.add(new GoToBox(worker, box, false));
      }
    }
  }

  private void welcome(WorkerBack back) {
    KnownRobot worker = state.robot(back.worker());
    Integer held = back.held();
    if (held == null) {
      if (worker.activity() == Activity.LOST) {
        doing(back.worker(), Activity.IDLE);
      }
      return;
    }
    String partner = back.partner();
    for (String other : state.workers()) { // who was sent for it where it lay
      if (!other.equals(back.worker())
          && !other.equals(partner)
          && state.robot(other).isAbout(held)) {
        doing(other, Activity.IDLE);
        commands.add(new Wait(other));
      }
    }
    KnownBox known = state.boxes().get(held);
    set(
        held,
        new KnownBox(
            Stage.CARRIED,
            Set.of(back.worker()),
            worker.position(),
            partner != null || (known != null && known.isHeavy())));
    set(back.worker(), worker.doing(Activity.CARRYING, held));
    if (partner == null) {
      commands.add(new Carry(List.of(back.worker()), held));
    } else if (state.robot(partner).activity() == Activity.CARRYING) {
      commands.add(new Carry(List.of(partner, back.worker()), held));
    }
  }

  /** Steps 1 to 5. */
  private void order() {
    if (state.supervisor() != null && isAway(state.supervisor())) {
      return;
    }
    state.workers().forEach(this::chargeIfLow);
    callSecond();
    while (sendToNearest()) {
      // until no worker is free, or no box found
    }
    askForWorkers();
    state.workers().forEach(this::parkIfAtStation);
    searchMissing();
    state.searchers().forEach(this::search);
  }

  /** Whether the supervisor charges, or must. */
  private boolean isAway(String supervisor) {
    if (state.robot(supervisor).activity() == Activity.CHARGING) {
      return true;
    }
    if (!isLow(state.robot(supervisor))) {
      return false;
    }
    state.workers().forEach(this::parkIfAtStation);
    if (!charge(supervisor) && state.robot(supervisor).activity() == Activity.SEARCHING) {
      doing(supervisor, Activity.IDLE);
      commands.add(new Wait(supervisor));
    }
    return true;
  }

  private void chargeIfLow(String name) {
    KnownRobot worker = state.robot(name);
    if (!isLow(worker) || !(worker.isFree() || worker.activity() == Activity.WAITING)) {
      return;
    }
    if (charge(name) && worker.box() != null) {
      leave(worker.box());
    }
  }

  private boolean isLow(KnownRobot robot) {
    return rules.isLow(robot.battery(), robot.workSeconds());
  }

  /** Whether there is a station for it. */
  private boolean charge(String name) {
    KnownRobot robot = state.robot(name);
    OptionalInt nearest =
        IntStream.range(0, state.stations().size())
            .filter(i -> !state.occupied().containsKey(i) || name.equals(state.occupied().get(i)))
            .boxed()
            .min(
                Comparator.comparingDouble(
                    i -> state.stations().get(i).distanceTo(robot.position())))
            .map(OptionalInt::of)
            .orElse(OptionalInt.empty());
    if (nearest.isEmpty()) {
      return false;
    }
    state = state.leaving(name).occupying(nearest.getAsInt(), name);
    set(name, robot.doing(Activity.CHARGING));
    commands.add(new Charge(name, nearest.getAsInt()));
    return true;
  }

  private void callSecond() {
    for (Map.Entry<Integer, KnownBox> box : state.boxes().entrySet()) {
      int number = box.getKey();
      boolean isHelped =
          state.robots().values().stream()
              .anyMatch(r -> r.isAbout(number) && r.activity() == Activity.TO_HELP);
      if (box.getValue().stage() == Stage.NEEDS_SECOND && !isHelped) {
        state.workers().stream()
            .filter(this::takesWork)
            .min(Comparator.comparingDouble(w -> distance(w, box.getValue())))
            .ifPresent(
                w -> {
                  state = state.leaving(w);
                  set(w, state.robot(w).doing(Activity.TO_HELP, number));
                  commands.add(new GoToBox(w, number, true));
                });
      }
    }
  }

  /** A worker and a box, of all that are free the nearest to each other. */
  private boolean sendToNearest() {
    String worker = null;
    int nearest = 0;
    double least = Double.POSITIVE_INFINITY;
    for (String name : state.workers().stream().filter(this::takesWork).toList()) {
      for (Map.Entry<Integer, KnownBox> box : state.boxes().entrySet()) {
        boolean isTaken = !isToFetch(name, box.getValue());
        double distance = isTaken ? Double.POSITIVE_INFINITY : distance(name, box.getValue());
        if (distance < least) {
          worker = name;
          nearest = box.getKey();
          least = distance;
        }
      }
    }
    if (worker == null) {
      return false;
    }
    state = state.leaving(worker);
    set(nearest, state.box(nearest).at(Stage.ALLOCATED));
    set(worker, state.robot(worker).doing(Activity.TO_BOX, nearest));
    commands.add(new GoToBox(worker, nearest, false));
    return true;
  }

  private boolean isToFetch(String worker, KnownBox box) {
    return box.stage() == Stage.FOUND
        && !lacksSecond(box)
        && (state.supervisor() != null || box.seenBy().contains(worker));
  }

  private boolean takesWork(String name) {
    KnownRobot worker = state.robot(name);
    return worker.isFree() && !isLow(worker);
  }

  /** Whether a box that is known to be heavy would find one worker only. */
  private boolean lacksSecond(KnownBox box) {
    boolean othersWait =
        state.boxes().values().stream().anyMatch(b -> b.stage() == Stage.NEEDS_SECOND);
    return box.isHeavy() && (othersWait || aliveWorkers() < 2);
  }

  private long aliveWorkers() {
    return state.workers().stream().filter(w -> state.robot(w).activity() != Activity.LOST).count();
  }

  private void askForWorkers() {
    if (aliveWorkers() >= 2) {
      return;
    }
    for (Map.Entry<Integer, KnownBox> box : state.boxes().entrySet()) {
      Stage stage = box.getValue().stage();
      boolean lacks = box.getValue().isHeavy() && stage != Stage.DELIVERED;
      if (lacks && !state.asked().contains(box.getKey())) {
        state = state.askedFor(box.getKey());
        commands.add(new AskForWorker(box.getKey()));
      }
    }
  }

  private void parkIfAtStation(String name) {
    KnownRobot worker = state.robot(name);
    boolean isAtStation = state.occupied().containsValue(name);
    if (worker.activity() == Activity.IDLE && isAtStation && !isLow(worker)) {
      state = state.leaving(name);
      set(name, worker.doing(Activity.PARKING));
      commands.add(new Park(name));
    }
  }

  /** A box that is not where it was is looked for everywhere. */
  private void searchMissing() {
    boolean isMissing =
        state.boxes().values().stream().anyMatch(box -> box.stage() == Stage.MISSING);
    if (!isMissing) {
      return;
    }
    for (String name : state.searchers()) {
      if (state.haveSeenAll().contains(name) && takesWork(name)) {
        state = state.seenNothing().leaving(name);
        doing(name, Activity.SEARCHING);
        commands.add(new Search(name, true));
      }
    }
  }

  private void search(String name) {
    KnownRobot robot = state.robot(name);
    boolean isIdle = state.workers().stream().noneMatch(w -> state.robot(w).box() != null);
    boolean mustSearch =
        !state.haveSeenAll().contains(name)
            && (rules.overlaps() || isIdle || state.supervisor() == null);
    if (mustSearch && robot.activity() == Activity.IDLE && !isLow(robot)) {
      state = state.leaving(name);
      doing(name, Activity.SEARCHING);
      commands.add(new Search(name, false));
    } else if (!mustSearch && robot.activity() == Activity.SEARCHING) {
      doing(name, Activity.IDLE);
      commands.add(new Wait(name));
    }
  }

  private double distance(String worker, KnownBox box) {
    return state.robot(worker).position().distanceTo(box.place());
  }

  private void doing(String robot, Activity activity) {
    set(robot, state.robot(robot).doing(activity));
  }

  private void set(String name, KnownRobot robot) {
    state = state.with(name, robot);
  }

  private void set(int number, KnownBox box) {
    state = state.with(number, box);
  }
}
