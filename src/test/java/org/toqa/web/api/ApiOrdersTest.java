package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.mission.TaskState;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;

/** Orders that are carried as several tasks, through the API. */
class ApiOrdersTest extends ApiTestServer {
  private static final String PIECES = GOOD_TASK.replace("\"load\"", "\"pieces\": 3, \"load\"");
  private static final String STOPS =
      """
      {"name": "Tour", "load": 1, "stops":
        [{"station": "Dock A"}, {"x": 10.35, "y": 1.05}, {"station": "Dock A"}]}
      """;

  private static final String TEMPLATE =
      """
      {"name": "Samples", "order": {"load": 2, "start": {"station": "Dock A"}, "priority": 5},
       "parameters": [{"name": "to", "field": "goal"}, {"name": "kg", "field": "load"},
         {"name": "until", "field": "deadline"}]}
      """;

  @Test
  void aTaskIsOrderedFromATemplateByWhatItAsksFor() {
    HttpResponse<String> made = post(token, "api/v1/templates", TEMPLATE);
    assertEquals(201, made.statusCode(), made.body());
    JsonNode parameters = JSON.readTree(made.body()).get("parameters");
    assertEquals(
        "PLACE true, NUMBER false",
        parameters.get(0).get("kind").stringValue()
            + " "
            + parameters.get(0).get("required")
            + ", "
            + parameters.get(1).get("kind").stringValue()
            + " "
            + parameters.get(1).get("required"));

    JsonNode task =
        JSON.readTree(
            ordered("{\"to\": {\"x\": 10.35, \"y\": 1.05}, \"until\": \"2099-01-01T00:00:00Z\"}")
                .body());
    assertEquals("Samples", task.get("name").stringValue());
    assertEquals("2.0 5", task.get("load") + " " + task.get("priority"));
    assertEquals("2099-01-01T00:00:00Z", task.get("deadline").stringValue());
    assertEquals(
        3.5,
        JSON.readTree(
                ordered(
                        "{\"to\": {\"station\": \"Dock A\"}, \"kg\": 3.5, \"until\": \"2099-01-01T00:00:00Z\"}")
                    .body())
            .get("load")
            .asDouble());

    assertEquals("values.to", faultOf(ordered("{\"until\": \"2099-01-01T00:00:00Z\"}")));
    assertEquals("values.from", faultOf(ordered("{\"from\": 1}")));
    String filled = "\"until\": \"2099-01-01T00:00:00Z\", \"to\": ";
    assertEquals("values.to", faultOf(ordered("{" + filled + "\"Dock A\"}")));
    assertEquals("values.to", faultOf(ordered("{" + filled + "{\"station\": \"Dock Z\"}}")));
    assertEquals(
        "values.kg", faultOf(ordered("{\"kg\": -1, " + filled + "{\"station\": \"Dock A\"}}")));
    assertEquals(
        "template",
        faultOf(post(token, "api/v1/tasks", "{\"template\": \"Sample\", \"values\": {}}")));
    assertEquals(
        "load", faultOf(post(token, "api/v1/tasks", "{\"template\": \"Samples\", \"load\": 1}")));
  }

  private HttpResponse<String> ordered(String values) {
    return post(
        token, "api/v1/tasks", "{\"template\": \"samples\", \"values\": %s}".formatted(values));
  }

