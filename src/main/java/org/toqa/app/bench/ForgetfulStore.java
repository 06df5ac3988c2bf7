package org.toqa.app.bench;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.ChargeRecord;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.Hold;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.StoredRobot;
import org.toqa.geometry.Pose;
import org.toqa.mission.TransportTask;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;

/** Accepts everything and keeps nothing: for fleets that nobody starts anew. */
final class ForgetfulStore implements FleetStore {

  @Override
  public List<StoredRobot> storedRobots() {
    return List.of();
  }

  @Override
  public Optional<Hold> pause() {
    return Optional.empty();
  }

  @Override
  public Map<String, Hold> floorHolds() {
    return Map.of();
  }

  @Override
  public Map<String, String> floorAllocators() {
    return Map.of();
  }

  @Override
  public List<OpenTask> openTasks() {
    return List.of();
  }

  @Override
  public List<OpenTask> tasksWithLeftLoads() {
    return List.of();
  }

  @Override
  public List<OpenTask> endedLegs() {
    return List.of();
  }

  @Override
  public Optional<StoredDrive> drive(String robot) {
    return Optional.empty();
  }

  @Override
  public List<TransportTask> addTasks(List<Submission> submissions) {
    return submissions.stream().map(Submission::task).toList();
  }

  @Override
  public void withdrawTasks(Collection<UUID> keys) {}

  @Override
  public void checkAvailable() {}

  @Override
  public void saveRobot(RobotRecord robot, List<EventRecord> events) {}

  @Override
  public boolean updateRobot(RobotRecord before, RobotRecord after, List<EventRecord> events) {
    return true;
  }

  @Override
  public void moveRobot(String robot, RobotMove move, double diameter, List<EventRecord> events) {}

  @Override
  public void removeRobot(String robot, List<EventRecord> events) {}

  @Override
  public void saveService(String robot, boolean inService, List<EventRecord> events) {}

  @Override
  public void saveGone(String robot, List<EventRecord> events) {}

  @Override
  public void saveToldLoad(String robot, double kilograms) {}

  @Override
  public void savePlace(String robot, Pose pose, double diameter, long drive) {}

  @Override
  public void saveLocated(String robot) {}

  @Override
  public void saveHold(String robot, boolean held, List<EventRecord> events) {}

  @Override
  public void saveCharge(ChargeRecord record, List<EventRecord> events) {}

  @Override
  public void savePause(@Nullable Hold pause, List<EventRecord> events) {}

  @Override
  public void saveFloorHold(String floor, @Nullable Hold hold, List<EventRecord> events) {}

  @Override
  public void saveFloorAllocator(
      String floor, @Nullable String allocator, List<EventRecord> events) {}

  @Override
  public void saveMissions(List<MissionChange> changes) {}

  @Override
  public boolean deleteTask(long task, EventRecord event) {
    return true;
  }

  @Override
  public void saveDrive(String robot, StoredDrive drive) {}

  @Override
  public void saveRoom(String robot, long seq, @Nullable PassingRoom room) {}

  @Override
  public void saveDriveEnd(String robot, long seq, int from, List<Segment> segments) {}

  @Override
  public void inOneTransaction(Runnable work) {
    work.run();
  }

  @Override
  public void saveExpectations(List<ExpectedDelivery> expectations) {}

  @Override
  public void addEvents(List<EventRecord> events) {}
}
