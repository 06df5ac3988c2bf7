package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.fleet.RobotState;
import org.toqa.geometry.Pose;
import org.toqa.testbed.Hall;
import org.toqa.web.WebServerTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Devices of the network, on their page and by the API. */
class NetworkPageTest extends WebServerTest {
  private static final JsonMapper JSON = new JsonMapper();
  private static final String HARDWARE = "02:00:5e:10:00:0a";

  @BeforeEach
  void addRobot() throws IOException {
    server.forgetWork();
    server
        .fleet()
        .setRobots(Hall.robot("r1", RobotState.IDLE, new Pose(1.05, 0.75, 0), "10.0.7.30", 7275));
    Files.writeString(server.leases(), "0 02:00:5e:10:00:0b 10.0.7.110 spare *\n");
  }

  private long add(String name, String kind, String hardware, String address) {
    HttpResponse<String> answer =
        manager.post(
            "network",
            Map.of("name", name, "kind", kind, "hardwareAddress", hardware, "address", address));
    assertEquals(303, answer.statusCode(), answer::body);
    return devices()
        .valueStream()
        .filter(device -> device.path("name").asString("").equals(name))
        .findFirst()
        .orElseThrow()
        .get("id")
        .asLong();
  }

  private JsonNode devices() {
    return JSON.readTree(clerk.get("api/v1/network").body()).get("devices");
  }

  @Test
  void robotsAndUnknownDevicesAreShownToEverybodyAndChangedByManagers() {
    String page = clerk.get("network").body();

    assertTrue(page.contains("10.0.7.30"), page);
    assertTrue(page.contains("02:00:5e:10:00:0b"), page);
    assertFalse(page.contains("???"), page);
    assertFalse(page.contains("Add a device"), "it is for managers");
    assertTrue(
        manager.get("network").body().contains("/robots?name=spare&amp;host=10.0.7.110#add"));
    assertTrue(
        manager.get("robots?name=spare&host=10.0.7.110").body().contains("value=\"10.0.7.110\""));
    assertEquals(403, clerk.post("network", Map.of()).statusCode());
  }

  @Test
  void reservationIsWrittenForTheDhcpServerChangedAndRemoved() throws IOException {
    long id = add("r1", "robot", HARDWARE, "10.0.7.30");
    assertTrue(Files.readString(server.reservations()).endsWith(HARDWARE + ",10.0.7.30\n"));
    assertTrue(manager.get("network").body().contains("reserved"));
    assertTrue(manager.get("network?edit=" + id).body().contains("value=\"" + HARDWARE + "\""));

    Map<String, String> changed =
        Map.of("name", "r1", "kind", "robot", "hardwareAddress", HARDWARE, "address", "10.0.7.31");
    assertEquals(303, manager.post("network/" + id + "/change", changed).statusCode());
    assertTrue(Files.readString(server.reservations()).endsWith(HARDWARE + ",10.0.7.31\n"));
    assertTrue(
        manager.get("network").body().contains("10.0.7.31 is reserved for it"),
        "its robot is asked at the old one");

    assertEquals(303, manager.post("network/" + id + "/delete", Map.of()).statusCode());
    assertFalse(Files.readString(server.reservations()).contains(HARDWARE));
    assertEquals(404, manager.post("network/" + id + "/delete", Map.of()).statusCode());
    assertEquals(
        "[\"network.device-removed\",\"network.device-changed\",\"network.device-added\"]",
        JSON.writeValueAsString(
            JSON.readTree(manager.get("api/v1/history?kind=network").body())
                .get("events")
                .findValuesAsString("kind")));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "new  | camera | 02:00:5e:10:00:0f | 10.0.8.1   | address         | The DHCP server serves",
        "new  | camera | 02:00:5e:10:00:0f | 10.0.7.255 | address         | The DHCP server serves",
        "new  | camera | 02:00:5e:10:00:0f | 10.0.7.110 | address         | has that address now",
        "new  | camera | 02:00:5e:10:00:0f | 10.0.7.30  | address         | The robot r1 is asked",
        "new  | camera | 02:00:5e:10:00:0f | 127.0.0.1  | address         | IPv4 address of a device",
        "new  | camera | ff:ff:ff:ff:ff:ff | 10.0.7.21  | hardwareAddress | not of a group",
        "gate | camera | 02:00:5e:10:00:0f | 10.0.7.21  | name            | choose another name",
        "new  | camera | 02:00:5e:10:00:0a | 10.0.7.21  | hardwareAddress | has that hardware",
        "new  | camera | 02:00:5e:10:00:0f | 10.0.7.20  | address         | choose another one",
        "new  | toy    | 02:00:5e:10:00:0f | 10.0.7.21  | kind            | Choose robot",
        "a b  | camera | 02:00:5e:10:00:0f | 10.0.7.21  | name            | begins with a letter"
      })
  void whatClashesIsRefusedWithASentence(
      String name, String kind, String hardware, String address, String field, String sentence) {
    add("gate", "camera", HARDWARE, "10.0.7.20");
    Map<String, String> order =
        Map.of("name", name, "kind", kind, "hardwareAddress", hardware, "address", address);

    HttpResponse<String> page = manager.post("network", order);
    assertEquals(422, page.statusCode());
    assertTrue(page.body().contains(sentence), page.body());
    HttpResponse<String> problem =
        manager.postJson("api/v1/network/devices", JSON.writeValueAsString(order));
    assertEquals(422, problem.statusCode());
    assertTrue(problem.body().contains("\"" + field + "\""), problem.body());
    assertTrue(problem.body().contains(sentence), problem.body());
    assertEquals(3, devices().size(), "r1, gate and who has the lease");
  }

  @Test
  void leasesThatCannotBeReadAreTold() throws IOException {
    Files.delete(server.leases());

    assertTrue(clerk.get("network").body().contains("The leases could not be read"));
    assertTrue(
        JSON.readTree(clerk.get("api/v1/network").body())
            .at("/dhcp/trouble")
            .asString("")
            .contains("dhcp.leases"));
  }
}