  private static String faultOf(HttpResponse<String> answer) {
    assertEquals(422, answer.statusCode(), answer.body());
    return JSON.readTree(answer.body()).get("errors").get(0).get("field").stringValue();
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      value = {
        "name, `{'name': 'SAMPLES', 'order': {'load': 1}}`",
        "order.load, `{'name': 'T', 'order': {'start': {'station': 'Dock A'}, 'goal': {'station': 'Dock A'}}}`",
        "order.start, `{'name': 'T', 'order': {'load': 1, 'start': {'station': 'Gone'}, 'goal': {'station': 'Dock A'}}}`",
        "order.colour, `{'name': 'T', 'order': {'load': 1, 'colour': 1, 'start': {'station': 'Dock A'}, 'goal': {'station': 'Dock A'}}}`",
        "order.deadline, `{'name': 'T', 'order': {'kind': 'DRIVE', 'goal': {'station': 'Dock A'}, 'deadline': '2099-01-01T00:00:00Z'}}`",
        "order.floor, `{'name': 'T', 'order': {'kind': 'DRIVE', 'goal': {'station': 'Dock A'}, 'floor': 'attic'}}`",
        "parameters.1.name, `{'name': 'T', 'order': {'load': 1}, 'parameters': [{'name': 'a', 'field': 'start'}, {'name': 'A', 'field': 'goal'}]}`",
        "parameters.1.field, `{'name': 'T', 'order': {'load': 1}, 'parameters': [{'name': 'a', 'field': 'start'}, {'name': 'b', 'field': 'start'}]}`",
        "parameters.0.name, `{'name': 'T', 'order': {'load': 1}, 'parameters': [{'name': 'a b', 'field': 'start'}]}`",
        "parameters.0.field, `{'name': 'T', 'order': {'load': 1}, 'parameters': [{'name': 'a', 'field': 'floor'}]}`",
        "parameters.0.field, `{'name': 'T', 'order': {'load': 1, 'stops': [{'station': 'Dock A'}, {'station': 'Dock A'}]}, 'parameters': [{'name': 'a', 'field': 'stops.2'}]}`",
        "parameters.0.field, `{'name': 'T', 'order': {'kind': 'DRIVE', 'goal': {'station': 'Dock A'}}, 'parameters': [{'name': 'a', 'field': 'load'}]}`",
        "shared, `{'name': 'T', 'shared': 1, 'order': {'kind': 'DRIVE', 'goal': {'station': 'Dock A'}}}`"
      })
  void whatIsWrongWithATemplateIsNamed(String field, String template) {
    assertEquals(201, post(token, "api/v1/templates", TEMPLATE).statusCode());
    String sent =
        field.equals("name") ? TEMPLATE.replace("Samples", "SAMPLES") : template.replace('\'', '"');

    assertEquals(field, faultOf(post(token, "api/v1/templates", sent)));
  }

  @Test
  void aClerksTemplatesAreHisOwnUntilAManagerSharesThem() {
    String clerk = tokenOf(WebTestServer.CLERK);
    String path = "api/v1/templates/" + id(post(clerk, "api/v1/templates", TEMPLATE));
    String shared = TEMPLATE.replace("\"order\"", "\"shared\": true, \"order\"");
    assertEquals(
        "shared", faultOf(post(clerk, "api/v1/templates", shared.replace("Samples", "B"))));
    assertEquals(200, sendAs(clerk, "PUT", path, TEMPLATE.replace("5", "7")).statusCode());
    String other =
        "api/v1/templates/"
            + id(post(token, "api/v1/templates", TEMPLATE.replace("Samples", "Own")));
    assertEquals(404, sendAs(clerk, "GET", other, "").statusCode());
    assertEquals(404, sendAs(clerk, "DELETE", other, "").statusCode());
    assertEquals("template", faultOf(post(clerk, "api/v1/tasks", "{\"template\": \"Own\"}")));

    assertEquals(200, send("PUT", path, shared).statusCode());

    assertEquals(403, sendAs(clerk, "PUT", path, TEMPLATE).statusCode());
    assertEquals(403, sendAs(clerk, "DELETE", path, "").statusCode());
    assertEquals(1, JSON.readTree(sendAs(clerk, "GET", "api/v1/templates", "").body()).size());
    assertEquals(2, JSON.readTree(get("api/v1/templates").body()).size());
    assertEquals(204, send("DELETE", path, "").statusCode());
    assertEquals(404, get(path).statusCode());
  }

