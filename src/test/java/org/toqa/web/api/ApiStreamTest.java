package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Scanner;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.RobotState;
import org.toqa.geometry.Pose;
import org.toqa.testbed.Hall;
import tools.jackson.databind.JsonNode;

/** The stream of snapshots that the API sends. */
class ApiStreamTest extends ApiTestServer {
  @Test
  void theStreamTellsWhatIsInTheWay() {
    server.fleet().changeFloor(Hall.crowdedFloor());
    HttpResponse<InputStream> stream =
        visitor.send(
            visitor.request("api/v1/events").header("Authorization", "Bearer " + token).build(),
            BodyHandlers.ofInputStream());

    try (Scanner lines = new Scanner(stream.body(), StandardCharsets.UTF_8)) {
      JsonNode floor = JSON.readTree(after("data: ", lines)).get("floors").get(0);
      assertEquals("hall", floor.get("floor").stringValue());
      assertEquals("[375,2,415,2]", floor.get("obstacles").toString());
      assertEquals(
          "{\"robot\":\"r6\",\"cells\":[490,2,530,2]}", floor.get("kept").get(0).toString());
      JsonNode standstill = floor.get("standstills").get(0);
      assertEquals("[\"r2\",\"r3\"]", standstill.get("robots").toString());
      assertEquals(2.25, standstill.get("where").get(0).get("x").doubleValue());
      assertTrue(standstill.get("text").stringValue().contains("are blocking each other"));
      JsonNode charger = floor.get("faultyChargers").get(0);
      assertEquals("C1", charger.get("name").stringValue());
      assertEquals(10.95, charger.get("where").get("x").doubleValue());
      assertEquals(4, floor.get("chargerShortage").get("needed").intValue());
    }
  }

  @Test
  void theStreamBringsEachNewSnapshot() {
    HttpResponse<InputStream> stream =
        visitor.send(
            visitor.request("api/v1/events").header("Authorization", "Bearer " + token).build(),
            BodyHandlers.ofInputStream());
    assertEquals(
        "text/event-stream;charset=UTF-8",
        stream.headers().firstValue("Content-Type").orElseThrow());

    try (Scanner lines = new Scanner(stream.body(), StandardCharsets.UTF_8)) {
      long first = version(lines);
      server
          .fleet()
          .changeRobots(
              robots ->
                  List.of(
                      Hall.robot("r1", RobotState.DRIVING, new Pose(2, 2, 0), "127.0.0.1", 7275)));
      long second = version(lines);
      assertEquals(first + 1, second);
      JsonNode snapshot = JSON.readTree(after("data: ", lines));
      assertEquals(second, snapshot.get("version").asLong());
      assertEquals("DRIVING", snapshot.get("robots").get(0).get("state").stringValue());
      assertTrue(snapshot.get("tasks").isArray());
    }
  }

  private static long version(Scanner lines) {
    String id = after("id: ", lines);
    return Long.parseLong(id.substring(id.lastIndexOf('-') + 1));
  }

  private static String after(String prefix, Scanner lines) {
    String line = lines.nextLine();
    while (!line.startsWith(prefix)) {
      line = lines.nextLine();
    }
    return line.substring(prefix.length());
  }
}
