package org.toqa.traffic.lifelong;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import org.toqa.grid.Cell;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RandomFloors;
import org.toqa.traffic.RandomFloors.Floor;

/** What holds for every planner; {@link Drive} has the checker look at each plan. */
@Tag("full")
class LifelongPlannerPropertyTest {

  /** Names a planner in a report, and makes one. */
  enum Planner {
    ROLLING {
      @Override
      LifelongPlanner make(MotionModel model) {
        return new RollingHorizonPlanner(model, true, 7);
      }
    },
    ROLLING_WITHOUT_RINGS {
      @Override
      LifelongPlanner make(MotionModel model) {
        return new RollingHorizonPlanner(model, false, 7);
      }
    },
    RESERVATION {
      @Override
      LifelongPlanner make(MotionModel model) {
        return new ReservationPlanner(model);
      }
    };

    abstract LifelongPlanner make(MotionModel model);
  }

  @Provide
  Arbitrary<Floor> crowded() {
    return RandomFloors.strewn(7, 0.4, 30);
  }

  @Provide
  Arbitrary<Floor> roomy() {
    return Arbitraries.longs().withoutEdgeCases().map(seed -> RandomFloors.roomy(new Random(seed)));
  }

  @Property(tries = 38)
  void plansHoldTogetherWhateverTheGoals(
      @ForAll("crowded") Floor floor,
      @ForAll Planner planner,
      @ForAll MotionModel model,
      @ForAll Random random) {
    Drive drive = drive(floor, planner, model);
    for (int step = 0; step < 30; step++) {
      drive.step();
      drive.headFor(random.nextInt(floor.goals().size()), any(floor.goals(), random));
    }
  }

  @Property(tries = 38)
  void plansHoldTogetherThoughRobotsAreLate(
      @ForAll("crowded") Floor floor,
      @ForAll Planner planner,
      @ForAll MotionModel model,
      @ForAll Random random) {
    Drive drive = drive(floor, planner, model);
    for (int step = 0; step < 30; step++) {
      LifelongPlan plan = drive.plan();
      for (int robot = 0; robot < floor.starts().size(); robot++) {
        if (random.nextInt(4) > 0 && isClear(drive, floor, plan.path(robot).at(1), robot)) {
          drive.obey(robot, plan);
        }
      }
    }
  }

  @Property(tries = 8)
  void plansHoldTogetherThoughTheTimeIsUp(
      @ForAll("crowded") Floor floor, @ForAll Planner planner, @ForAll MotionModel model) {
    Drive drive = drive(floor, planner, model);
    for (int asked = 0; asked < 40; asked++) {
      AtomicLong ticks = new AtomicLong();
      drive.plan(new Deadline(ticks::getAndIncrement, asked));
      drive.step();
    }
  }

  @Property(tries = 25)
  void whereThereIsRoomEverybodyArrives(
      @ForAll("roomy") Floor floor, @ForAll MotionModel model, @ForAll boolean mayRotate) {
    new Drive(
            floor.grid(),
            model,
            new RollingHorizonPlanner(model, mayRotate, 7),
            floor.starts(),
            floor.goals())
        .untilArrived(1000);
  }

  @Property(tries = 13)
  void theSameCallsGiveTheSamePlans(
      @ForAll("crowded") Floor floor, @ForAll Planner planner, @ForAll MotionModel model) {
    assertEquals(drivenPlaces(floor, planner, model), drivenPlaces(floor, planner, model));
  }

  @Property(tries = 2)
  void nobodyStarvesWhileOthersGetGoalAfterGoal(
      @ForAll("roomy") Floor floor, @ForAll MotionModel model, @ForAll Random random) {
    Drive drive =
        new Drive(
            floor.grid(),
            model,
            new RollingHorizonPlanner(model, true, 7),
            floor.starts(),
            floor.goals());
    List<Integer> waits = new ArrayList<>(floor.starts().stream().map(start -> 0).toList());
    for (int step = 0; step < 400; step++) {
      drive.step();
      for (int robot = 0; robot < waits.size(); robot++) {
        boolean isArrived = drive.isArrived(robot);
        waits.set(robot, isArrived ? 0 : waits.get(robot) + 1);
        assertTrue(waits.get(robot) < 350, "robot " + robot + " waits in vain");
        if (isArrived) {
          drive.headFor(robot, any(floor.goals(), random));
        }
      }
    }
  }

  private static List<GridPose> drivenPlaces(Floor floor, Planner planner, MotionModel model) {
    Drive drive = drive(floor, planner, model);
    List<GridPose> places = new ArrayList<>();
    for (int step = 0; step < 20; step++) {
      drive.step();
      for (int robot = 0; robot < floor.starts().size(); robot++) {
        places.add(drive.stance(robot));
      }
    }
    return places;
  }

  private static Drive drive(Floor floor, Planner planner, MotionModel model) {
    return new Drive(floor.grid(), model, planner.make(model), floor.starts(), floor.goals());
  }

  private static Cell any(List<Cell> cells, Random random) {
    return cells.get(random.nextInt(cells.size()));
  }

  /** Whether no other robot is there at this moment, moved already or not. */
  private static boolean isClear(Drive drive, Floor floor, GridPose stance, int robot) {
    return Stream.iterate(0, other -> other + 1)
        .limit(floor.starts().size())
        .noneMatch(o -> o != robot && drive.stance(o).cell().equals(stance.cell()));
  }
}