  @Test
  void aScheduleGoesAlongWithItsTemplateAndKeepsItFromBeingDeleted() {
    String template =
        TEMPLATE
            .replace(", {\"name\": \"kg\", \"field\": \"load\"},", "")
            .replaceFirst("(?s)\\s*\\{\"name\": \"until\"[^}]*}", "");
    String path = "api/v1/templates/" + id(post(token, "api/v1/templates", template));
    String wish =
        """
        {"task": {"template": "Samples", "values": {"to": {"x": 10.35, "y": 1.05}}},
         "weekdays": ["MONDAY"], "time": "08:00", "zone": "UTC"}
        """;
    HttpResponse<String> added = post(token, "api/v1/schedules", wish);
    assertEquals(201, added.statusCode(), added.body());
    String schedule = "api/v1/schedules/" + id(added);
    assertEquals("Samples", JSON.readTree(get(schedule).body()).get("template").stringValue());
    assertEquals(
        "task.values.to",
        faultOf(
            post(
                token,
                "api/v1/schedules",
                wish.replace("\"to\"", "\"from\"")
                    .replace("from", "to")
                    .replace("10.35", "\"a\""))));

    HttpResponse<String> refused = send("DELETE", path, "");
    assertEquals(409, refused.statusCode());
    assertEquals(
        "The template “Samples” is used by schedules: 1. Delete them first.",
        JSON.readTree(refused.body()).get("detail").stringValue());
    assertEquals(
        200, send("PUT", path, template.replace("\"load\": 2", "\"load\": 4")).statusCode());
    assertEquals(4, JSON.readTree(get(schedule).body()).at("/task/load").asDouble());
    HttpResponse<String> unfit = send("PUT", path, template.replace("\"to\"", "\"towards\""));
    assertEquals(422, unfit.statusCode());
    assertTrue(unfit.body().contains("Schedule 1 uses this template"), unfit.body());
    assertEquals(204, send("DELETE", schedule, "").statusCode());
    assertEquals(204, send("DELETE", path, "").statusCode());
    assertTrue(get("api/v1/history?kind=template").body().contains("deleted the template Samples"));
  }

  @Test
  void whoReplacesWhatAnotherHasReplacedIsTold() {
    HttpResponse<String> made = post(token, "api/v1/templates", TEMPLATE);
    String path = "api/v1/templates/" + id(made);
    String seen = made.headers().firstValue("ETag").orElseThrow();
    assertEquals(200, send("PUT", path, TEMPLATE).statusCode());

    HttpResponse<String> late =
        visitor.send(
            visitor
                .request(path)
                .header("Authorization", "Bearer " + token)
                .header("Content-Type", "application/json")
                .header("If-Match", seen)
                .method("PUT", BodyPublishers.ofString(TEMPLATE))
                .build());

    assertEquals(412, late.statusCode());
  }

  private HttpResponse<String> sendAs(String bearer, String method, String path, String body) {
    return visitor.send(
        visitor
            .request(path)
            .header("Authorization", "Bearer " + bearer)
            .header("Content-Type", "application/json")
            .method(method, BodyPublishers.ofString(body))
            .build());
  }

  @Test
  void aTableHasAColumnForATemplateAndOneForEachOfItsParameters() {
    post(token, "api/v1/templates", TEMPLATE);
    HttpResponse<String> imported =
        table(
            """
            template,name,load,start,to,toX,toY,KG,until,goal
            Samples,,,,Dock A,,,3.5,2099-01-01 08:00,
            ,Box,1,Dock A,,,,,,Dock A
            samples,,,,,10.35,1.05,,2099-01-01 08:00,
            """);
    assertEquals(201, imported.statusCode(), imported.body());
    assertEquals(3.5, JSON.readTree(imported.body()).get(0).get("load").asDouble());

    HttpResponse<String> faulty =
        table(
            """
            template,name,load,to,kg,until
            Sample,,,,,
            Samples,,2,Dock A,a,2099-01-01 08:00
            Samples,,,Dock Z,1,2099-01-01 08:00
            ,Box,1,Dock A,,
            """);
    assertEquals(422, faulty.statusCode());
    assertEquals(
        "2 template, 3 load, 3 kg, 4 to, 5 to, 5 start, 5 goal",
        JSON.readTree(faulty.body())
            .get("errors")
            .valueStream()
            .map(fault -> fault.get("line") + " " + fault.get("field").stringValue())
            .collect(Collectors.joining(", ")));
  }

