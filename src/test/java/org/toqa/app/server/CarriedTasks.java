package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.util.concurrent.TimeUnit;
import org.toqa.web.TestClient;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** One task after another that the fleet carries while something else is tried. */
final class CarriedTasks {
  private static final JsonMapper JSON = JsonMapper.shared();
  private static final long LIMIT_NANOS = TimeUnit.MINUTES.toNanos(4);

  private final TestClient client;
  private final String name;
  private final String csrf;
  private long task;
  private int done;

  /**
   * @param name of each task
   */
  CarriedTasks(TestClient client, String name) {
    this.client = client;
    this.name = name;
    this.csrf = client.csrf();
    order();
  }

  private void order() {
    String order =
        JSON.writeValueAsString(
            JSON.createObjectNode()
                .put("name", name)
                .put("load", 1)
                .put("priority", 50)
                .set("start", JSON.createObjectNode().put("station", "Goods-in 1"))
                .set("goal", JSON.createObjectNode().put("station", "Mill")));
    HttpResponse<String> answer = client.sendJson("POST", "api/v1/tasks", order, csrf);
    assertEquals(201, answer.statusCode(), answer.body());
    task = JSON.readTree(answer.body()).get("id").asLong();
  }

  /** Gives the next task where the one before is done. */
  void goOn() {
    JsonNode now = JSON.readTree(client.get("api/v1/tasks/" + task).body());
    String state = now.get("state").asString();
    assertTrue(!state.equals("FAILED") && !state.equals("CANCELLED"), now::toString);
    assertEquals(name, now.get("name").asString());
    if (state.equals("DONE")) {
      done++;
      order();
    }
  }

  /** Waits for the task that is under way. */
  int awaitDone() throws InterruptedException {
    long end = System.nanoTime() + LIMIT_NANOS;
    int before = done;
    while (done == before) {
      assertTrue(System.nanoTime() < end, this::situation);
      goOn();
      TimeUnit.MILLISECONDS.sleep(50);
    }
    return done;
  }

  /** What keeps it: itself, all robots, and what they work on. */
  private String situation() {
    return client.get("api/v1/tasks/" + task).body()
        + client.get("api/v1/robots").body()
        + client.get("api/v1/tasks?limit=10").body();
  }

  /**
   * Another task is not to be carried; where its load is on board already, it goes back, and where
   * it is nearly done, it may end.
   */
  void cancel(long other) {
    String path = "api/v1/tasks/" + other + "/cancel";
    int status = client.sendJson("POST", path, "{}", csrf).statusCode();
    if (status == 422) {
      status = client.sendJson("POST", path, "{\"load\":\"back\"}", csrf).statusCode();
    }
    assertTrue(status == 200 || status == 409, path + " answered " + status);
  }

  /** The one that is under way. */
  long task() {
    return task;
  }
}
