package org.toqa.app.bench;

import java.util.List;
import java.util.Locale;

/**
 * What each bench does not measure: nobody shall take its numbers for more than they are. The names
 * are those of the commands.
 */
enum LeftOut {
  SCEN(
      "Reading the map and the scenarios.",
      "Fitting a path with arcs, and driving it.",
      "Other robots: each query has the map to itself."),
  TRAFFIC(
      "The planner that drives a real floor: this is the one for steps on a grid.",
      "Bodies and their sizes: a robot is a cell, and every step takes equally long.",
      "Delays: no robot is ever late, lost or stopped.",
      "Tasks, their allocation, and the links to robots."),
  FLOOR(
      "The time that the server's computing takes: simulated time stands still meanwhile.",
      "Allocation: each robot has its next task as soon as it is free.",
      "The database: a change is stored after a fixed time, and nothing is kept.",
      "The daemon's process, its journal, its range sensors and its links: messages are delayed, never lost.",
      "Groups, robots of different sizes and speeds, obstacles, charging, holds and faults.",
      "Errors in heading: bodies are beside where robots report themselves, and face as they report."),
  MAPF(
      "Building the graph of the map, and reading files.",
      "Robots that turn: each moves to any of four neighbours, or waits.",
      "Driving: no robot is ever late, lost or stopped.",
      "Checking and writing the plan."),
  SMOOTH(
      "Reading the map and laying it out; of a scene, what is near each cell is found while planning.",
      "The exact length, which takes its own time.",
      "Velocities along the path, and driving it.",
      "Other robots and obstacles that move."),
  FLEET(
      "Networks: robots and server are one process on one machine.",
      "Groups: every load is light enough for one robot, and is no wider than it.",
      "Obstacles that the map does not show, and faults of robots.",
      "Browsers and other clients.",
      "The time of warming up; what happened then is not judged."),
  SOAK(
      "The logs of MySQL, where it is the database.",
      "Networks: robots and server are one process on one machine.",
      "Groups: every load is light enough for one robot, and is no wider than it.",
      "Faults of robots, people who hold or cancel, browsers and other clients.",
      "Days: history and tracks are pruned by the wall clock, which hardly goes on meanwhile."),
  TASKS(
      "Carrying the tasks out: they are accepted, stored and read back.",
      "Networks: clients and server are one process on one machine.",
      "Logging in, and the time of warming up.",
      "Limits of requests: they are off."),
  WEB(
      "The robot before its report: measuring and reckoning where it is, one tick of its daemon.",
      "After a frame is drawn: putting it on a screen; and the glide of the map to the new pose.",
      "More browsers than one: the others are programs that read and parse every event.",
      "Networks: clients, robots and server are one process on one machine.",
      "TLS, and limits of requests, which are off."),
  SMOOTHNESS(
      "A screen and a graphics card: Chromium has neither, and draws by the processor.",
      "After a frame is drawn: putting it on a screen.",
      "A machine for the browser alone: server, robots and Chromium share this one.",
      "People who pan, zoom or follow a robot."),
  STARTUP(
      "Unpacking the WAR, but for the very first start on a machine.",
      "MySQL: the database is H2, in an empty folder or with next to no data.",
      "Simulated robots: none are made.",
      "Building: ./toqa looks whether it must, before the process is started."),
  DAEMON(
      "A real chassis: the body is simulated within the daemon.",
      "A Raspberry Pi: it is measured on this machine.",
      "More than one follower."),
  HTTP(
      "Networks: robots and daemons are one process on one machine, and share its processors.",
      "TLS.",
      "The fleet: paths are given, and nothing is allocated, planned or stored by a server.",
      "Real wheels: bodies are simulated, and answer at once."),
  ALLOCATION(
      "Traffic: each robot drives as if it were alone.",
      "Charging, faults and robots that are lost.",
      "Loads for several robots.",
      "A measured consumption: joules follow from the model that the allocators optimise."),
  FORMATION(
      "The daemon's process, its timers and its links: messages are delayed, never lost.",
      "Motors and controllers of real wheels.",
      "The load: free says where robots were, by odometry, and knows nothing of it.",
      "Other robots.");

  @SuppressWarnings("ImmutableEnumChecker") // a copy
  private final List<String> sentences;

  LeftOut(String... sentences) {
    this.sentences = List.of(sentences);
  }

  /**
   * @param bench the name of its command
   * @throws IllegalArgumentException nobody has said what it leaves out
   */
  static LeftOut of(String bench) {
    return valueOf(bench.toUpperCase(Locale.ROOT));
  }

  List<String> sentences() {
    return sentences;
  }
}