  private HttpResponse<String> table(String table) {
    return visitor.send(
        visitor
            .request("api/v1/tasks/import")
            .header("Authorization", "Bearer " + token)
            .header("Content-Type", "text/csv")
            .POST(BodyPublishers.ofString(table))
            .build());
  }

  @Test
  void anOrderOfPiecesIsStoredWholeAndShowsOneProgress() {
    HttpResponse<String> answer = post(token, "api/v1/orders", PIECES);

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode order = JSON.readTree(answer.body());
    String path = "api/v1/orders/" + order.get("id").asLong();
    assertEquals("/" + path, answer.headers().firstValue("Location").orElseThrow());
    assertEquals("PIECES QUEUED 0 of 3", summary(order));
    assertEquals(3, order.get("tasks").size());
    JsonNode second = JSON.readTree(get("api/v1/tasks/2").body()).get("order");
    assertEquals("2 of 3", second.get("part") + " of " + second.get("parts"));
    assertTrue(JSON.readTree(get("api/v1/tasks/" + add(token)).body()).get("order").isNull());

    server.fleet().changeTask(1, TaskState.RETURNING, List.of("r1"), "It is there.");
    assertEquals("PIECES IN_PROGRESS 1 of 3", summary(JSON.readTree(get(path).body())));
    JsonNode listed = JSON.readTree(get("api/v1/orders").body()).get(0);
    assertEquals("PIECES IN_PROGRESS 1 of 3", summary(listed));
    assertFalse(listed.has("tasks"));
    for (long task = 1; task <= 3; task++) {
      server.fleet().changeTask(task, TaskState.DONE, List.of("r1"), "r1 has parked.");
    }
    assertEquals("PIECES DONE 3 of 3", summary(JSON.readTree(get(path).body())));
  }

  @Test
  void aCancelledLegStopsTheRestUntilItIsOrderedAgain() {
    JsonNode order = JSON.readTree(post(token, "api/v1/orders", STOPS).body());
    assertEquals("STOPS QUEUED 0 of 2", summary(order));
    String path = "api/v1/orders/" + order.get("id").asLong();
    assertEquals(409, post(token, path + "/retry", "").statusCode());
    server.fleet().changeTask(1, TaskState.CANCELLED, List.of(), "It was cancelled.");

    JsonNode stopped = JSON.readTree(get(path).body());
    assertEquals("STOPS STOPPED 0 of 2", summary(stopped));
    assertEquals(2, stopped.get("stuck").get(0).get("task").asInt());
    assertTrue(
        stopped.get("stuck").get(0).get("why").stringValue().contains("ended without delivery"));

    JsonNode again = JSON.readTree(post(token, path + "/retry", "").body());

    assertEquals("STOPS QUEUED 0 of 2", summary(again));
    assertEquals(
        "3 2", again.get("tasks").get(0).get("id") + " " + again.get("tasks").get(1).get("id"));
    assertEquals(409, post(token, path + "/retry", "").statusCode());
  }

  @Test
  void anOrderIsCancelledByWhoseItIsAndAsksWhereLoadsOnBoardGo() {
    String clerk = tokenOf(WebTestServer.CLERK);
    String others = "api/v1/orders/" + id(post(token, "api/v1/orders", PIECES));
    assertEquals(403, post(clerk, others + "/cancel", "").statusCode());
    assertEquals(403, post(clerk, others + "/retry", "").statusCode());
    assertEquals(404, post(token, "api/v1/orders/999/cancel", "").statusCode());
    String own = "api/v1/orders/" + id(post(clerk, "api/v1/orders", PIECES));
    server.fleet().changeTask(4, TaskState.DONE, List.of("r1"), "r1 has parked.");
    server.fleet().changeTask(6, TaskState.CARRYING, List.of("r1"), "r1 carries it.");

    HttpResponse<String> asked = post(clerk, own + "/cancel", "");
    assertEquals(409, asked.statusCode());
    assertEquals(
        "[\"here\",\"back\"]", JSON.readTree(asked.body()).at("/needs/answers").toString());
    assertEquals("PIECES IN_PROGRESS 1 of 3", summary(JSON.readTree(get(own).body())));
    assertEquals(422, post(clerk, own + "/cancel", "{\"load\":\"away\"}").statusCode());

    HttpResponse<String> cancelled = post(clerk, own + "/cancel", "{\"load\":\"here\"}");
    assertEquals(200, cancelled.statusCode(), cancelled.body());
    assertEquals(
        TaskState.CANCELLED, server.fleet().task(5).orElseThrow().state(), "it was not begun");
    assertEquals(200, post(token, others + "/cancel", "").statusCode());
    assertEquals("PIECES CANCELLED 0 of 3", summary(JSON.readTree(get(others).body())));
  }

  @Test
  void allOfAnOrderIsHeldAndGoesOnAndIsGivenAPriorityAtOnce() {
    String clerk = tokenOf(WebTestServer.CLERK);
    String others = "api/v1/orders/" + id(post(token, "api/v1/orders", PIECES));
    for (String command : List.of("/hold", "/resume", "/priority")) {
      assertEquals(403, post(clerk, others + command, "{\"priority\":1}").statusCode(), command);
      assertEquals(
          404, post(token, "api/v1/orders/999" + command, "{\"priority\":1}").statusCode());
    }
    String own = "api/v1/orders/" + id(post(clerk, "api/v1/orders", PIECES));
    server.fleet().changeTask(4, TaskState.DONE, List.of("r1"), "r1 has parked.");
    server.fleet().changeTask(5, TaskState.CARRYING, List.of("r1"), "r1 carries it.");

    JsonNode held = JSON.readTree(post(clerk, own + "/hold", "").body());
    assertEquals("2 of 3 on hold", held.get("held") + " of " + held.get("parts") + " on hold");
    assertTrue(server.fleet().task(5).orElseThrow().held());
    assertFalse(server.fleet().task(4).orElseThrow().held(), "it has ended");
    assertFalse(server.fleet().task(1).orElseThrow().held(), "it is of another order");

    HttpResponse<String> first = post(clerk, own + "/priority", "{\"priority\":10}");
    assertEquals(200, first.statusCode(), first.body());
    assertEquals(10, server.fleet().task(6).orElseThrow().task().priority());
    assertEquals(0, server.fleet().task(4).orElseThrow().task().priority());
    assertEquals(422, post(clerk, own + "/priority", "{\"priority\":101}").statusCode());
    assertEquals(422, post(clerk, own + "/priority", "{\"rank\":1}").statusCode());

    assertEquals(0, JSON.readTree(post(clerk, own + "/resume", "").body()).get("held").asInt());
    assertFalse(server.fleet().task(6).orElseThrow().held());
    server.fleet().changeTask(5, TaskState.DONE, List.of("r1"), "r1 has parked.");
    server.fleet().changeTask(6, TaskState.DONE, List.of("r1"), "r1 has parked.");
    assertEquals(409, post(clerk, own + "/hold", "").statusCode());
  }

  @Test
  void anOrderIsHeldAndCancelledAlsoWhileItCannotBeRead() {
    String clerk = tokenOf(WebTestServer.CLERK);
    String others = "api/v1/orders/" + id(post(token, "api/v1/orders", PIECES));
    String own = "api/v1/orders/" + id(post(clerk, "api/v1/orders", PIECES));
    server.fleet().changeTask(4, TaskState.TO_OBJECT, List.of("r1"), "r1 set out.");
    server.fleet().setOrdersReadable(false);

    assertEquals(503, post(clerk, own + "/hold", "").statusCode());
    assertEquals(503, post(clerk, others + "/hold", "").statusCode());
    for (long task = 4; task <= 6; task++) {
      assertTrue(server.fleet().task(task).orElseThrow().held(), task + " goes on");
    }
    assertFalse(server.fleet().task(1).orElseThrow().held(), "it is not his");

    assertEquals(503, post(clerk, own + "/cancel", "").statusCode());
    assertEquals(TaskState.TO_OBJECT, server.fleet().task(4).orElseThrow().state());
    assertEquals(TaskState.QUEUED, server.fleet().task(5).orElseThrow().state());

    assertEquals(503, post(clerk, own + "/cancel", "{\"load\":\"here\"}").statusCode());
    for (long task = 4; task <= 6; task++) {
      assertEquals(TaskState.CANCELLED, server.fleet().task(task).orElseThrow().state());
    }
    assertEquals(TaskState.QUEUED, server.fleet().task(1).orElseThrow().state());
  }

  @Test
  void anOrderThatComesAgainWithItsKeyIsThereOnce() {
    JsonNode first = JSON.readTree(withKey(PIECES).body());
    JsonNode again = JSON.readTree(withKey(PIECES).body());

    assertEquals(first.get("id"), again.get("id"));
    assertEquals(3, server.fleet().count());
    assertEquals(422, withKey(STOPS).statusCode());
    assertEquals(422, withKey(PIECES.replace("3,", "2,")).statusCode());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"pieces\":0,\"start\":{\"station\":\"Dock A\"},\"goal\":{\"x\":10.35,\"y\":1.05}|pieces",
        "\"pieces\":101,\"start\":{\"station\":\"Dock A\"},\"goal\":{\"x\":10.35,\"y\":1.05}|pieces",
        "\"pieces\":1.5,\"start\":{\"station\":\"Dock A\"},\"goal\":{\"x\":10.35,\"y\":1.05}|pieces",
        "\"pieces\":2,\"start\":{\"station\":\"Dock A\"}|goal",
        "\"stops\":[{\"station\":\"Dock A\"}]|stops",
        "\"stops\":\"Dock A\"|stops",
        "\"stops\":[1,2]|stops",
        "\"stops\":[{\"station\":\"Dock A\"},{\"x\":1}]|stops.1.y",
        "\"stops\":[{\"station\":\"Dock A\"},{\"station\":\"Nowhere\"}]|stops.1",
        "\"stops\":[{\"station\":\"Dock A\"},{\"x\":10.35,\"y\":1.05}],\"pieces\":2|pieces",
        "\"stops\":[{\"station\":\"Dock A\"},{\"x\":10.35,\"y\":1.05}],\"goal\":null|goal"
      })
  void whatIsWrongIsToldUnderItsField(String places, String field) {
    HttpResponse<String> answer =
        post(token, "api/v1/orders", "{\"name\":\"x\",\"load\":1," + places + "}");

    assertEquals(422, answer.statusCode(), answer.body());
    assertEquals(
        field, JSON.readTree(answer.body()).get("errors").get(0).get("field").stringValue());
    assertEquals(0, server.fleet().count());
  }

  private HttpResponse<String> withKey(String order) {
    return visitor.send(
        visitor
            .request("api/v1/orders")
            .header("Authorization", "Bearer " + token)
            .header("Content-Type", "application/json")
            .header("Idempotency-Key", "k1")
            .POST(BodyPublishers.ofString(order))
            .build());
  }

  private static long id(HttpResponse<String> answer) {
    return JSON.readTree(answer.body()).get("id").asLong();
  }

  private static String summary(JsonNode order) {
    return "%s %s %s of %s"
        .formatted(
            order.get("kind").stringValue(),
            order.get("state").stringValue(),
            order.get("delivered"),
            order.get("parts"));
  }
}
